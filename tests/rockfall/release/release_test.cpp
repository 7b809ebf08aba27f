#include "rockfall/release/release.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::release_test {
namespace {

using testing::plane_slope;

/// The pieces of a straight line along y, of these lengths.
std::vector<ReleaseSource> pieces_of(const std::vector<double>& lengths_m) {
    std::vector<ReleaseSource> pieces;
    double y_m = 20.0;
    for (const double length_m : lengths_m) {
        ReleaseSource piece;
        piece.kind = ReleaseSource::Kind::line;
        piece.first_m = {100.0, y_m};
        piece.last_m = {100.0, y_m + length_m};
        piece.weight = length_m;
        piece.evenly = true;
        pieces.push_back(piece);
        y_m += length_m;
    }
    return pieces;
}

std::vector<std::uint32_t> rocks_of(const std::vector<ReleaseSource>& sources) {
    std::vector<std::uint32_t> rocks;
    for (const ReleaseSource& source : sources) {
        rocks.push_back(source.rocks);
    }
    return rocks;
}

RockStart start_at(const Slope& slope, const ReleaseSource& source, const StartLaw& common,
                   std::uint64_t rock) {
    const auto start = start_of(slope, source, 0, common, {7, 0, 0, rock});
    EXPECT_TRUE(start);
    return start.value_or(RockStart{});
}

TEST(Spread, GoesByLength) {
    std::vector<ReleaseSource> pieces = pieces_of({30.0, 10.0});
    spread(pieces, 8);
    EXPECT_EQ(rocks_of(pieces), (std::vector<std::uint32_t>{6, 2}));
}

TEST(Spread, ReachesAllOfALineWithFewRocks) {
    // Ten pieces, five rocks: every other piece, not the first five.
    std::vector<ReleaseSource> pieces = pieces_of(std::vector<double>(10, 4.0));
    spread(pieces, 5);
    for (std::size_t pair = 0; pair < 5; ++pair) {
        EXPECT_EQ(pieces[2 * pair].rocks + pieces[2 * pair + 1].rocks, 1U) << pair;
    }
}

TEST(Spread, GivesOutEveryRock) {
    for (const std::uint32_t total : {1U, 2U, 7U, 999U}) {
        std::vector<ReleaseSource> pieces = pieces_of({0.1, 12.3, 4.0, 7.77, 0.003});
        spread(pieces, total);
        const std::vector<std::uint32_t> rocks = rocks_of(pieces);
        EXPECT_EQ(std::accumulate(rocks.begin(), rocks.end(), 0U), total);
    }
}

TEST(StartOf, KeepsTheDrawnDiameterOfABlockToTheLastBit) {
    // Tables by size group rocks by it: 0.49999999999909 beside 0.5 would be a size of its own.
    const Slope slope = plane_slope(35.0, {0.3, 0.8});
    std::vector<ReleaseSource> pieces = pieces_of({50.0});
    spread(pieces, 10);
    number_rocks(pieces);
    StartLaw law;
    law.diameter = DiameterLaw::fixed(0.75);
    std::vector<BlockShape> shapes;
    for (const char* name : {"cube", "plate", "octahedron"}) {
        shapes.push_back({name, hull_of_shape(name)});
    }
    law.shape = std::make_shared<const ShapeLaw>(shapes, 0.1, std::nullopt);
    for (std::uint64_t rock = 0; rock < 10; ++rock) {
        const RockStart start = start_at(slope, pieces.front(), law, rock);
        EXPECT_EQ(start.rock.diameter_m, 0.75);
        EXPECT_GT(largest_radius_m(law, pieces), 0.75 / 2.0) << "corners lie outside of the sphere";
    }
}

TEST(StartOf, TakesAFactorOnSizesThatItsSourceDoesNotKnow) {
    const Slope slope = plane_slope(35.0, {0.3, 0.8});
    std::vector<ReleaseSource> pieces = pieces_of({50.0});
    spread(pieces, 10);
    number_rocks(pieces);
    StartLaw law;
    law.diameter = DiameterLaw::uniform(0.5, 1.5);
    for (std::uint64_t rock = 0; rock < 10; ++rock) {
        const config::StreamKey key{7, 0, 0, rock};
        const double plain_m = start_of(slope, pieces[0], 0, law, key)->rock.diameter_m;
        const RockStart larger = *start_of(slope, pieces[0], 0, law, key, 1.25);
        EXPECT_DOUBLE_EQ(larger.rock.diameter_m, 1.25 * plain_m);
        EXPECT_EQ(larger.position_m.x(), start_of(slope, pieces[0], 0, law, key)->position_m.x());
        ReleaseSource known = pieces[0];
        known.own_start = std::make_shared<const StartLaw>(law);
        EXPECT_EQ(start_of(slope, known, 0, StartLaw{}, key, 1.25)->rock.diameter_m, plain_m);
    }
}

TEST(StartOf, PutsEachRockIntoItsOwnStretchOfALine) {
    const Slope slope = plane_slope(35.0, {0.3, 0.8});
    std::vector<ReleaseSource> pieces = pieces_of({50.0});
    spread(pieces, 10);
    number_rocks(pieces);
    double off_middle_m = 0.0;
    for (std::uint64_t rock = 0; rock < 10; ++rock) {
        const double along_m = start_at(slope, pieces[0], {}, rock).position_m.y() - 20.0;
        EXPECT_GE(along_m, 5.0 * static_cast<double>(rock));
        EXPECT_LE(along_m, 5.0 * static_cast<double>(rock + 1));
        off_middle_m += std::abs(along_m - 5.0 * (static_cast<double>(rock) + 0.5));
    }
    EXPECT_GT(off_middle_m, 1.0);  // at random in it

    StartLaw middle;
    middle.random_place = false;
    EXPECT_DOUBLE_EQ(start_at(slope, pieces[0], middle, 3).position_m.y(), 20.0 + 17.5);
}

TEST(StartOf, PutsRocksOfAPolygonInsideItWhateverItsShape) {
    const Slope slope = plane_slope(35.0, {0.3, 0.8});
    // A thin triangle across its rectangle, and a square with a hole.
    const std::vector<std::vector<std::vector<config::Point2>>> polygons{
        {{{20.0, 20.0}, {24.0, 24.0}, {24.0, 23.8}, {20.0, 20.0}}},
        {{{20.0, 20.0}, {23.0, 20.0}, {23.0, 23.0}, {20.0, 23.0}, {20.0, 20.0}},
         {{20.5, 20.5}, {22.5, 20.5}, {22.5, 22.5}, {20.5, 22.5}, {20.5, 20.5}}}};
    for (const auto& rings : polygons) {
        auto outline = std::make_shared<SourceOutline>();
        outline->polygon = {config::Shape::Kind::polygon, rings};
        outline->inner_m = {20.2, 20.195};
        ReleaseSource source;
        source.first_m = {20.0, 20.0};
        source.last_m = {24.0, 24.0};
        source.outline = outline;
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        constexpr int rocks = 400;
        for (std::uint64_t rock = 0; rock < rocks; ++rock) {
            const Eigen::Vector2d place = start_at(slope, source, {}, rock).position_m.head<2>();
            EXPECT_TRUE(config::point_in_polygon(outline->polygon, {place.x(), place.y()}));
            EXPECT_EQ(place,
                      start_at(slope, source, {}, rock).position_m.head<2>().eval());  // keyed by the rock
            mean += place / rocks;
        }
        // Means over 400 rocks scatter by 1/20 of at most 1.5 m: four times that.
        const double middle_m = rings.size() == 2 ? 21.5 : 20.0 + 4.0 * 2.0 / 3.0;
        EXPECT_NEAR(mean.x(), middle_m, 0.3);
    }
    StartLaw middle;
    middle.random_place = false;
    auto outline = std::make_shared<SourceOutline>();
    outline->inner_m = {20.25, 21.0};
    ReleaseSource source;
    source.outline = outline;
    EXPECT_EQ(start_at(slope, source, middle, 0).position_m.x(), 20.25);
}

TEST(StartOf, HeadsForTheAzimuth) {
    const Slope slope = plane_slope(35.0, {0.3, 0.8});
    ReleaseSource source = pieces_of({10.0}).front();
    source.rocks = 1;
    StartLaw own;
    own.speed_mps = 4.0;
    own.dip = config::Angle{};
    for (const auto& [azimuth_deg, east, north] :
         {std::tuple{0.0, 0.0, 1.0}, std::tuple{90.0, 1.0, 0.0}, std::tuple{300.0, -std::sqrt(0.75), 0.5},
          std::tuple{360.0, 0.0, 1.0}, std::tuple{225.0, -M_SQRT1_2, -M_SQRT1_2}}) {
        own.azimuth = config::Angle::from_degrees(azimuth_deg);
        source.own_start = std::make_shared<const StartLaw>(own);
        const Eigen::Vector3d velocity = start_at(slope, source, {}, 0).velocity_mps;
        EXPECT_NEAR(velocity.x(), 4.0 * east, 1e-10);
        EXPECT_NEAR(velocity.y(), 4.0 * north, 1e-10);
        EXPECT_NEAR(velocity.z(), 0.0, 1e-10);
    }
}

TEST(StartOf, TakesSizeAndDensityOfTheSource) {
    const Slope slope = plane_slope(35.0, {0.3, 0.8});
    std::vector<ReleaseSource> pieces = pieces_of({10.0, 10.0});
    StartLaw common;
    common.diameter = DiameterLaw::fixed(0.4);
    StartLaw own = common;
    own.diameter = DiameterLaw::fixed(1.2);
    own.density_kgpm3 = 2500.0;
    own.speed_mps = 0.0;
    own.height_m = 8.0;
    pieces[1].own_start = std::make_shared<const StartLaw>(own);
    spread(pieces, 4);
    number_rocks(pieces);
    EXPECT_EQ(start_at(slope, pieces[0], common, 0).rock.diameter_m, 0.4);
    const RockStart start = start_at(slope, pieces[1], common, 2);
    EXPECT_EQ(start.rock.mass_kg, Rock::sphere(1.2, 2500.0).mass_kg);
    EXPECT_EQ(start.velocity_mps.norm(), 0.0);
    EXPECT_NEAR(start.position_m.z() - *slope.terrain.height_m(start.position_m.x(), start.position_m.y()),
                8.0, 1e-9);
}

TEST(DiameterRange, GoesOverTheRocksOfAllSources) {
    StartLaw common;
    common.diameter = DiameterLaw::uniform(0.4, 0.6);
    StartLaw own;
    own.diameter = DiameterLaw::fixed(1.5);
    std::vector<ReleaseSource> pieces = pieces_of({30.0, 10.0, 10.0});
    pieces[1].own_start = std::make_shared<const StartLaw>(own);
    pieces[0].rocks = 3;
    pieces[1].rocks = 1;
    const DiameterRange range = diameter_range(common, pieces);
    EXPECT_EQ(range.smallest_m, 0.4);
    EXPECT_EQ(range.largest_m, 1.5);
    EXPECT_NEAR(range.mean_m, 0.25 * 1.5 + 0.75 * 0.5, 1e-12);
    EXPECT_EQ(diameter_range(common, {}).largest_m, 0.6);

    // What no rock has does not count.
    pieces[1].rocks = 0;
    EXPECT_EQ(diameter_range(common, pieces).largest_m, 0.6);
}

}  // namespace
}  // namespace rockfall::release_test
