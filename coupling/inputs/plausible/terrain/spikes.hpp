#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coupling/inputs/plausible/terrain/finding.hpp"
#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// Cells, or groups of up to four, that stand above, or lie below, all their neighbours.
struct Spikes {
    std::size_t peaks = 0;
    std::size_t pits = 0;
    double highest_m = 0.0;  ///< of a peak over its neighbours
    double deepest_m = 0.0;
    std::size_t first_peak = 0;  ///< index of the cell, from the north-west
    std::size_t first_pit = 0;
};

/// By more than 3 cells and 5 m, with at least five known neighbours. Cells of exactly 0 are left to
/// the rule on NODATA.
Spikes spikes_of(const HeightField& field);

/// Indices of these cells.
std::vector<std::size_t> spike_cells(const HeightField& field);

/// A field without its spikes, which have a rule of their own, and on request without heights of exactly 0,
/// which may stand for unknown ground. Requires that the field outlives it.
class WithoutSpikes {
public:
    explicit WithoutSpikes(const HeightField& whole, bool without_zeros = false);
    WithoutSpikes(const WithoutSpikes&) = delete;
    WithoutSpikes& operator=(const WithoutSpikes&) = delete;

    [[nodiscard]] const HeightField& field() const { return field_; }

private:
    std::vector<double> heights_m_;  ///< empty where nothing is left out
    HeightField field_;
};

/// Single wrong cells: reflections and birds in a laser scan, damaged values. Where none stands above, or
/// lies below, its neighbours as spikes_of() asks, lower ones: a cell that is bent by 3 m or more in all
/// directions, and either 3.5 times as much as any cell within four cells of it, or more than any of these
/// and 6 times the root of their mean square.
std::optional<Finding> judge_spikes(const HeightField& field);

}  // namespace coupling::plausible::terrain
