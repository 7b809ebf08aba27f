#include "coupling/assessments/hazard/zones/zone_outlines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "coupling/assessments/hazard/zones/zone_sieve.hpp"

namespace coupling::hazard::zones::zone_outlines_test {
namespace {

config::GridFrame frame_of(int columns, int rows) {
    return {columns, rows, 1000.0, 2000.0, 10.0, 10.0};
}

config::Raster<std::uint8_t> levels_of(int columns, const std::vector<std::uint8_t>& values) {
    config::Raster<std::uint8_t> levels{frame_of(columns, static_cast<int>(values.size()) / columns), 0};
    std::copy_n(values.begin(), levels.values.size(), levels.values.begin());
    return levels;
}

bool holds(const ZoneOutline& zone, double x_m, double y_m) {
    bool inside = false;
    for (const auto& ring : zone.rings) {
        for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
            const auto& a = ring[i];
            const auto& b = ring[i + 1];
            if ((a.y_m > y_m) != (b.y_m > y_m) &&
                x_m < a.x_m + (y_m - a.y_m) * (b.x_m - a.x_m) / (b.y_m - a.y_m)) {
                inside = !inside;
            }
        }
    }
    return inside;
}

TEST(OutlinesOf, OneCellIsARoundedCell) {
    const auto zones = outlines_of(levels_of(3, {0, 0, 0, 0, 3, 0, 0, 0, 0}));
    ASSERT_EQ(zones.size(), 1U);
    EXPECT_EQ(zones[0].level, 3);
    EXPECT_EQ(zones[0].rings.size(), 1U);
    // The diamond of the middles has half the area; its corners are cut twice.
    EXPECT_LT(zones[0].area_m2, 50.0);
    EXPECT_GT(zones[0].area_m2, 40.0);
}

TEST(OutlinesOf, AHoleIsARingOfItsOwn) {
    const auto zones = outlines_of(
        levels_of(5, {0, 0, 0, 0, 0, 0, 2, 2, 2, 0, 0, 2, 1, 2, 0, 0, 2, 2, 2, 0, 0, 0, 0, 0, 0}));
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_EQ(zones[0].level, 2);
    EXPECT_EQ(zones[0].rings.size(), 2U);
    EXPECT_EQ(zones[1].rings.size(), 1U);
}

TEST(OutlinesOf, TheHigherLevelIsOneZoneAcrossACorner) {
    const auto zones = outlines_of(levels_of(4, {0, 0, 0, 0, 0, 4, 1, 0, 0, 1, 4, 0, 0, 0, 0, 0}));
    ASSERT_EQ(zones.size(), 3U);  // one of level 4, two of level 1
    EXPECT_EQ(std::count_if(zones.begin(), zones.end(), [](const auto& z) { return z.level == 4; }), 1);
}

RC_GTEST_PROP(OutlinesOf, LeavesTheMiddleOfEachCellInTheZoneOfItsLevelAlone,
              (const std::vector<std::uint8_t>& given)) {
    const int columns = *rc::gen::inRange(1, 9);
    RC_PRE(given.size() >= static_cast<std::size_t>(columns));
    std::vector<std::uint8_t> values;
    for (const std::uint8_t value : given) {
        values.push_back(value % 4);
    }
    const auto levels = levels_of(columns, values);
    const auto zones = outlines_of(levels);
    for (std::size_t i = 0; i < levels.values.size(); ++i) {
        const config::Cell cell = levels.frame.cell_of(i);
        const double x_m = levels.frame.x_centre_m(cell.column) + 1e-7;
        const double y_m = levels.frame.y_centre_m(cell.row) + 1e-7;
        int found = 0;
        for (const ZoneOutline& zone : zones) {
            if (holds(zone, x_m, y_m)) {
                ++found;
                RC_ASSERT(zone.level == levels.values[i]);
            }
        }
        RC_ASSERT(found == (levels.values[i] > 0 ? 1 : 0));
    }
}

RC_GTEST_PROP(OutlinesOf, ShareEachPieceOfOutlineBetweenNeighbours,
              (const std::vector<std::uint8_t>& given)) {
    RC_PRE(given.size() >= 6U);
    std::vector<std::uint8_t> values;
    for (const std::uint8_t value : given) {
        values.push_back(1 + value % 3);  // no ground without a zone
    }
    const auto levels = levels_of(6, values);
    // Each piece inside the map is a side of two zones, each piece of the border of one.
    std::map<std::pair<std::pair<double, double>, std::pair<double, double>>, int> sides;
    double area_m2 = 0.0;
    for (const ZoneOutline& zone : outlines_of(levels)) {
        area_m2 += zone.area_m2;
        for (const auto& ring : zone.rings) {
            RC_ASSERT(ring.front() == ring.back());
            for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
                std::pair a{ring[i].x_m, ring[i].y_m};
                std::pair b{ring[i + 1].x_m, ring[i + 1].y_m};
                ++sides[{std::min(a, b), std::max(a, b)}];
            }
        }
    }
    for (const auto& [side, count] : sides) {
        RC_ASSERT(count == 1 || count == 2);
    }
    const double whole_m2 = static_cast<double>(levels.values.size()) * 100.0;
    RC_ASSERT(area_m2 <= whole_m2 + 1e-6);
    RC_ASSERT(area_m2 >= whole_m2 - 4 * 25.0);  // only the corners of the map are cut
}

TEST(WithoutSmallZones, FillsHolesAndKeepsSpecksOfAHigherLevel) {
    config::Raster<float> levels{frame_of(5, 5), std::numeric_limits<float>::quiet_NaN()};
    for (const int row : {1, 2, 3}) {
        for (const int column : {0, 1, 2}) {
            levels.at({column, row}) = 3.0F;
        }
    }
    levels.at({1, 2}) = 1.0F;  // a hole of another level
    levels.at({4, 0}) = 4.0F;  // a speck, the only area of its level
    const auto found = without_small_zones(levels, 250.0);
    EXPECT_EQ(found.at({1, 2}), 3);
    EXPECT_EQ(found.at({4, 0}), 4);
    EXPECT_EQ(std::count(found.values.begin(), found.values.end(), 3), 9);
    const auto all = without_small_zones(levels, 0.0);
    EXPECT_EQ(all.at({1, 2}), 1);
    EXPECT_EQ(all.at({4, 0}), 4);
}

/// No cell falls to a lower level, so that the highest level of a map keeps all its area; and what is done
/// once needs no second time.
RC_GTEST_PROP(WithoutSmallZones, LowersNoCell, (const std::vector<std::uint8_t>& given)) {
    RC_PRE(given.size() >= 8U);
    config::Raster<float> levels{frame_of(8, static_cast<int>(given.size()) / 8), 0.0F};
    for (std::size_t i = 0; i < levels.values.size(); ++i) {
        levels.values[i] = static_cast<float>(given[i] % 5);
    }
    const auto once = without_small_zones(levels, 300.0);
    for (std::size_t i = 0; i < levels.values.size(); ++i) {
        RC_ASSERT(once.values[i] >= static_cast<std::uint8_t>(levels.values[i]));
    }
    config::Raster<float> again{once.frame, 0.0F};
    std::copy(once.values.begin(), once.values.end(), again.values.begin());
    RC_ASSERT(without_small_zones(again, 300.0).values == once.values);
}

/// A hole that is enclosed by one higher level is never left below the smallest area.
RC_GTEST_PROP(WithoutSmallZones, FillsEachSmallHole, ()) {
    const auto hole = static_cast<float>(*rc::gen::inRange(0, 4));
    const auto around = static_cast<float>(*rc::gen::inRange(static_cast<int>(hole) + 1, 5));
    const int wide = *rc::gen::inRange(1, 5);
    config::Raster<float> levels{frame_of(8, 8), around};
    for (int column = 2; column < 2 + wide; ++column) {
        levels.at({column, 3}) = hole;
    }
    const auto found = without_small_zones(levels, 250.0);
    RC_ASSERT(static_cast<float>(found.at({2, 3})) == (wide < 3 ? around : hole));
}

}  // namespace
}  // namespace coupling::hazard::zones::zone_outlines_test
