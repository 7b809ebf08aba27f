#pragma once

#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/tree.hpp"

namespace forest {

/// Light of one tree in a stand without places, per stem.
struct LayerLight {
    double absorbed_m2 = 0.0;  ///< ground area whose radiation it absorbs: absorbed [MJ] / radiation [MJ/m2]
    double light_ratio = 1.0;  ///< [0, 1], as in the spatial light model: without its own shade
    double shaded_below_m = 0.0;  ///< height below which its species gets too little light; 0 if nowhere
};

/// Light in a stand where every tree shades every other equally: leaves spread evenly over the area in layers
/// of 1 m, light from five heights of a standard overcast sky.
///
/// A frame of reference for the spatial light model (forest/light): in a dense even-aged stand both must
/// agree. The light ratio is freed of a tree's own shade as in the spatial model, whose cells have 100 m2.
///
/// Requires an area above 0.
std::vector<LayerLight> layer_light(std::span<const Tree> trees, const SpeciesTable& species, double area_m2);

/// Share of a crown's volume below a height [-]: paraboloid or ellipsoid from base to top.
double crown_share_below(CrownShape shape, double base_m, double top_m, double height_m);

}  // namespace forest
