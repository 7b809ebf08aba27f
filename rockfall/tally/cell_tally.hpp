#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "config/grid/raster.hpp"
#include "rockfall/tally/cell_releases.hpp"
#include "rockfall/tally/cell_spread.hpp"
#include "rockfall/tally/release_window.hpp"
#include "rockfall/tally/zeroed_list.hpp"

namespace rockfall {

/// The largest values of one rock inside one cell.
struct CellVisit {
    std::uint32_t cell;
    float energy_j;  ///< translation and rotation
    float speed_mps;
    float height_m;           ///< of the underside above the ground, normal to the slope
    float energy_line_slope;  ///< smallest tangent of the angle from the release point down to the ground
                              ///< here [-]
    std::uint32_t tree_impacts;
};

/// What all rocks left in one cell. Sums are whole numbers: they add up the same in any order. All bytes of
/// a cell that no rock reached are zero (ZeroedList).
struct CellSums {
    std::uint32_t passages = 0;  ///< rocks, each counted once
    std::uint32_t deposited = 0;
    std::uint32_t tree_impacts = 0;
    std::uint32_t fed_by = 0;  ///< one more than the source that fed the cell last, while counting
    std::uint64_t energy_sum_j = 0;
    std::uint64_t speed_sum_mmps = 0;
    std::uint64_t height_sum_mm = 0;
    std::uint64_t fed_rocks = 0;  ///< rocks released from the sources that feed the cell
    float energy_max_j = 0.0F;
    float speed_max_mps = 0.0F;
    float height_max_m = 0.0F;
    float energy_line_slope_min = 0.0F;  ///< of the passages; of none it says nothing

    void add(const CellVisit& visit) {
        energy_line_slope_min = passages == 0 ? visit.energy_line_slope
                                              : std::min(energy_line_slope_min, visit.energy_line_slope);
        ++passages;
        tree_impacts += visit.tree_impacts;
        energy_sum_j += nearest(visit.energy_j);
        speed_sum_mmps += nearest(1000.0F * visit.speed_mps);
        height_sum_mm += nearest(1000.0F * visit.height_m);
        energy_max_j = std::max(energy_max_j, visit.energy_j);
        speed_max_mps = std::max(speed_max_mps, visit.speed_mps);
        height_max_m = std::max(height_max_m, visit.height_m);
    }

    /// The nearest whole number of one that is not negative. As std::lround, which is a call on old
    /// processors.
    static std::uint64_t nearest(float value) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<double>(value) + 0.5));
    }

    /// Adds what another worker counted; which sources fed a cell must not be split between workers.
    void add(const CellSums& other) {
        if (other.passages > 0) {
            energy_line_slope_min = passages == 0
                                        ? other.energy_line_slope_min
                                        : std::min(energy_line_slope_min, other.energy_line_slope_min);
        }
        passages += other.passages;
        deposited += other.deposited;
        tree_impacts += other.tree_impacts;
        energy_sum_j += other.energy_sum_j;
        speed_sum_mmps += other.speed_sum_mmps;
        height_sum_mm += other.height_sum_mm;
        fed_rocks += other.fed_rocks;
        energy_max_j = std::max(energy_max_j, other.energy_max_j);
        speed_max_mps = std::max(speed_max_mps, other.speed_max_mps);
        height_max_m = std::max(height_max_m, other.height_max_m);
    }
};

/// A grid of sums, row by row from the north-west.
struct CellTally {
    config::GridFrame frame;
    ZeroedList<CellSums> cells;
    /// By cell the repeats in which a rock passed, a bit for each; empty where rocks are not shared out.
    ZeroedList<std::uint64_t> repeats;
    ZeroedList<CellSpread> spread;      ///< by cell; empty where it is not asked for
    ZeroedList<CellReleases> releases;  ///< by cell; empty where it is not asked for
    ReleaseWindow window;               ///< of the rock that is being entered; no part of sums

    explicit CellTally(const config::GridFrame& frame_in) : frame{frame_in}, cells(frame_in.size()) {}

    void add(const CellTally& other) {
        // Where the other has nothing, nothing is written: a sum of zeros would take memory.
        add_blocks(cells, other.cells, [](CellSums& sum, const CellSums& more) { sum.add(more); });
        repeats.grow_to(other.repeats.size());
        add_blocks(repeats, other.repeats, [](std::uint64_t& sum, std::uint64_t more) { sum |= more; });
        spread.grow_to(other.spread.size());
        add_blocks(spread, other.spread, [](CellSpread& sum, const CellSpread& more) { sum.add(more); });
        releases.grow_to(other.releases.size());
        add_blocks(releases, other.releases,
                   [](CellReleases& sum, const CellReleases& more) { sum.add(more); });
    }

private:
    template <class Value, class Add>
    static void add_blocks(ZeroedList<Value>& to, const ZeroedList<Value>& from, Add add_to) {
        from.for_each_block([&](std::size_t begin, std::size_t count) {
            for (std::size_t i = begin; i < begin + count; ++i) {
                add_to(to[i], from[i]);
            }
        });
    }
};

}  // namespace rockfall
