#pragma once

#include <filesystem>

#include "config/grid/raster.hpp"

namespace coupling {

/// A raster of finished results, as rasters.cpp wrote it. Throws config::InputError: (file) where there is
/// none, (data) for what is no grid.
config::Raster<float> read_raster(const std::filesystem::path& file);

}  // namespace coupling
