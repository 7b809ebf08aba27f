#pragma once

#include <optional>

#include "coupling/inputs/plausible/terrain/finding.hpp"
#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// Share of exactly level neighbours among those where the ground around rises from one to the other [-];
/// 0 where too little ground rises.
double level_share(const HeightField& field);

/// Steps: terraces of rounded heights or contours, blocks of nearest-neighbour resampling. Lakes and roads
/// are level all around and do not count.
std::optional<Finding> judge_steps(const HeightField& field);

}  // namespace coupling::plausible::terrain
