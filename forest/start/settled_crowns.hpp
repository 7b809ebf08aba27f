#pragma once

#include <span>

#include "forest/stand/species.hpp"
#include "forest/stand/tree.hpp"

namespace forest {

/// Gives trees of unknown past the crowns that they would have kept in their own shade.
///
/// A crown of usual length holds more leaves than a closed stand can feed. Its base is therefore raised as
/// forest/stand/crown.hpp does over the years, until light and crowns agree: light by layers of the trees on
/// the area (forest/light/layer_light.hpp), 20 rounds of at most 0.6 m [choice]. Masses follow. Requires an
/// area above 0.
void settle_crowns(std::span<Tree> trees, const SpeciesTable& species, double area_m2);

}  // namespace forest
