#pragma once

#include <optional>

#include "coupling/inputs/plausible/terrain/finding.hpp"
#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// The strongest stripes of a field; zeros where no blocks agree.
struct Stripes {
    double agreement = 0.0;  ///< of four blocks of a line in the sign of its residual, chance 0, certainty 1
    double step = 0.0;       ///< between neighbouring lines over their distance [-]
    double step_m = 0.0;
};

/// Looks for stripes along rows, along columns and at 20 and 45 degrees to them. Every height is taken
/// against moving averages across the lines (windows of 3 to 17 cells), cut off at twice their median so that
/// cliffs count little, and averaged along a line in four blocks. On ground the blocks know nothing of each
/// other.
Stripes strongest_stripes(const HeightField& field);

/// Stripes of flight strips, of resampling and of damaged lines, of periods of 2 to 20 cells.
std::optional<Finding> judge_stripes(const HeightField& field);

}  // namespace coupling::plausible::terrain
