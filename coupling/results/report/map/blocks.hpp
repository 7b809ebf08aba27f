#pragma once

#include "config/grid/raster.hpp"

namespace coupling::report {

/// Blocks of `block` x `block` cells: of each the value farthest from 0, NaN where all are.
config::Raster<float> in_blocks(const config::Raster<float>& raster, int block);

}  // namespace coupling::report
