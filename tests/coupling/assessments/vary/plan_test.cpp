#include "coupling/assessments/vary/study/plan.hpp"

#include <gtest/gtest.h>

#include <sstream>

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

}  // namespace
}  // namespace coupling::vary
