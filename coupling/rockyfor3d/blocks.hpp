#pragma once

#include <vector>

#include "coupling/rockyfor3d/folder.hpp"

namespace coupling::rockyfor3d {

/// Blocks of one size: a release zone.
struct BlockClass {
    double diameter_m = 0.0;  ///< of the sphere of the same volume
    std::size_t cells = 0;    ///< sources with such blocks
};

/// The sources as Bannwald takes them.
struct Blocks {
    config::Raster<double> zones;     ///< 0 no source, k > 0: blocks of class k; NaN where the DEM has none
    std::vector<BlockClass> classes;  ///< class k at k - 1, from small to large
    double class_width_m = 0.0;       ///< classes are this wide; 0: each size has its own
    double density_kgpm3 = 0.0;       ///< mean over the sources
    double least_density_kgpm3 = 0.0;
    double largest_density_kgpm3 = 0.0;
    std::size_t left_out = 0;  ///< source cells in the two outer rows and columns, which Rockyfor3D ignores

    [[nodiscard]] std::size_t cells() const;
    [[nodiscard]] double mean_diameter_m() const;  ///< over the sources
};

/// Diameter of the sphere that has the volume of a block [m]: rectangular d1 d2 d3, ellipsoid and sphere pi/6
/// of that, disc pi/4.
double equal_volume_diameter_m(double d1_m, double d2_m, double d3_m, int shape);

/// Sizes to the centimetre; more than `most_classes` of them come into classes of equal width. Throws
/// InputError (data) if no source is left.
Blocks blocks_of(const Folder& folder, std::size_t most_classes = 20);

}  // namespace coupling::rockyfor3d
