#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "coupling/inputs/rockyfor3d/folder.hpp"

namespace coupling::rockyfor3d {

/// Shapes of blocks, numbered as in blshape.
enum class BlockForm : std::uint8_t { rectangular = 1, ellipsoid = 2, sphere = 3, disc = 4 };

/// Blocks of one shape and size: a release zone.
struct BlockClass {
    double diameter_m = 0.0;  ///< of the sphere of the same volume
    std::size_t cells = 0;    ///< sources with such blocks
    BlockForm form = BlockForm::sphere;
    std::array<double, 3> sides_m{};  ///< longest first, means over the sources
    double density_kgpm3 = 0.0;       ///< mean over the sources
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
    /// Whether all blocks are spheres of one size and density, so that a grid of sources says all.
    [[nodiscard]] bool are_equal_spheres() const;
};

/// Diameter of the sphere that has the volume of a block [m]: rectangular d1 d2 d3, ellipsoid and sphere pi/6
/// of that, disc pi/4.
double equal_volume_diameter_m(double d1_m, double d2_m, double d3_m, int shape);

/// "box", "ellipsoid", "sphere" or "hull" (a disc): the shape as sources.csv names it.
const char* name_of(BlockForm form);

/// The corners of a disc as a hull (CSV of x_m, y_m, z_m): two polygons of 16 corners.
std::string disc_hull(const std::array<double, 3>& sides_m);

/// The sources as polygons, a row for each class with its zone, size, density and shape: what
/// release.source_shapes reads. Discs have the hull file `disc_K.csv` of their zone K.
std::string sources_csv(const Blocks& blocks);

/// Sizes to the centimetre; more than `most_classes` of them come into classes of equal width. Throws
/// InputError (data) if no source is left.
Blocks blocks_of(const Folder& folder, std::size_t most_classes = 20);

}  // namespace coupling::rockyfor3d
