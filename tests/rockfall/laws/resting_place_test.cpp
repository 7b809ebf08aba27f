#include "rockfall/laws/resting_place.hpp"

#include <gtest/gtest.h>

namespace rockfall::resting_place_test {
namespace {

constexpr double radius_m = 0.5;
const Eigen::Vector3d here{10.0, 20.0, 500.0};

TEST(RestingPlace, HoldsARockAfterMoreThanSixteenImpactsWithinItsRadius) {
    RestingPlace place{radius_m};
    for (int impact = 0; impact < 16; ++impact) {
        EXPECT_FALSE(place.holds(here + 0.02 * impact * Eigen::Vector3d::UnitX())) << impact;
        place.add_impact();
    }
    EXPECT_FALSE(place.holds(here));
    place.add_impact();
    EXPECT_TRUE(place.holds(here));
}

TEST(RestingPlace, HoldsARockThatRollsForMoreThanTenSecondsWithinItsRadius) {
    RestingPlace place{radius_m};
    EXPECT_FALSE(place.holds(here));
    for (int second = 0; second < 10; ++second) {
        place.add_rolling(1.0);
    }
    EXPECT_FALSE(place.holds(here));
    place.add_rolling(0.1);
    EXPECT_TRUE(place.holds(here));
}

TEST(RestingPlace, HoldsARockThatGetsNowhereInPiecesOfNoLength) {
    RestingPlace place{radius_m};
    EXPECT_FALSE(place.holds(here));
    int pieces = 0;
    while (!place.holds(here) && pieces < 10'000) {
        place.add_rolling(0.0);
        ++pieces;
    }
    EXPECT_NEAR(pieces, 10.0 / shortest_rolling_piece_s, 2.0);
}

TEST(RestingPlace, BeginsToCountAgainWhereTheRockHasLeftItsRadius) {
    RestingPlace place{radius_m};
    EXPECT_FALSE(place.holds(here));
    for (int impact = 0; impact < 17; ++impact) {
        place.add_impact();
    }
    place.add_rolling(20.0);
    const Eigen::Vector3d away = here + 0.51 * Eigen::Vector3d::UnitY();
    EXPECT_FALSE(place.holds(away));
    EXPECT_FALSE(place.holds(here + 0.2 * Eigen::Vector3d::UnitY()));
    RestingPlace stays{radius_m};
    EXPECT_FALSE(stays.holds(here));
    for (int impact = 0; impact < 17; ++impact) {
        stays.add_impact();
    }
    EXPECT_TRUE(stays.holds(here + 0.49 * Eigen::Vector3d::UnitY()));
}

}  // namespace
}  // namespace rockfall::resting_place_test
