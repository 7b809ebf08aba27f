#include "coupling/inputs/plausible/rock_count.hpp"

#include <gtest/gtest.h>

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
}

}  // namespace
}  // namespace coupling::plausible::rock_count_test
