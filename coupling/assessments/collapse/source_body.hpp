#pragma once

#include <optional>

#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/rock_mass/body.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling::collapse {

/// The rock that breaks up: its border, its box and its volume where that is known beforehand.
struct SourceBody {
    rockfall::rock_mass::Body body;
    Eigen::Vector3d low_m;
    Eigen::Vector3d high_m;
};

/// What collapse.source or collapse.mesh names, clipped to the terrain. Throws InputError (data) for polygons
/// off the terrain, surfaces with holes, and bodies that do not reach the ground's surface.
SourceBody read_source(const CollapseScenario& scenario, const rockfall::Terrain& terrain, Reading& reading);

}  // namespace coupling::collapse
