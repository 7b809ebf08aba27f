#pragma once

#include "config/grid/raster.hpp"
#include "config/units/angle.hpp"
#include "coupling/results/report/map/png.hpp"

namespace coupling::report {

/// Where the light of a hillshade comes from.
struct Light {
    config::Angle azimuth = config::Angle::from_degrees(315.0);  ///< clockwise from north
    config::Angle altitude = config::Angle::from_degrees(45.0);  ///< above the horizon
};

/// Cosine of the angle between the light and the ground's normal [0, 1]; NaN without heights.
///
/// Slopes by the weighted 3 x 3 differences of Horn (1981, Proc. IEEE 69:14). A neighbour without height, and
/// beyond the rim, continues the surface with the height of the cell itself.
config::Raster<float> illumination(const config::Raster<double>& heights_m, const Light& light = {});

/// Illumination as a bright grey that lets colours multiplied over it stay readable; no heights: white.
GreyPicture hillshade(const config::Raster<float>& illumination);

}  // namespace coupling::report
