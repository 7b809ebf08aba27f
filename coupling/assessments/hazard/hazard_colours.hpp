#pragma once

#include <vector>

#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/results/figures/colours.hpp"

namespace coupling::hazard {

/// Levels from `none` on, in the colours of Swiss hazard maps; the residual one pale, as hatching would be.
const std::vector<ClassColour>& level_colours();

/// Classes of energy, from the first one; those of all other maps where they are three.
std::vector<ClassColour> intensity_colours(const Matrix& matrix);

}  // namespace coupling::hazard
