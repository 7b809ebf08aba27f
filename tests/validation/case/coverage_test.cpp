#include "validation/engine/case/coverage.hpp"

#include <gtest/gtest.h>

namespace coupling::validation::coverage_test {
namespace {

VerdictRow observed_row(const std::string& quantity, double observed, double simulated) {
    VerdictRow row;
    row.quantity = quantity;
    row.observed = observed;
    row.default_value.value = simulated;
    return row;
}

VerdictRow published_row(const std::string& quantity, double published, double simulated) {
    VerdictRow row = observed_row(quantity, published, simulated);
    std::swap(row.observed, row.published);
    return row;
}

TEST(Coverage, TellsTheChanceOfRocksFromAllThatIsNotKnown) {
    // Deviation 1 by rocks: half width 1.645. Draws 8, 10, 12: variance 4, together sqrt(5) * 1.645 = 3.68.
    const std::vector<std::map<std::string, double>> draws{
        {{"near", 8.0}, {"far", 8.0}, {"beyond", 8.0}, {"unknown", 8.0}},
        {{"near", 10.0}, {"far", 10.0}, {"beyond", 10.0}, {"unknown", 10.0}},
        {{"near", 12.0}, {"far", 12.0}, {"beyond", 12.0}, {"unknown", 12.0}}};
    const std::vector<Coverage> coverage =
        coverage_of({observed_row("near", 11.5, 10.0), observed_row("far", 13.5, 10.0),
                     observed_row("beyond", 14.0, 10.0), observed_row("unknown", 10.0, 10.0),
                     published_row("near", 20.0, 10.0)},
                    {{"near", 1.0}, {"far", 1.0}, {"beyond", 1.0}}, draws);
    ASSERT_EQ(coverage.size(), 4U);
    EXPECT_NEAR(coverage[0].of_rocks, 1.645, 1e-3);
    EXPECT_NEAR(coverage[0].of_all, 3.678, 1e-3);
    EXPECT_TRUE(coverage[0].in_rocks && coverage[0].in_all);
    EXPECT_TRUE(!coverage[1].in_rocks && coverage[1].in_all);
    EXPECT_TRUE(!coverage[2].in_rocks && !coverage[2].in_all);
    EXPECT_EQ(
        in_words(coverage),
        "1 of 4 known figures (3 observed, the others published) inside 90 % of rocks alone, 2 inside 90 % "
        "of all that is not known");
}

TEST(Coverage, HasAsManyDrawsAsItSays) {
    EXPECT_EQ(draws_for({}, {rockfall::SurfaceType{}}, 1).size(), coverage_draws);
}

}  // namespace
}  // namespace coupling::validation::coverage_test
