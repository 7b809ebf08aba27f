#pragma once

#include <span>
#include <string>

#include "coupling/decades/intervention_areas.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::decades {

/// A map for each regime with the ground of its interventions over the hillshade, each row with a colour,
/// pattern of line and entry of the legend. HTML; empty without areas. `with_definitions`: the page has no
/// other maps of this site before.
std::string area_maps(const Site& site, const Management& management, std::span<const InterventionArea> areas,
                      bool with_definitions);

}  // namespace coupling::decades
