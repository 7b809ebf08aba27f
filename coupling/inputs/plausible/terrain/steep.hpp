#pragma once

#include <optional>

#include "coupling/inputs/plausible/terrain/finding.hpp"
#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// Shares of the cells by slope, of central differences [-].
struct SlopeShares {
    std::size_t cells = 0;
    double above_45_deg = 0.0;
    double above_60_deg = 0.0;
    double above_75_deg = 0.0;
    bool has_texture = false;  ///< not made of even planes, of which nothing follows
};

SlopeShares slope_shares(const HeightField& field);

/// Slopes that no ground with a runout has: heights in feet or decimetres, or cells in kilometres. An even
/// plane may be as steep as it likes. Gentle ground in feet is not seen: it looks like a steeper slope.
std::optional<Finding> judge_steepness(const HeightField& field);

/// Cells too large for cliffs and benches.
std::optional<Finding> judge_cell_size(const HeightField& field);

}  // namespace coupling::plausible::terrain
