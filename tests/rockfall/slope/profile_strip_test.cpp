#include "rockfall/slope/profile_strip.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "rockfall/terrain/contact_zone.hpp"
#include "tests/rockfall/slopes.hpp"
#include "tests/rockfall/terrain/profiles.hpp"

namespace rockfall::profile_strip_test {
namespace {

using testing::even_profile;
using testing::ground;
using testing::height_on;
using testing::random_profile;

constexpr double no_limit = std::numeric_limits<double>::infinity();

RC_GTEST_PROP(ProfileStrip, HasTheHeightsOfTheProfileEverywhere, ()) {
    const auto profile = random_profile(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000)));
    const Slope slope = strip_slope(profile, {ground({0.3, 0.8}), ground({0.35, 0.9})});
    const double length_m = profile.back().distance_m - profile.front().distance_m;
    for (int i = 0; i <= 1000; ++i) {
        const double x_m =
            std::min(profile.front().distance_m + length_m * i / 1000.0, profile.back().distance_m);
        for (const double y_m : {-10.0, -3.7, 0.0, 9.9}) {
            const auto height_m = slope.terrain.height_m(x_m, y_m);
            RC_ASSERT(height_m.has_value());
            RC_ASSERT(std::abs(*height_m - height_on(profile, x_m)) < 1e-6);
        }
    }
    for (const double outside_m : {profile.front().distance_m - 1e-3, profile.back().distance_m + 1e-3}) {
        RC_ASSERT(!slope.terrain.height_m(outside_m, 0.0).has_value());
    }
}

RC_GTEST_PROP(ProfileStrip, HasTrianglesThatKnowTheirNeighbours, ()) {
    const auto profile = random_profile(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000)));
    const Slope slope = strip_slope(profile, {ground({0.3, 0.8}), ground({0.35, 0.9})});
    const auto triangles = slope.terrain.triangles();
    const auto vertices = slope.terrain.vertices();
    std::size_t borders = 0;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const Vertex& a = vertices[t.corners[0]];
        const Vertex& b = vertices[t.corners[1]];
        const Vertex& c = vertices[t.corners[2]];
        RC_ASSERT((b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m) > 0.0);
        RC_ASSERT(slope.terrain.plane_of(i).gradient.y() == 0.0);
        for (int k = 0; k < 3; ++k) {
            if (t.neighbours[k] == no_triangle) {
                ++borders;
                continue;
            }
            // The same edge, run the other way, leads back.
            const Triangle& other = triangles[t.neighbours[k]];
            bool leads_back = false;
            for (int m = 0; m < 3; ++m) {
                leads_back =
                    leads_back || (other.neighbours[m] == i && other.corners[m] == t.corners[(k + 1) % 3] &&
                                   other.corners[(m + 1) % 3] == t.corners[k]);
            }
            RC_ASSERT(leads_back);
        }
    }
    RC_ASSERT(triangles.size() == 2 * (profile.size() - 1));
    RC_ASSERT(borders == triangles.size() + 2);
}

RC_GTEST_PROP(ProfileStrip, HasBordersOfGroundTypesWithinACell, ()) {
    const auto profile = random_profile(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000)));
    const Slope slope = strip_slope(profile, {ground({0.3, 0.8}), ground({0.35, 0.9})});
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
        const double from_m = profile[k].distance_m + profile_surface_cell_m;
        const double to_m = profile[k + 1].distance_m - profile_surface_cell_m;
        for (const double x_m : {from_m, 0.5 * (from_m + to_m), to_m}) {
            if (from_m < to_m) {
                RC_ASSERT(static_cast<std::uint8_t>(slope.surface.at(x_m, 0.0)) == profile[k].surface);
            }
        }
    }
}

ContactLaw within(double radius_m, double largest_shift_m) {
    return {.given_radius_m = radius_m, .largest_shift_m = largest_shift_m};
}

TEST(ContactZoneOfAProfile, ReturnsTheProfileWithoutSupport) {
    const auto profile = random_profile(4);
    const auto felt = contact_zone(profile, within(0.0, 1.0));
    ASSERT_EQ(felt.size(), profile.size());
    for (std::size_t i = 0; i < profile.size(); ++i) {
        EXPECT_EQ(felt[i].distance_m, profile[i].distance_m);
        EXPECT_EQ(felt[i].height_m, profile[i].height_m);
        EXPECT_EQ(felt[i].surface, profile[i].surface);
    }
}

TEST(ContactZoneOfAProfile, LeavesPlanesAsTheyAre) {
    const auto profile = even_profile(38.0, 300.0);
    for (const double support_m : {0.4, 2.0, 4.0, 9.5}) {
        for (const ProfilePoint& point : contact_zone(profile, within(support_m, no_limit))) {
            EXPECT_NEAR(point.height_m, height_on(profile, point.distance_m), 1e-9);
        }
    }
}

TEST(ContactZoneOfAProfile, TakesTheNoiseOutOfASampledProfile) {
    for (const double step_m : {0.5, 2.0, 5.0}) {
        std::vector<ProfilePoint> profile;
        for (std::uint64_t i = 0; i < 400; ++i) {
            const config::RandomStream stream{{41, 0, 0, i}, config::Purpose::test};
            const double noise_m = 0.2 * config::normal(stream.uniforms_of(0)[0], 0.0, 1.0);
            profile.push_back({step_m * static_cast<double>(i), noise_m, 0});
        }
        const ContactLaw law{.least_radius_m = 0.5};
        const auto slope_of = [](std::span<const ProfilePoint> points) {
            double squares = 0.0;
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                const double length_m = points[i + 1].distance_m - points[i].distance_m;
                const double rise_m = points[i + 1].height_m - points[i].height_m;
                squares += rise_m * rise_m / length_m;
            }
            return std::sqrt(squares / points.back().distance_m);
        };
        // 400 correlated points: the mean square is known to about a fifth. The linear pieces between two
        // points of 2 m and more are smoothed, too.
        EXPECT_LT(slope_of(contact_zone(profile, law)), 1.3 * law.slope_error) << step_m;
        EXPECT_GT(slope_of(profile), 2.0 * law.slope_error) << step_m;
    }
}

RC_GTEST_PROP(ContactZoneOfAProfile, KeepsCornersAndGroundTypesAndItsLimit, ()) {
    const auto profile = random_profile(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000)));
    const auto felt = contact_zone(profile, within(4.0, 1.0));
    std::size_t corner = 0;
    for (std::size_t i = 0; i < felt.size(); ++i) {
        if (i > 0) {
            const double step_m = felt[i].distance_m - felt[i - 1].distance_m;
            RC_ASSERT(step_m > 0.0);
            RC_ASSERT(step_m < 1.0 + 1e-9);
        }
        if (corner + 1 < profile.size() && felt[i].distance_m >= profile[corner + 1].distance_m) {
            ++corner;
            RC_ASSERT(felt[i].distance_m == profile[corner].distance_m);
        }
        RC_ASSERT(felt[i].surface == profile[corner].surface);
        RC_ASSERT(std::abs(felt[i].height_m - height_on(profile, felt[i].distance_m)) < 1.0 + 1e-6);
    }
    RC_ASSERT(corner + 1 == profile.size());
}

TEST(ContactZoneOfAProfile, IsThatOfTheSlopeInTheMiddleOfTheStrip) {
    // A step of 0.5 m, seen by the same zone on a grid of 1 m.
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= 40; ++i) {
        profile.push_back({1.0 * i, i < 20 ? 10.0 : 9.5, 0});
    }
    const config::GridFrame frame{41, 15, -0.5, -7.5, 1.0, 1.0};
    const auto grid =
        contact_zone(testing::heights_of(frame, [](double x, double) { return x < 19.5 ? 10.0 : 9.5; }),
                     within(4.0, 1.0), HeightNoise{});
    const auto felt = contact_zone(profile, within(4.0, 1.0));
    for (int i = 0; i <= 40; ++i) {
        EXPECT_NEAR(felt[static_cast<std::size_t>(i)].height_m, grid.at({i, 7}), 1e-9) << i;
    }
}

}  // namespace
}  // namespace rockfall::profile_strip_test
