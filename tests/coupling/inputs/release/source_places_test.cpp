#include "coupling/inputs/release/source_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "rockfall/terrain/mesh.hpp"
#include "tests/coupling/inputs/opened.hpp"
#include "tests/coupling/inputs/plausible/turned.hpp"

namespace coupling::plausible::source_places_test {
namespace {

/// A slope on a square of 400 m about (0, 0) that falls eastward, with a cliff from north to south at x =
/// -100 m, as a grid of 5 m. Heights wave a little, differently in each trial.
struct Slope {
    config::Raster<double> heights;
    std::vector<rockfall::ReleaseSource> sources;  ///< points along the cliff
    std::vector<rockfall::Target> targets;         ///< lines in the valley
    std::vector<NetRecord> nets;
};

config::Raster<double> heights_of(std::mt19937& random) {
    config::GridFrame frame;
    frame.columns = 80;
    frame.rows = 80;
    frame.cell_width_m = 5.0;
    frame.cell_height_m = 5.0;
    frame.x_west_m = -200.0;
    frame.y_south_m = -200.0;
    const double phase = 6.28 * std::generate_canonical<double, 32>(random);
    config::Raster<double> heights{frame, 0.0};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const double x_m = frame.x_centre_m(cell.column);
        const double y_m = frame.y_centre_m(cell.row);
        const double cliff_m = 60.0 * std::clamp((-80.0 - x_m) / 40.0, 0.0, 1.0);
        heights.values[i] = 500.0 - 0.55 * x_m + cliff_m + 2.0 * std::sin(0.03 * (x_m + y_m) + phase);
    }
    return heights;
}

rockfall::ReleaseSource point_at(double x_m, double y_m) {
    rockfall::ReleaseSource source;
    source.kind = rockfall::ReleaseSource::Kind::line;
    source.first_m = {x_m, y_m};
    source.last_m = source.first_m;
    source.rocks = 5;
    return source;
}

rockfall::Target line_at(const char* id, double x_m) {
    rockfall::Target target;
    target.id = id;
    target.parts = {{{x_m, -150.0}, {x_m, 150.0}}};
    return target;
}

Slope slope_of(std::mt19937& random) {
    Slope slope{heights_of(random), {}, {}, {}};
    for (int i = 0; i < 40; ++i) {
        const double along_m = 260.0 * (std::generate_canonical<double, 32>(random) - 0.5);
        slope.sources.push_back(point_at(-100.0, along_m));
    }
    slope.targets = {line_at("road", 150.0), line_at("house", 170.0)};
    NetRecord net;
    net.name = "net";
    net.net.line_m = {{100.0, -50.0}, {100.0, 50.0}};
    slope.nets.push_back(net);
    return slope;
}

void move(Slope& slope, double east_m, double north_m) {
    for (rockfall::ReleaseSource& source : slope.sources) {
        source.first_m += Eigen::Vector2d{east_m, north_m};
        source.last_m = source.first_m;
    }
}

/// All of it turned, in the coordinates of the turned terrain.
Slope turned(const Slope& slope, const Turn& turn) {
    Slope result = slope;
    result.heights = turn.of(slope.heights);
    for (rockfall::ReleaseSource& source : result.sources) {
        source.first_m = turn.of(source.first_m);
        source.last_m = source.first_m;
    }
    for (rockfall::Target& target : result.targets) {
        for (Eigen::Vector2d& corner : target.parts.front()) {
            corner = turn.of(corner);
        }
    }
    for (Eigen::Vector2d& corner : result.nets.front().net.line_m) {
        corner = turn.of(corner);
    }
    return result;
}

struct Found {
    SourceSlopes slopes;
    BelowWhat below;
};

Found found_on(Slope slope) {
    const rockfall::Terrain terrain = rockfall::triangulate(slope.heights, 0.0);
    for (rockfall::ReleaseSource& source : slope.sources) {
        source.first_m -= terrain.origin_m();
        source.last_m -= terrain.origin_m();
    }
    for (rockfall::Target& target : slope.targets) {
        for (Eigen::Vector2d& corner : target.parts.front()) {
            corner -= terrain.origin_m();
        }
    }
    for (Eigen::Vector2d& corner : slope.nets.front().net.line_m) {
        corner -= terrain.origin_m();
    }
    const OnSlope site{terrain, 5.0, slope.sources, slope.targets, slope.nets};
    return {source_slopes(site), sources_below(site)};
}

TEST(SourceSlopes, AreNotKnownWhereHeightsAreFartherApartThanTheTerrainIsWide) {
    std::mt19937 random{5};
    const Slope slope = slope_of(random);
    const rockfall::Terrain terrain = rockfall::triangulate(slope.heights, 0.0);
    const OnSlope site{terrain, 1000.0, slope.sources, slope.targets, slope.nets};
    EXPECT_TRUE(std::isnan(source_slopes(site).median_deg)) << "no ground is gentle for want of knowledge";
}

TEST(SourceSlopes, FindTheWayBackToTheCliff) {
    std::mt19937 random{5};
    for (const auto& [east_m, north_m] : {std::pair{83.0, 0.0}, {-70.0, 30.0}, {60.0, -40.0}}) {
        Slope slope = slope_of(random);
        const SourceSlopes right = found_on(slope).slopes;
        EXPECT_GT(right.median_deg, 55.0);
        EXPECT_LT(right.best_mean_deg - right.mean_deg, 3.0);
        move(slope, east_m, north_m);
        const SourceSlopes wrong = found_on(slope).slopes;
        EXPECT_GT(wrong.best_mean_deg - wrong.mean_deg, 15.0);
        EXPECT_NEAR(wrong.best_move_m.x(), -east_m, 35.0);  // the cliff is 40 m wide
    }
}

TEST(SourceSlopes, FindTheMirrorThatPutsThemBackOnTheCliff) {
    std::mt19937 random{7};
    const Slope right = slope_of(random);
    const SourceSlopes as_given = found_on(right).slopes;
    EXPECT_LT(as_given.best_mirrored_deg, as_given.mean_deg + 1.0);  // north-south is the same slope
    for (const Turn& turn : {Turn{0, true}, Turn{2, false}}) {
        Slope wrong = right;
        wrong.heights = turn.of(right.heights);  // and nothing else
        const SourceSlopes found = found_on(wrong).slopes;
        EXPECT_TRUE(found.mirrored_west_east);
        EXPECT_NEAR(found.best_mirrored_deg, as_given.mean_deg, 1.0);
        EXPECT_GT(found.best_mirrored_deg, found.mean_deg + 15.0);
    }
}

TEST(SourcesBelow, AreThoseThatNoRockFallsFrom) {
    std::mt19937 random{6};
    Slope slope = slope_of(random);
    EXPECT_TRUE(found_on(slope).below.targets.empty());
    EXPECT_TRUE(found_on(slope).below.nets.empty());
    move(slope, 220.0, 0.0);  // below the net, above the road
    const Found between = found_on(slope);
    EXPECT_EQ(between.below.nets, std::vector<std::size_t>{0});
    EXPECT_TRUE(between.below.targets.empty());
    move(slope, 40.0, 0.0);  // below the road, above the house
    EXPECT_EQ(found_on(slope).below.targets, std::vector<std::size_t>{0});
    move(slope, 25.0, 0.0);
    EXPECT_EQ(found_on(slope).below.targets.size(), 2U);
    EXPECT_DOUBLE_EQ(found_on(slope).below.rocks_below_all, 1.0);
}

TEST(SourceRules, AnswerTheSameForTurnedMirroredAndShuffledSites) {
    std::mt19937 random{9};
    for (int trial = 0; trial < 6; ++trial) {
        Slope slope = slope_of(random);
        move(slope, 60.0 * trial, 10.0 * trial);
        const Found straight = found_on(slope);
        std::shuffle(slope.sources.begin(), slope.sources.end(), random);
        std::reverse(slope.targets.begin(), slope.targets.end());
        for (const Turn& turn : all_turns()) {
            const Found other = found_on(turned(slope, turn));
            // A square of a grid may be cut along either diagonal: half of the waves' bend between them.
            constexpr double by_diagonals_deg = 0.2;
            ASSERT_EQ(std::isnan(other.slopes.median_deg), std::isnan(straight.slopes.median_deg));
            if (!std::isnan(straight.slopes.median_deg)) {
                EXPECT_NEAR(other.slopes.median_deg, straight.slopes.median_deg, by_diagonals_deg);
            }
            EXPECT_NEAR(other.slopes.mean_deg, straight.slopes.mean_deg, by_diagonals_deg);
            EXPECT_NEAR(other.slopes.best_mean_deg, straight.slopes.best_mean_deg, by_diagonals_deg);
            EXPECT_NEAR(other.slopes.best_mirrored_deg, straight.slopes.best_mirrored_deg, by_diagonals_deg);
            EXPECT_EQ(other.below.targets.size(), straight.below.targets.size());
            EXPECT_EQ(other.below.nets, straight.below.nets);
            EXPECT_DOUBLE_EQ(other.below.rocks_below_all, straight.below.rocks_below_all);
        }
    }
}

TEST(SourceSlopes, AreThoseOfTheGentlerGroundWhereAMaskIsTheWrongWayRound) {
    std::mt19937 random{7};
    Slope slope = slope_of(random);
    EXPECT_GT(found_on(slope).slopes.steeper_than_rest, 0.9);
    EXPECT_LT(found_on(slope).slopes.covered, 0.05);
    slope.sources.clear();
    for (double x_m = -185.0; x_m < 190.0; x_m += 10.0) {
        for (double y_m = -185.0; y_m < 190.0; y_m += 10.0) {
            if (x_m < -140.0 || x_m > -60.0) {
                slope.sources.push_back(point_at(x_m, y_m));
            }
        }
    }
    for (const Turn& turn : all_turns()) {
        EXPECT_LT(found_on(turned(slope, turn)).slopes.steeper_than_rest, 0.5);
    }
}

TEST(SourcesBelow, LeaveOutTargetsOffTheTerrainAndSourcesInsideThem) {
    std::mt19937 random{8};
    Slope slope = slope_of(random);
    slope.targets = {line_at("elsewhere", 5000.0)};
    EXPECT_DOUBLE_EQ(found_on(slope).below.rocks_below_all, 0.0);
    slope.targets.front().is_area = true;
    slope.targets.front().parts = {
        {{-190.0, -190.0}, {-50.0, -190.0}, {-50.0, 190.0}, {-190.0, 190.0}, {-190.0, -190.0}}};
    EXPECT_DOUBLE_EQ(found_on(slope).below.rocks_inside, 1.0);
    EXPECT_DOUBLE_EQ(found_on(slope).below.rocks_below_all, 0.0);
    move(slope, 100.0, 0.0);
    EXPECT_DOUBLE_EQ(found_on(slope).below.rocks_inside, 0.0);
}

}  // namespace
}  // namespace coupling::plausible::source_places_test
