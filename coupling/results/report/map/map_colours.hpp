#pragma once

#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/report/map/scale.hpp"

namespace coupling::report {

// How the maps of pages choose their colours.

/// NaN in place of 0: where nothing is, nothing is drawn.
config::Raster<float> without_zeros(config::Raster<float> raster);
/// A value that all but the largest hundredth (of what is not 0) stay below, so that single cells do not rule
/// the colours.
double bulk_of(const config::Raster<float>& raster);
/// The scale of a quantity over values without zeros.
ColourScale scale_for(const RasterKind& kind, ValueRange range);

}  // namespace coupling::report
