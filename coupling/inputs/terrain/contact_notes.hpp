#pragma once

#include "coupling/inputs/terrain/surface_input.hpp"
#include "rockfall/terrain/contact_zone.hpp"

namespace coupling {

/// Notes for each ground type how large the noise of the heights is there and within what radius rocks
/// therefore feel the ground as a plane: means over its cells. Nothing where the radius is given. Warns of
/// grids whose cells are too wide for the walls in them.
void note_contact_zone(const HeightInput& heights, const GroundMap& ground, const rockfall::ContactLaw& law,
                       Reading& reading);

}  // namespace coupling
