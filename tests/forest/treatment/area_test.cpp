#include "forest/treatment/area.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/forest/small_forest.hpp"

namespace forest::area_test {
namespace {

config::Angle degrees(double value) {
    return config::Angle::from_degrees(value);
}

TEST(AreaHa, IsThatOfThePolygonOrTheUnits) {
    const PatchGrid grid = square_of_forest(10);
    EXPECT_DOUBLE_EQ(area_ha(grid, {}), 1.0);
    EXPECT_NEAR(area_ha(grid, {{rectangle({50.0, 50.0}, 40.0, 20.0, degrees(0.0))}, {}}), 0.08, 1e-9);
    EXPECT_NEAR(area_ha(grid, {{rectangle({50.0, 50.0}, 50.0, 15.0, degrees(-45.0))}, {}}), 0.075, 0.004);
    EXPECT_EQ(area_ha(grid, {{}, {7}}), 0.0);
    EXPECT_DOUBLE_EQ(area_ha(grid, {{}, {7, 0}}), 1.0);
}

TEST(TreesIn, AreThoseInsideAndNoOthers) {
    const PatchGrid grid = square_of_forest(6);
    const SpeciesTable species = SpeciesTable::shipped();
    const Stand stand{grid, species.size(), any_trees(grid, species, 500, 3), 2000};
    const TreatmentArea area{{rectangle({30.0, 30.0}, 20.0, 20.0, degrees(0.0))}, {}};
    const std::vector<std::size_t> inside = trees_in(stand, area);
    std::size_t expected = 0;
    for (const Tree& tree : stand.trees()) {
        expected += std::abs(tree.x_m - 30.0) < 10.0 && std::abs(tree.y_m - 30.0) < 10.0 ? 1 : 0;
    }
    EXPECT_EQ(inside.size(), expected);
    EXPECT_EQ(patches_in(grid, area).size(), 4U);
}

TEST(SlitAt, LiesObliqueToTheFallLine) {
    // The slope faces south: the fall line points to -90 degrees, the slit's axis to -45.
    const PatchGrid grid = square_of_forest(10);
    EXPECT_NEAR(mean_fall_line(grid).in_degrees(), -90.0, 1e-6);
    const config::Shape slit = slit_at({50.0, 50.0}, mean_fall_line(grid), {});
    const double half = 0.5 * 49.0 * std::sqrt(0.5);
    EXPECT_TRUE(config::point_in_polygon(slit, {50.0 + half, 50.0 - half}));
    EXPECT_TRUE(config::point_in_polygon(slit, {50.0 - half, 50.0 + half}));
    EXPECT_FALSE(config::point_in_polygon(slit, {50.0 + half, 50.0 + half}));
    EXPECT_FALSE(config::point_in_polygon(slit, {50.0, 50.0 - 12.0}));
}

TEST(OpenLength, StaysBelow25MetresForAnObliqueSlitAndNotForOneDownTheSlope) {
    EXPECT_NEAR(open_length_m({}), 15.0 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(open_length_m({.to_fall_line = degrees(90.0)}), 15.0, 1e-6);
    EXPECT_NEAR(open_length_m({.to_fall_line = degrees(0.0)}), 50.0, 1e-6);
}

TEST(LadderOfSlits, CutsARungAtEachEntryAndNoRungTwice) {
    const PatchGrid grid = square_of_forest(40);
    const Slit slit;
    std::vector<config::Shape> all;
    for (int entry = 0; entry < 3; ++entry) {
        const std::vector<config::Shape> slits = ladder_of_slits(grid, slit, 5.0, 80.0, entry, 3);
        EXPECT_GE(slits.size(), 8U);
        all.insert(all.end(), slits.begin(), slits.end());
    }
    double sum_ha = 0.0;
    for (const config::Shape& shape : all) {
        sum_ha += area_ha(grid, {{shape}, {}});
    }
    EXPECT_NEAR(area_ha(grid, {all, {}}), sum_ha, 1e-9) << "no two overlap";
    EXPECT_GT(sum_ha / grid.area_ha(), 0.1);
}

TEST(LadderOfSlits, SetsSlitsOfAnEntryOnGap) {
    // Two lines of rungs 20 m apart: of the four rungs of a cycle the first and, beside it, the third.
    const PatchGrid grid = square_of_forest(16);
    const Slit slit{.length_m = 40.0, .width_m = 10.0, .to_fall_line = degrees(90.0)};
    const auto middles = [&](int entry) {
        std::map<long, std::set<long>> by_line;
        for (const config::Shape& shape : ladder_of_slits(grid, slit, 10.0, 90.0, entry, 4)) {
            const config::Point2 a = shape.parts[0][0];
            const config::Point2 c = shape.parts[0][2];
            by_line[std::lround(0.5 * (a.x_m + c.x_m))].insert(std::lround(0.5 * (a.y_m + c.y_m)));
        }
        return by_line;
    };
    const auto entry = middles(0);
    ASSERT_EQ(entry.size(), 2U);
    const std::set<long>& one = entry.begin()->second;
    const std::set<long>& other = entry.rbegin()->second;
    EXPECT_EQ(std::abs(*one.begin() - *other.begin()), 40) << "half of a cycle of 80 m";
}

TEST(Corridor, HoldsWhatIsWithinHalfItsWidthOfTheLine) {
    const std::vector<config::Point2> line{
        {20.0, 20.0}, {60.0, 20.0}, {60.0, 60.0}, {60.0, 60.0}, {90.0, 90.0}};
    const std::vector<config::Shape> pieces = corridor(line, 12.0);
    const auto is_inside = [&](config::Point2 point) {
        return std::any_of(pieces.begin(), pieces.end(), [&](const config::Shape& piece) {
            return config::point_in_polygon(piece, point);
        });
    };
    for (double x_m = 10.25; x_m < 100.0; x_m += 1.0) {
        for (double y_m = 10.25; y_m < 100.0; y_m += 1.0) {
            const config::LinePosition at = config::position_along(line, {x_m, y_m});
            const bool is_between = at.along_m > 0.0 && at.along_m < config::length_m(line);
            // A joint of 16 corners lacks at most 2 % of its radius.
            if (is_between && at.offset_m < 0.98 * 6.0) {
                EXPECT_TRUE(is_inside({x_m, y_m})) << x_m << ' ' << y_m;
            } else if (at.offset_m > 6.0 + 1e-9) {
                EXPECT_FALSE(is_inside({x_m, y_m})) << x_m << ' ' << y_m;
            }
        }
    }
}

TEST(Strips, CoverTheForestOnceInAllEntries) {
    const PatchGrid grid = square_of_forest(20);
    double sum_ha = 0.0;
    for (int entry = 0; entry < 3; ++entry) {
        sum_ha += area_ha(grid, {strips(grid, 50.0, degrees(30.0), entry, 3), {}});
    }
    EXPECT_NEAR(sum_ha, grid.area_ha(), 1e-9);
}

}  // namespace
}  // namespace forest::area_test
