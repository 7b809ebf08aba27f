#include "forest/protection/gaps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::gaps_test {
namespace {

/// Ten metres of map on a slope of 45 degrees.
const double step_m = 10.0 * std::sqrt(2.0);

const PatchGrid slope = square_of_forest(12, 45.0);  // faces south: rows go down the fall line

/// Marks of a rectangle of patches.
std::vector<char> opened(const PatchGrid& grid, int column, int row, int columns, int rows) {
    std::vector<char> open(grid.size(), 0);
    for (std::size_t p = 0; p < grid.size(); ++p) {
        const config::Cell cell = grid.patches()[p].cell;
        open[p] = cell.column >= column && cell.column < column + columns && cell.row >= row &&
                  cell.row < row + rows;
    }
    return open;
}

bool any_patch(const Patch&) {
    return true;
}

TEST(GapsAlongFallLine, OfAClosedForestAreNone) {
    const std::vector<char> closed(slope.size(), 0);
    const std::vector<Gap> gaps = gaps_along_fall_line(slope, closed);
    EXPECT_TRUE(gaps.empty());
    const GapFigures figures = figures_of(slope, closed, gaps, any_patch);
    EXPECT_EQ(figures.max_m, 0.0);
    EXPECT_EQ(figures.patches, 144U);
    EXPECT_EQ(figures.open_patches, 0U);
}

TEST(GapsAlongFallLine, AreAsLongAsASlitStraightDown) {
    const std::vector<char> slit = opened(slope, 5, 3, 1, 5);
    const std::vector<Gap> gaps = gaps_along_fall_line(slope, slit);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_NEAR(gaps[0].length_m, 5.0 * step_m, 1e-9);
    EXPECT_EQ(gaps[0].patches.size(), 5U);
    EXPECT_EQ(slope[gaps[0].patches.front()].cell, (config::Cell{5, 3}));
    EXPECT_EQ(slope[gaps[0].patches.back()].cell, (config::Cell{5, 7}));
}

TEST(GapsAlongFallLine, AreAsShortAsASlitAcrossIsWide) {
    const std::vector<char> slit = opened(slope, 3, 5, 5, 1);
    const std::vector<Gap> gaps = gaps_along_fall_line(slope, slit);
    ASSERT_EQ(gaps.size(), 5U);
    for (const Gap& gap : gaps) {
        EXPECT_NEAR(gap.length_m, step_m, 1e-9);
    }
}

TEST(GapsAlongFallLine, EndWhereTheForestEnds) {
    const std::vector<Gap> gaps = gaps_along_fall_line(slope, opened(slope, 0, 10, 1, 2));
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_NEAR(gaps[0].length_m, 2.0 * step_m, 1e-9);
    // A whole slope without trees: one way down for each column.
    const std::vector<char> bare(slope.size(), 1);
    const GapFigures figures = figures_of(slope, bare, gaps_along_fall_line(slope, bare), any_patch);
    EXPECT_EQ(figures.gaps, 12U);
    EXPECT_NEAR(figures.mean_m, 12.0 * step_m, 1e-9);
}

/// The ground of a slope with another direction, or a valley.
template <class Height>
PatchGrid ground_of(int side, double slope_deg, double aspect_deg, const Height& height_m) {
    const PatchGrid plain = square_of_forest(side, 0.0);
    std::vector<Patch> patches = plain.patches();
    for (Patch& patch : patches) {
        patch.ground_m = height_m(patch.cell);
        patch.slope = config::Angle::from_degrees(slope_deg);
        patch.aspect = config::Angle::from_degrees(aspect_deg);
    }
    return {plain.frame(), patches};
}

TEST(GapsAlongFallLine, FollowASlopeThatRunsObliquelyToTheRows) {
    // It falls to the south-east by 1 a metre: a diagonal step is 14.1 m on the map and 20 m on the ground.
    const PatchGrid oblique = ground_of(8, 45.0, 135.0, [](config::Cell cell) {
        return 1000.0 - 10.0 / std::sqrt(2.0) * (cell.column + cell.row);
    });
    std::vector<char> diagonal(oblique.size(), 0);
    for (int i = 2; i < 5; ++i) {
        diagonal[index_of(*oblique.at(config::Cell{i, i}))] = 1;
    }
    const std::vector<Gap> gaps = gaps_along_fall_line(oblique, diagonal);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_NEAR(gaps[0].length_m, 3.0 * 20.0, 1e-9);
    EXPECT_EQ(gaps_along_fall_line(oblique, opened(oblique, 2, 2, 3, 1)).size(), 3U);
}

TEST(GapsAlongFallLine, RunTogetherInAHollowAndShareItsFloor) {
    // A gully down the middle column; both its sides lead into it.
    const PatchGrid gully = ground_of(5, 0.0, 0.0, [](config::Cell cell) {
        return 1000.0 - 2.0 * cell.row + 20.0 * std::abs(cell.column - 2);
    });
    std::vector<char> open(gully.size(), 0);
    for (const config::Cell cell : {config::Cell{1, 1}, config::Cell{3, 1}, config::Cell{2, 1}, {2, 2}}) {
        open[index_of(*gully.at(cell))] = 1;
    }
    const std::vector<Gap> gaps = gaps_along_fall_line(gully, open);
    ASSERT_EQ(gaps.size(), 2U);
    EXPECT_EQ(gaps[0].patches.back(), gaps[1].patches.back());
    EXPECT_NEAR(gaps[0].length_m, gaps[1].length_m, 1e-9);
}

TEST(FiguresOfGaps, CountAGapWithItsWholeLengthInEachPartThatItTouches) {
    const std::vector<char> slit = opened(slope, 5, 3, 1, 5);
    const std::vector<Gap> gaps = gaps_along_fall_line(slope, slit);
    const auto part = [&](int first_row, int last_row) {
        return figures_of(slope, slit, gaps, [=](const Patch& patch) {
            return patch.cell.row >= first_row && patch.cell.row <= last_row;
        });
    };
    EXPECT_EQ(part(0, 2).gaps, 0U);
    EXPECT_NEAR(part(0, 3).max_m, 5.0 * step_m, 1e-9);
    EXPECT_EQ(part(0, 3).open_patches, 1U);
    EXPECT_NEAR(part(4, 11).max_m, 5.0 * step_m, 1e-9);
}

TEST(FiguresOfGaps, TellThe95thPercentileOfManyGaps) {
    // Twelve columns, of which one is open over five rows and the others over one.
    std::vector<char> open = opened(slope, 0, 0, 12, 1);
    const std::vector<char> slit = opened(slope, 3, 0, 1, 5);
    std::transform(open.begin(), open.end(), slit.begin(), open.begin(),
                   [](char a, char b) { return a | b; });
    const GapFigures figures = figures_of(slope, open, gaps_along_fall_line(slope, open), any_patch);
    EXPECT_EQ(figures.gaps, 12U);
    EXPECT_NEAR(figures.mean_m, 16.0 / 12.0 * step_m, 1e-9);
    EXPECT_NEAR(figures.max_m, 5.0 * step_m, 1e-9);
    // Between the 11th and the 12th of 12, at 0.95 * 11 = 10.45.
    EXPECT_NEAR(figures.p95_m, (1.0 + 0.45 * 4.0) * step_m, 1e-9);
}

TEST(OpenPatches, AreThoseWithoutAStemThatCounts) {
    const SpeciesTable table = SpeciesTable::shipped();
    const PatchGrid grid = square_of_forest(2);
    const SpeciesId spruce = *table.find("piab");
    std::vector<Tree> trees{new_tree(table[spruce], spruce, 5.0, 5.0, 12.0, 10.0, 30.0),
                            new_tree(table[spruce], spruce, 15.0, 15.0, 11.9, 10.0, 30.0)};
    trees[1].id = TreeId{1};
    const Stand stand{grid, table.size(), trees, 2000};
    const std::vector<char> open = open_patches(grid, stand.trees());
    EXPECT_EQ(std::count(open.begin(), open.end(), 0), 1);
    EXPECT_EQ(open[index_of(*grid.at(5.0, 5.0))], 0);
}

}  // namespace
}  // namespace forest::gaps_test
