#include "rockfall/tally/zeroed_list.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "rockfall/tally/cell_tally.hpp"

namespace rockfall::zeroed_list_test {
namespace {

/// Memory of this process that is there, in bytes.
std::size_t resident_bytes() {
    std::ifstream in{"/proc/self/statm"};
    std::size_t all = 0;
    std::size_t resident = 0;
    in >> all >> resident;
    constexpr std::size_t page_bytes = 4096;
    return resident * page_bytes;
}

/// A cell that no rock reached, as a list begins with it.
TEST(ZeroedList, BeginsWithCellsThatNoRockReached) {
    const ZeroedList<CellSums> cells{3};
    const CellSums none;
    EXPECT_EQ(std::memcmp(&cells[1], &none, sizeof none), 0);
    const ZeroedList<CellSpread> spread{2};
    const CellSpread no_spread;
    EXPECT_EQ(std::memcmp(&spread[1], &no_spread, sizeof no_spread), 0);
}

RC_GTEST_PROP(ZeroedList, IsAListOfValuesThatCanBeCopiedMovedAndEnlarged, ()) {
    const auto written = *rc::gen::container<std::vector<std::uint64_t>>(rc::gen::element(0U, 0U, 0U, 7U));
    ZeroedList<std::uint64_t> list{written.size()};
    std::copy(written.begin(), written.end(), list.begin());
    const ZeroedList<std::uint64_t> copy = list;
    RC_ASSERT(std::vector<std::uint64_t>(copy.begin(), copy.end()) == written);

    std::vector<std::uint64_t> enlarged = written;
    enlarged.resize(written.size() + *rc::gen::inRange<std::size_t>(0, 200));
    list.grow_to(enlarged.size());
    RC_ASSERT(std::vector<std::uint64_t>(list.begin(), list.end()) == enlarged);
    list.grow_to(0);
    RC_ASSERT(list.size() == enlarged.size());

    const ZeroedList<std::uint64_t> moved = std::move(list);
    std::vector<std::uint64_t> by_blocks(moved.size());
    moved.for_each_block([&](std::size_t from, std::size_t count) {
        std::copy_n(moved.begin() + from, count, by_blocks.begin() + static_cast<std::ptrdiff_t>(from));
    });
    RC_ASSERT(by_blocks == enlarged);
}

/// 25 km2 at 1 m, of which rocks reached a hectare: 64 bytes a cell would be 1.6 GB for each of the maps.
TEST(CellTally, TakesMemoryOnlyWhereRocksWere) {
    constexpr int side = 5000;
    constexpr std::size_t reached = 10'000;
    const config::GridFrame frame{.columns = side, .rows = side, .cell_width_m = 1.0, .cell_height_m = 1.0};
    const std::size_t before = resident_bytes();
    CellTally one{frame};
    for (std::uint32_t cell = 0; cell < reached; ++cell) {
        one.cells[cell].add(CellVisit{cell, 1.0F, 1.0F, 1.0F, 1.0F, 0});
    }
    one.spread.grow_to(one.cells.size());
    CellTally all{frame};
    all.add(one);
    const CellTally copy = all;
    EXPECT_EQ(copy.cells[reached - 1].passages, 1U);
    EXPECT_EQ(copy.cells[reached].passages, 0U);
    const std::size_t after = resident_bytes();
    // Three lists of the hectare; a system that gives memory by 2 MB gives some more.
    EXPECT_LT(after, before + 3 * reached * sizeof(CellSums) + 64'000'000);
}

TEST(CellSums, KeepTheSmallestEnergyLineOfPassagesAlone) {
    CellSums sums;
    sums.add(CellVisit{0, 1.0F, 1.0F, 0.0F, 0.8F, 0});
    sums.add(CellVisit{0, 1.0F, 1.0F, 0.0F, 0.6F, 0});
    EXPECT_EQ(sums.energy_line_slope_min, 0.6F);
    CellSums all;
    all.add(CellSums{});
    all.add(sums);
    all.add(CellSums{});
    EXPECT_EQ(all.energy_line_slope_min, 0.6F);
}

}  // namespace
}  // namespace rockfall::zeroed_list_test
