#include "coupling/results/figures/line_places.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdint>

namespace coupling::line_places_test {
namespace {

/// 100 m east, 50 m north, and a second part of 30 m further on.
const rockfall::Target road{
    "road", "Road", false, true, {{{0.0, 0.0}, {100.0, 0.0}, {100.0, 50.0}}, {{200.0, 50.0}, {230.0, 50.0}}}};

TEST(LinePlaces, CountDistancesAlongAllParts) {
    const LinePlaces places{road};
    EXPECT_DOUBLE_EQ(places.length_m(), 180.0);
    EXPECT_DOUBLE_EQ(places.distance_of({40.0, 7.0}), 40.0);
    EXPECT_DOUBLE_EQ(places.distance_of({103.0, 20.0}), 120.0);
    EXPECT_DOUBLE_EQ(places.distance_of({210.0, 60.0}), 160.0);
    EXPECT_DOUBLE_EQ(places.distance_of({-9.0, -9.0}), 0.0);
    EXPECT_DOUBLE_EQ(places.distance_of({400.0, 50.0}), 180.0);
}

TEST(LinePlaces, FindAPointAgainByItsDistance) {
    const LinePlaces places{road};
    rc::check([&](std::uint16_t draw) {
        const double distance_m = 180.0 * draw / 65535.0;
        RC_ASSERT(std::abs(places.distance_of(places.at(distance_m)) - distance_m) < 1e-9);
    });
}

}  // namespace
}  // namespace coupling::line_places_test
