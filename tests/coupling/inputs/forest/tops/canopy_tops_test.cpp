#include "coupling/inputs/forest/tops/canopy_tops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "config/random/stream.hpp"

namespace coupling::canopy_tops_test {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double least_m = 5.0;

struct Crown {
    int column;
    int row;
    double height_m;
    double radius_m;
};

config::GridFrame frame_of(double cell_m) {
    return {.columns = 120,
            .rows = 90,
            .x_west_m = 600'100.0,
            .y_south_m = 200'050.0,
            .cell_width_m = cell_m,
            .cell_height_m = cell_m};
}

/// Cones whose tips are centres of cells; bare ground between them.
config::Raster<double> drawn(const std::vector<Crown>& crowns, const config::GridFrame& frame) {
    config::Raster<double> canopy{frame, 0.0};
    for (std::size_t i = 0; i < canopy.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        for (const Crown& crown : crowns) {
            const double distance_m =
                std::hypot(cell.column - crown.column, cell.row - crown.row) * frame.cell_width_m;
            if (distance_m < crown.radius_m) {
                canopy.values[i] =
                    std::max(canopy.values[i], crown.height_m * (1.0 - 0.5 * distance_m / crown.radius_m));
            }
        }
    }
    return canopy;
}

/// Crowns at random, each as far from the others as both windows and both crowns are wide.
std::vector<Crown> random_crowns(std::uint64_t id, const CanopyWindowLaw& window,
                                 const config::GridFrame& frame) {
    config::RandomStream stream{{11, 0, 0, id}, config::Purpose::test};
    std::vector<Crown> crowns;
    for (int i = 0; i < 60; ++i) {
        const double height_m = 6.0 + 34.0 * stream.uniform();
        const double radius_m = 1.5 + 0.1 * height_m;
        const auto column = 2 + static_cast<int>(stream.uniform() * (frame.columns - 4));
        const auto row = 2 + static_cast<int>(stream.uniform() * (frame.rows - 4));
        const bool is_apart = std::all_of(crowns.begin(), crowns.end(), [&](const Crown& other) {
            const double apart_m = std::hypot(column - other.column, row - other.row) * frame.cell_width_m;
            return apart_m > radius_m + other.radius_m &&
                   apart_m > 0.5 * std::max(window.width_m(height_m), window.width_m(other.height_m));
        });
        if (is_apart) {
            crowns.push_back({column, row, height_m, radius_m});
        }
    }
    return crowns;
}

std::vector<TreeTop> by_place(std::vector<TreeTop> tops) {
    std::sort(tops.begin(), tops.end(), [](const TreeTop& a, const TreeTop& b) {
        return std::tuple{a.y_m, a.x_m} < std::tuple{b.y_m, b.x_m};
    });
    return tops;
}

void expect_same(std::vector<TreeTop> tops, std::vector<TreeTop> expected) {
    tops = by_place(std::move(tops));
    expected = by_place(std::move(expected));
    ASSERT_EQ(tops.size(), expected.size());
    for (std::size_t i = 0; i < tops.size(); ++i) {
        EXPECT_NEAR(tops[i].x_m, expected[i].x_m, 1e-6);
        EXPECT_NEAR(tops[i].y_m, expected[i].y_m, 1e-6);
        EXPECT_EQ(tops[i].height_m, expected[i].height_m);
    }
}

/// A wood without order: each cell a height of its own, of whole decimetres so that some are equal.
config::Raster<double> rough_wood(std::uint64_t id, double cell_m = 0.5) {
    config::Raster<double> canopy{frame_of(cell_m)};
    config::RandomStream stream{{12, 0, 0, id}, config::Purpose::test};
    for (double& height_m : canopy.values) {
        height_m = std::round(10.0 * 40.0 * stream.uniform()) / 10.0;
    }
    return canopy;
}

config::Raster<double> mirrored(const config::Raster<double>& canopy) {
    config::Raster<double> other{canopy.frame};
    for (std::size_t i = 0; i < canopy.values.size(); ++i) {
        const config::Cell cell = canopy.frame.cell_of(i);
        other.at({canopy.frame.columns - 1 - cell.column, cell.row}) = canopy.values[i];
    }
    return other;
}

TEST(TreeTops, AreAllConesThatStandApartWithTheirHeights) {
    for (const CanopyWindowLaw& window : {window_of_pitkaenen, window_of_popescu}) {
        for (const double cell_m : {0.5, 1.0, 2.0}) {
            const config::GridFrame frame = frame_of(cell_m);
            for (std::uint64_t id = 0; id < 10; ++id) {
                const std::vector<Crown> crowns = random_crowns(id, window, frame);
                std::vector<TreeTop> expected;
                for (const Crown& crown : crowns) {
                    expected.push_back(
                        {frame.x_centre_m(crown.column), frame.y_centre_m(crown.row), crown.height_m});
                }
                const TreeTops found = tree_tops(drawn(crowns, frame), window, least_m);
                expect_same(found.tops, expected);
                EXPECT_EQ(found.beside_unknown, 0U);
            }
        }
    }
}

TEST(TreeTops, MoveWithTheRaster) {
    for (std::uint64_t id = 0; id < 5; ++id) {
        config::Raster<double> canopy = rough_wood(id);
        std::vector<TreeTop> expected = tree_tops(canopy, window_of_pitkaenen, least_m).tops;
        ASSERT_GT(expected.size(), 30U);
        canopy.frame.x_west_m += 1024.0;
        canopy.frame.y_south_m -= 512.0;
        for (TreeTop& top : expected) {
            top.x_m += 1024.0;
            top.y_m -= 512.0;
        }
        expect_same(tree_tops(canopy, window_of_pitkaenen, least_m).tops, expected);
    }
}

TEST(TreeTops, AreMirroredWithTheRasterAlsoWhereHeightsAreEqual) {
    for (std::uint64_t id = 0; id < 5; ++id) {
        const config::Raster<double> canopy = rough_wood(id);
        const double middle_m = canopy.frame.x_west_m + canopy.frame.x_east_m();
        std::vector<TreeTop> expected = tree_tops(canopy, window_of_pitkaenen, least_m).tops;
        for (TreeTop& top : expected) {
            top.x_m = middle_m - top.x_m;
        }
        expect_same(tree_tops(mirrored(canopy), window_of_pitkaenen, least_m).tops, expected);
    }
}

TEST(TreeTops, OfEqualCellsSideBySideAreOneTreeInTheirMiddle) {
    config::Raster<double> canopy{frame_of(0.5), 0.0};
    for (int row = 40; row < 43; ++row) {
        for (int column = 50; column < 54; ++column) {
            canopy.at({column, row}) = 20.0;
        }
    }
    const TreeTops found = tree_tops(canopy, window_of_pitkaenen, least_m);
    ASSERT_EQ(found.tops.size(), 1U);
    EXPECT_DOUBLE_EQ(found.tops[0].x_m, canopy.frame.x_west_m + 52.0 * 0.5);
    EXPECT_DOUBLE_EQ(found.tops[0].y_m, canopy.frame.y_centre_m(41));
}

TEST(TreeTops, AreLostInHolesAndNeverWon) {
    std::size_t lost = 0;
    for (std::uint64_t id = 0; id < 10; ++id) {
        const config::GridFrame frame = frame_of(0.5);
        const config::Raster<double> whole = drawn(random_crowns(id, window_of_pitkaenen, frame), frame);
        config::Raster<double> holed = whole;
        config::RandomStream stream{{13, 0, 0, id}, config::Purpose::test};
        for (int i = 0; i < 12; ++i) {
            const auto west = static_cast<int>(stream.uniform() * 110);
            const auto north = static_cast<int>(stream.uniform() * 80);
            for (int row = north; row < north + 5; ++row) {
                for (int column = west; column < west + 7; ++column) {
                    holed.at({column, row}) = unknown;
                }
            }
        }
        const auto tops = tree_tops(whole, window_of_pitkaenen, least_m).tops;
        const auto left = tree_tops(holed, window_of_pitkaenen, least_m).tops;
        lost += tops.size() - left.size();
        const auto is_in = [](const std::vector<TreeTop>& all, const TreeTop& top) {
            return std::find(all.begin(), all.end(), top) != all.end();
        };
        for (const TreeTop& top : left) {
            EXPECT_TRUE(is_in(tops, top)) << "won at " << top.x_m << ", " << top.y_m;
        }
        for (const TreeTop& top : tops) {
            const config::Cell cell = frame.cell_at(top.x_m, top.y_m);
            bool is_near_hole = false;
            for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
                for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
                    is_near_hole = is_near_hole || std::isnan(holed.at({column, row}));
                }
            }
            EXPECT_EQ(is_in(left, top), !is_near_hole);
        }
    }
    EXPECT_GT(lost, 10U);
}

TEST(TreeTops, OfAPartAreThoseOfTheWhole) {
    const config::Raster<double> whole = rough_wood(3);
    constexpr int margin = 12;  // cells: more than the widest window
    config::GridFrame frame = whole.frame;
    frame.columns = 60;
    frame.rows = 50;
    frame.x_west_m = whole.frame.x_west_m + 20 * 0.5;
    frame.y_south_m = whole.frame.y_south_m + (90 - 10 - 50) * 0.5;
    config::Raster<double> part{frame};
    for (std::size_t i = 0; i < part.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        part.values[i] = whole.at({cell.column + 20, cell.row + 10});
    }
    const auto inside = [&](std::vector<TreeTop> tops) {
        std::erase_if(tops, [&](const TreeTop& top) {
            const config::Cell cell = frame.cell_at(top.x_m, top.y_m);
            return cell.column < margin || cell.row < margin || cell.column >= frame.columns - margin ||
                   cell.row >= frame.rows - margin;
        });
        return tops;
    };
    const auto of_part = inside(tree_tops(part, window_of_pitkaenen, least_m).tops);
    ASSERT_GT(of_part.size(), 5U);
    expect_same(of_part, inside(tree_tops(whole, window_of_pitkaenen, least_m).tops));
}

TEST(TreeTops, BelowTheLeastHeightAreNone) {
    const config::GridFrame frame = frame_of(1.0);
    const config::Raster<double> canopy = drawn({{30, 30, 4.9, 3.0}, {60, 60, 5.0, 3.0}}, frame);
    const TreeTops found = tree_tops(canopy, window_of_pitkaenen, least_m);
    ASSERT_EQ(found.tops.size(), 1U);
    EXPECT_EQ(found.tops[0].height_m, 5.0);
}

TEST(TreeTops, AreNeverNeighboursHoweverWideTheCells) {
    config::Raster<double> canopy{frame_of(2.0), 0.0};  // a window of 2.2 m ends before the next centre
    canopy.at({50, 50}) = 6.0;
    canopy.at({51, 51}) = 5.9;
    const TreeTops found = tree_tops(canopy, window_of_pitkaenen, least_m);
    ASSERT_EQ(found.tops.size(), 1U);
    EXPECT_EQ(found.tops[0].height_m, 6.0);
}

TEST(TreeTops, HaveAWindowAsWideAsTheLawSays) {
    // 20 m high: 4.4 m wide by Pitkänen, so that a lower top 2.5 m away is another tree; 6.1 m by Popescu.
    const config::GridFrame frame = frame_of(0.5);
    const config::Raster<double> canopy = drawn({{50, 50, 20.0, 1.2}, {55, 50, 19.9, 1.2}}, frame);
    EXPECT_EQ(tree_tops(canopy, window_of_pitkaenen, least_m).tops.size(), 2U);
    EXPECT_EQ(tree_tops(canopy, window_of_popescu, least_m).tops.size(), 1U);
}

}  // namespace
}  // namespace coupling::canopy_tops_test
