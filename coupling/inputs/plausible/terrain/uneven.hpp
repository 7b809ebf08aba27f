#pragma once

#include <optional>

#include "coupling/inputs/plausible/terrain/finding.hpp"
#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// How much slopes change from neighbour to neighbour.
struct Unevenness {
    double ratio = 0.0;  ///< mean |second difference| over mean |first difference| [-]
    double bend = 0.0;   ///< mean |second difference| over the distance [-]
};

/// Of neighbours `lag` cells apart, along rows and columns together; zeros with too few cells.
Unevenness unevenness(const HeightField& field, int lag);

/// Whole numbers from 0 to 255 that are a picture: all of that range, or as uneven as no ground.
std::optional<Finding> judge_pictures(const HeightField& field);

/// Heights that are none, such as slopes, speeds or distances, and surface models with crowns. On bare ground
/// a cell is nearly as steep as the one beside it; in these the slope changes by its own size from cell to
/// cell. Single spikes do not count.
std::optional<Finding> judge_unevenness(const HeightField& field);

/// Values that run through their whole range again and again, on slopes: results of other models.
std::optional<Finding> judge_ups_and_downs(const HeightField& field);

}  // namespace coupling::plausible::terrain
