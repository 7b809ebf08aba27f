#include "validation/engine/slope/rebuild.hpp"

#include <gtest/gtest.h>

#include "tests/validation/case_texts.hpp"
#include "validation/engine/kinds/validation_case.hpp"
#include "validation/engine/slope/falls.hpp"

namespace coupling::validation::rebuild_test {
namespace {

using testing::even_slope;

RebuiltSlope rebuilt(const ValidationCase& of, const std::vector<std::string>& overrides = {}) {
    const auto recipe = of.recipe("strict", overrides);
    return rebuild(*recipe, of.profile(*recipe));
}

double ground_m(const RebuiltSlope& slope, double distance_m, double across_m) {
    const Eigen::Vector2d place = slope.on_terrain(distance_m, across_m);
    return slope.slope.terrain.height_m(place.x(), place.y()).value();
}

TEST(Rebuild, IsExactOnAPlane) {
    const RebuiltSlope slope = rebuilt(read_case(even_slope()));
    for (const double distance_m : {-9.0, 0.0, 0.3, 77.7, 299.0, 309.0}) {
        for (const double across_m : {-59.0, 0.0, 3.3, 59.0}) {
            EXPECT_NEAR(ground_m(slope, distance_m, across_m), height_at(slope.profile, distance_m), 1e-6)
                << distance_m << ", " << across_m;
        }
    }
}

TEST(Rebuild, HasTheCrossSectionOfAChannel) {
    const RebuiltSlope slope = rebuilt(
        read_case(even_slope("slope", "[terrain]\nchannel_depth_m = 3\nchannel_half_width_m = 15\n")));
    const double axis_m = ground_m(slope, 100.0, 0.0);
    EXPECT_NEAR(axis_m, height_at(slope.profile, 100.0), 1e-9);
    EXPECT_NEAR(ground_m(slope, 100.0, 7.5) - axis_m, 0.75, 1e-9);  // on a node: y = 3 cells
    EXPECT_NEAR(ground_m(slope, 100.0, -30.0) - axis_m, 3.0, 1e-9);
}

TEST(Rebuild, DrawsTheSameReliefFromTheSameSeed) {
    const ValidationCase of = read_case(even_slope("slope", "[terrain]\nrelief_m = 0.2\n"));
    const RebuiltSlope first = rebuilt(of);
    const RebuiltSlope again = rebuilt(of);
    const RebuiltSlope other = rebuilt(of, {"terrain.relief_seed=2"});
    EXPECT_EQ(ground_m(first, 100.0, 5.0), ground_m(again, 100.0, 5.0));
    EXPECT_NE(ground_m(first, 100.0, 5.0), ground_m(other, 100.0, 5.0));
    EXPECT_LT(std::abs(ground_m(first, 100.0, 5.0) - height_at(first.profile, 100.0)), 1.0);
}

TEST(Rebuild, PutsSurfacesWhereTheProfileHasThem) {
    CaseFiles files = even_slope();
    files.texts["profile.csv"] = "length_m,slope_deg,surface\n150,38,fine_debris\n150,38,coarse_debris\n";
    const RebuiltSlope slope = rebuilt(read_case(files), {"surfaces.rt_change=0.05"});
    const auto tangential = [&](double distance_m) {
        const Eigen::Vector2d place = slope.on_terrain(distance_m, -20.0);
        return slope.slope.type_at(place.x(), place.y()).as_published().tangential;
    };
    EXPECT_DOUBLE_EQ(tangential(149.9), 0.80);
    EXPECT_DOUBLE_EQ(tangential(150.1), 0.70);
    EXPECT_DOUBLE_EQ(tangential(-9.0), 0.80);
}

// The fixed point of jumps on an even slope of 38 degrees with r_n 0.30 and r_t 0.75, worked out by hand from
// the laws (rockfall/README.md): jump 6.31 m along the slope, 12.25 m/s before the impact.
TEST(ProfileMode, FindsTheFixedPointOfJumps) {
    const ValidationCase of = read_case(even_slope("profile"));
    const auto recipe = of.recipe(
        "strict", {"picus.rt_noise=0", "surfaces.p_stop_factor=0", "series.rocks=3", "series.series=0"});
    const RebuiltSlope slope = rebuild(*recipe, of.profile(*recipe));
    const Ensembles falls = simulate_falls(*recipe, slope, {});
    const JumpSums& late = falls.large.segments.at(30);
    ASSERT_GT(late.jumps, 0U);
    EXPECT_NEAR(late.shortest_m, 6.31, 0.01);
    EXPECT_NEAR(late.longest_m, 6.31, 0.01);
    for (const RockFacts& rock : falls.large.rocks) {
        EXPECT_NEAR(rock.max_speed_mps, 12.25, 0.05);  // the start of 3 m/s overshoots a little
    }
    for (const rockfall::Arrival& arrival : falls.large.arrivals) {
        EXPECT_EQ(arrival.y_m, 0.0F);
    }
}

}  // namespace
}  // namespace coupling::validation::rebuild_test
