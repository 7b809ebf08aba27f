#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/tally/cell_spread.hpp"

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

/// What all rocks left in one cell. Sums are whole numbers: they add up the same in any order.
struct CellSums {
    std::uint32_t passages = 0;  ///< rocks, each counted once
    std::uint32_t deposited = 0;
    std::uint32_t tree_impacts = 0;
    std::uint32_t last_source = 0xFFFFFFFFU;  ///< source that fed the cell last, while counting
    std::uint64_t energy_sum_j = 0;
    std::uint64_t speed_sum_mmps = 0;
    std::uint64_t height_sum_mm = 0;
    std::uint64_t fed_rocks = 0;  ///< rocks released from the sources that feed the cell
    float energy_max_j = 0.0F;
    float speed_max_mps = 0.0F;
    float height_max_m = 0.0F;
    float energy_line_slope_min = std::numeric_limits<float>::infinity();

    void add(const CellVisit& visit) {
        ++passages;
        tree_impacts += visit.tree_impacts;
        energy_sum_j += nearest(visit.energy_j);
        speed_sum_mmps += nearest(1000.0F * visit.speed_mps);
        height_sum_mm += nearest(1000.0F * visit.height_m);
        energy_max_j = std::max(energy_max_j, visit.energy_j);
        speed_max_mps = std::max(speed_max_mps, visit.speed_mps);
        height_max_m = std::max(height_max_m, visit.height_m);
        energy_line_slope_min = std::min(energy_line_slope_min, visit.energy_line_slope);
    }

    /// The nearest whole number of one that is not negative. As std::lround, which is a call on old
    /// processors.
    static std::uint64_t nearest(float value) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<double>(value) + 0.5));
    }

    /// Adds what another worker counted; which sources fed a cell must not be split between workers.
    void add(const CellSums& other) {
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
        energy_line_slope_min = std::min(energy_line_slope_min, other.energy_line_slope_min);
    }
};

/// A grid of sums, row by row from the north-west.
struct CellTally {
    config::GridFrame frame;
    std::vector<CellSums> cells;
    /// By cell the repeats in which a rock passed, a bit for each; empty where rocks are not shared out.
    std::vector<std::uint64_t> repeats;
    std::vector<CellSpread> spread;  ///< by cell; empty where it is not asked for

    explicit CellTally(const config::GridFrame& frame_in) : frame{frame_in}, cells(frame_in.size()) {}

    void add(const CellTally& other) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            cells[i].add(other.cells[i]);
        }
        repeats.resize(std::max(repeats.size(), other.repeats.size()));
        for (std::size_t i = 0; i < other.repeats.size(); ++i) {
            repeats[i] |= other.repeats[i];
        }
        spread.resize(std::max(spread.size(), other.spread.size()));
        for (std::size_t i = 0; i < other.spread.size(); ++i) {
            spread[i].add(other.spread[i]);
        }
    }
};

}  // namespace rockfall
