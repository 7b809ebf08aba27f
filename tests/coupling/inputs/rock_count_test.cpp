#include "coupling/inputs/rock_count.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::plausible::rock_count_test {
namespace {

TEST(FewRocks, AreWarnedOfWithTheirUncertainty) {
    config::Warnings warnings;
    warn_of_few_rocks(25, warnings);
    ASSERT_EQ(warnings.all().size(), 1U);
    // 1.96 sqrt(0.25 / 25) = 0.196
    EXPECT_EQ(
        warnings.all()[0],
        "only 25 rocks are released in all: a share of 50 % is uncertain by 20 percentage points either "
        "way; raise release.rocks or release.rocks_per_source");
}

TEST(FewRocks, AreFewerThanAHundred) {
    config::Warnings warnings;
    warn_of_few_rocks(100, warnings);
    warn_of_few_rocks(0, warnings);
    EXPECT_TRUE(warnings.all().empty());
    warn_of_few_rocks(99, warnings);
    EXPECT_EQ(warnings.all().size(), 1U);
}

TEST(OddSizes, AreWarnedOf) {
    config::Warnings warnings;
    warn_of_odd_sizes({0.5, 2.0}, warnings);
    EXPECT_TRUE(warnings.all().empty());
    warn_of_odd_sizes({0.012, 12.0}, warnings);
    ASSERT_EQ(warnings.all().size(), 2U);
    EXPECT_EQ(warnings.all()[1],
              "the largest rocks have a diameter of 12 m: check the units of their sizes (m, t, m3)");
    // 200 litres that were written as 200 m3 make a sphere of 7.3 m.
    config::Warnings litres;
    warn_of_odd_sizes({0.5, std::cbrt(6.0 * 200.0 / M_PI)}, litres);
    ASSERT_EQ(litres.all().size(), 1U);
    EXPECT_NE(litres.all()[0].find("a diameter of 7.256 m"), std::string::npos) << litres.all()[0];
}

}  // namespace
}  // namespace coupling::plausible::rock_count_test
