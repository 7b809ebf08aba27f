#pragma once

#include <cstddef>

#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// In how many places walls rise within one or two cells of more than about a metre: such cells lean them, so
/// that rocks land too far out. Noise of this standard deviation makes no wall. No fault of the heights,
/// hence no rule of the gate.
std::size_t narrow_walls(const HeightField& field, double noise_m);

}  // namespace coupling::plausible::terrain
