#include "coupling/results/few_rocks.hpp"

#include <gtest/gtest.h>

namespace coupling::few_rocks_test {
namespace {

TEST(TooFewForProtection, AsksOnlyForArrivalsOverTheBareSlope) {
    EXPECT_TRUE(too_few_for_protection({.both = 1, .only_forest = 100, .only_bare = 3}));
    EXPECT_FALSE(too_few_for_protection({.both = 0, .only_forest = 0, .only_bare = 5}));
}

TEST(TooFewInWords, CountsTheRocks) {
    EXPECT_EQ(too_few_in_words(0), "no rock arrives over the bare slope: too few for a protection figure");
    EXPECT_EQ(too_few_in_words(1),
              "only 1 rock arrives over the bare slope: too few for a protection figure");
    EXPECT_EQ(too_few_in_words(2),
              "only 2 rocks arrive over the bare slope: too few for a protection figure");
}

}  // namespace
}  // namespace coupling::few_rocks_test
