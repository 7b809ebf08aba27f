#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "rockfall/solids/block_shape.hpp"

namespace rockfall {
struct Parameters;
}

namespace coupling {

/// Shapes of the rocks as users write them: [release], or columns of the sources.
struct ShapeSettings {
    std::string shape = "sphere";  ///< names, box, rounded or hull, separated by commas
    std::vector<double> shares;    ///< of the rocks, one for each shape; empty: equal
    std::vector<double> sides;     ///< of a box, rounded box or ellipsoid, relative to each other
    std::vector<double> sides_m;   ///< of a box, rounded box or ellipsoid, as they are
    double sides_scatter = 0.0;
    std::string file;              ///< of a hull: points as CSV, PLY or STL
    bool keeps_size = false;       ///< the hull is as large as in its file
    std::vector<double> attitude;  ///< quaternion (w, x, y, z) or matrix, row by row; empty: at random
};

/// Whether the chosen motion model gives rocks a shape (release.shape).
bool rocks_have_shapes(const rockfall::Parameters& rockfall);

/// Declares release.shape and what belongs to it.
void declare_shapes(config::Options& options, ShapeSettings& settings);

/// The place of a setting such as "shape_file", for messages.
using PlaceOfSetting = std::function<config::Place(const std::string&)>;

/// What the settings say; null where all rocks are spheres. Problems are added, one for each fault: names
/// that no shape has, sides of 0, hulls that are flat or inverted or have too few points, attitudes that are
/// no rotation.
std::shared_ptr<const rockfall::ShapeLaw> shape_law(
    const ShapeSettings& settings, const PlaceOfSetting& place,
    const std::function<std::filesystem::path(const std::string&)>& resolve, config::Problems& problems);

/// The hull of a file: a table of points x_m, y_m, z_m; a PLY or STL mesh, which must be closed, convex and
/// face outwards. Throws InputError.
rockfall::solids::Hull read_hull(std::string_view bytes, const std::string& file);

}  // namespace coupling
