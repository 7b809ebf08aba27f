#pragma once

#include "config/units/angle.hpp"
#include "validation/engine/forest_cases/plain_3pg/stand.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// Light absorbed by each species as if it were alone, over the share of ground that a young stand covers
/// [Landsberg & Waring 1997].
void absorb_as_one_canopy(Stand& stand, const Inputs& inputs, const ClimateMonth& month);

/// Light absorbed by crowns in layers: species whose crowns overlap in height share a layer, the next lower
/// layer receives what it leaves [Forrester et al. 2014, For. Ecosyst. 1:17].
void absorb_by_layers(Stand& stand, const Inputs& inputs, const ClimateMonth& month);

/// Crown surface and volume of a mean tree.
struct CrownBody {
    double surface_m2 = 0.0;
    double volume_m3 = 0.0;
};
CrownBody crown_body(CrownForm form, double width_m, double length_m);

/// Layer of each of some crowns, 1 for the highest: crowns belong together if their heights overlap, directly
/// or through others.
std::vector<int> layers_of(std::span<const double> crown_bases_m, std::span<const double> heights_m);

/// The angle that r3PG takes for the sun's distance from the zenith at noon, in degrees.
///
/// r3PG changes the sign of the latitude, so that in either hemisphere the sun stands low in summer: at 47
/// degrees north 70 in June and 24 in December. It is kept here because this run is held against r3PG.
double noon_angle_deg(config::Angle latitude, int month);

}  // namespace coupling::validation::forest_cases::plain_3pg
