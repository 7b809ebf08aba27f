#include "coupling/assessments/vary/study/plan.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"

namespace coupling::vary {
namespace {

config::Table table(const std::string& rows) {
    std::istringstream in{"setting,values,how\n" + rows};
    return config::Table::read(in, "factors.csv");
}

TEST(Combinations, AreTheScenarioThenSinglesThenAllCrossed) {
    const std::vector<Factor> factors =
        read_factors(table("a.x,1 2,alone\nb.y,3 4 5,crossed\nc.z,yes no,crossed\n"));
    const std::vector<Combination> all = combinations_of(factors);
    ASSERT_EQ(all.size(), 1U + 2U + 3U * 2U);
    EXPECT_TRUE(all[0].overrides(factors).empty());
    EXPECT_EQ(all[2].overrides(factors), (std::vector<std::string>{"a.x=2"}));
    EXPECT_EQ(all[2].alone, "a.x");
    EXPECT_EQ(all[4].overrides(factors), (std::vector<std::string>{"b.y=3", "c.z=no"}));
    EXPECT_EQ(all[8].overrides(factors), (std::vector<std::string>{"b.y=5", "c.z=no"}));
    EXPECT_EQ(all[8].alone, "");
}

TEST(Combinations, WithoutCrossedOnesAreNotRunTwice) {
    EXPECT_EQ(combinations_of(read_factors(table("a.x,1 2,alone\n"))).size(), 3U);
}

TEST(Combinations, TakeListsAsValues) {
    const std::vector<Factor> factors =
        read_factors(table("release.diameter_shares,60 30 10|30 40 30,alone\n"
                           "run.seed,2 3,alone\nstands.dead_wood, a b.csv | c.csv ,alone\n"));
    EXPECT_EQ(factors[0].values, (std::vector<std::string>{"60 30 10", "30 40 30"}));
    EXPECT_EQ(factors[1].values, (std::vector<std::string>{"2", "3"}));
    EXPECT_EQ(factors[2].values, (std::vector<std::string>{"a b.csv", "c.csv"}));
}

TEST(Combinations, RefuseAnEmptyValueBetweenBars) {
    for (const char* values : {"1 2||3", "|1", "1|", "|"}) {
        EXPECT_THROW(read_factors(table(config::joined("a.x,", values, ",alone\n"))), config::InputError)
            << values;
    }
}

}  // namespace
}  // namespace coupling::vary
