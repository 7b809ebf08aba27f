#include "rockfall/tally/release_window.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace rockfall::release_window_test {
namespace {

using Energies = std::map<std::size_t, float>;  // by cell

config::GridFrame grid(int columns, int rows, double cell_m) {
    config::GridFrame frame;
    frame.columns = columns;
    frame.rows = rows;
    frame.cell_width_m = cell_m;
    frame.cell_height_m = cell_m;
    return frame;
}

/// Random cells that a rock visits, with its energy there.
std::vector<std::pair<std::size_t, float>> random_visits(const config::GridFrame& frame) {
    const auto last = static_cast<int>(frame.size());
    const auto cells = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, last));
    std::vector<std::pair<std::size_t, float>> visits;
    for (const int cell : cells) {
        visits.emplace_back(static_cast<std::size_t>(cell), static_cast<float>(*rc::gen::inRange(1, 1000)));
    }
    return visits;
}

Energies in_squares(ReleaseWindow& window, const std::vector<std::pair<std::size_t, float>>& visits,
                    const config::GridFrame& frame, CellReach reach) {
    for (const auto& [cell, energy_j] : visits) {
        window.note(cell, energy_j, frame, reach);
    }
    Energies found;
    window.hand_over([&](std::size_t cell, float energy_j) {
        RC_ASSERT(found.emplace(cell, energy_j).second);  // once
    });
    return found;
}

TEST(ReachOfWidth, IsTheSmallestOddNumberOfCellsThatIsSoWide) {
    EXPECT_TRUE(reach_of_width(0.0, grid(9, 9, 5.0)).is_of_one_cell());
    EXPECT_TRUE(reach_of_width(5.0, grid(9, 9, 5.0)).is_of_one_cell());
    EXPECT_EQ(reach_of_width(5.01, grid(9, 9, 5.0)), (CellReach{1, 1}));
    EXPECT_EQ(reach_of_width(15.0, grid(9, 9, 5.0)), (CellReach{1, 1}));
    EXPECT_EQ(reach_of_width(10.0, grid(9, 9, 2.0)), (CellReach{2, 2}));
    EXPECT_EQ(reach_of_width(0.3, grid(9, 9, 0.1)), (CellReach{1, 1}));  // 0.3 / 0.1 is a little below 3
    config::GridFrame flat = grid(9, 9, 5.0);
    flat.cell_height_m = 10.0;
    EXPECT_EQ(reach_of_width(20.0, flat), (CellReach{2, 1}));
}

/// A cell counts the rock if, and with the largest energy that, it has in the square.
RC_GTEST_PROP(ReleaseWindow, CountsWhatComesIntoTheSquare, ()) {
    const config::GridFrame frame = grid(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12), 5.0);
    const CellReach reach{*rc::gen::inRange(0, 4), *rc::gen::inRange(0, 4)};
    ReleaseWindow window;
    for (int rock = 0; rock < 2; ++rock) {  // the second finds nothing of the first
        const auto visits = random_visits(frame);
        Energies expected;
        for (std::size_t cell = 0; cell < frame.size(); ++cell) {
            const config::Cell here = frame.cell_of(cell);
            for (const auto& [visited, energy_j] : visits) {
                const config::Cell there = frame.cell_of(visited);
                if (std::abs(here.column - there.column) <= reach.columns &&
                    std::abs(here.row - there.row) <= reach.rows) {
                    expected[cell] = std::max(expected[cell], energy_j);
                }
            }
        }
        RC_ASSERT(in_squares(window, visits, frame, reach) == expected);
    }
}

/// A square of three cells is a cell three times as wide: its middle counts what that would.
RC_GTEST_PROP(ReleaseWindow, IsAWiderCell, ()) {
    const config::GridFrame fine = grid(9, 9, 5.0);
    const config::GridFrame wide = grid(3, 3, 15.0);
    const auto visits = random_visits(fine);
    std::vector<std::pair<std::size_t, float>> of_wide;
    for (const auto& [cell, energy_j] : visits) {
        const config::Cell here = fine.cell_of(cell);
        of_wide.emplace_back(wide.index({here.column / 3, here.row / 3}), energy_j);
    }
    ReleaseWindow window;
    ReleaseWindow window_of_wide;
    const Energies found = in_squares(window, visits, fine, reach_of_width(15.0, fine));
    const Energies expected = in_squares(window_of_wide, of_wide, wide, reach_of_width(15.0, wide));
    for (std::size_t cell = 0; cell < wide.size(); ++cell) {
        const config::Cell here = wide.cell_of(cell);
        const auto middle = found.find(fine.index({3 * here.column + 1, 3 * here.row + 1}));
        const auto whole = expected.find(cell);
        RC_ASSERT((middle == found.end()) == (whole == expected.end()));
        RC_ASSERT(middle == found.end() || middle->second == whole->second);
    }
}

/// A rock that stands still in a cell came there, too.
TEST(ReleaseWindow, CountsRocksWithoutEnergy) {
    ReleaseWindow window;
    window.note(4, 0.0F, grid(3, 3, 5.0), {1, 1});
    std::size_t cells = 0;
    window.hand_over([&](std::size_t, float) { ++cells; });
    EXPECT_EQ(cells, 9U);
}

}  // namespace
}  // namespace rockfall::release_window_test
