#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "config/random/stream.hpp"
#include "forest/light/light.hpp"

namespace stands {

/// Radiation of a year with more sun in summer.
inline forest::LightYear year() {
    forest::LightYear year;
    for (std::size_t month = 0; month < 12; ++month) {
        const double summer = 5.5 - std::abs(static_cast<double>(month) - 5.5);
        year.radiation.direct_mjpm2[month] = 80.0 + 40.0 * summer;
        year.radiation.diffuse_mjpm2[month] = 90.0 + 30.0 * summer;
    }
    return year;
}

inline forest::Sky sky() {
    forest::SkySettings settings;
    settings.latitude = config::Angle::from_degrees(47.0);
    return {settings, year().radiation};
}

/// A plane of square columns of 10 m that rises by the two gradients along x and y.
inline forest::LightGround plane(int columns, int rows, double rise_x, double rise_y,
                                 forest::Edges edges = forest::Edges::torus, double column_m = 10.0) {
    forest::LightGround ground;
    ground.elevation_m = config::Raster<double>{{columns, rows, 0.0, 0.0, column_m, column_m}};
    ground.edges = edges;
    const config::GridFrame& frame = ground.elevation_m.frame;
    ground.gain_x_m = rise_x * frame.x_east_m();
    ground.gain_y_m = rise_y * frame.y_north_m();
    for (std::size_t cell = 0; cell < frame.size(); ++cell) {
        const config::Cell at = frame.cell_of(cell);
        ground.elevation_m.values[cell] =
            rise_x * frame.x_centre_m(at.column) + rise_y * frame.y_centre_m(at.row);
    }
    return ground;
}

inline forest::LightSite site(const forest::LightGround& ground, const forest::LightSettings& settings = {}) {
    return {sky(), ground, forest::exposures_of(ground, {}), settings};
}

/// Trees at random places of an area, of all sizes.
inline std::vector<forest::LightTree> random_trees(config::RandomStream& stream, std::size_t count,
                                                   double width_m, double height_m, bool deciduous = false) {
    std::vector<forest::LightTree> trees(count);
    for (forest::LightTree& tree : trees) {
        tree.x_m = width_m * stream.uniform();
        tree.y_m = height_m * (1.0 - stream.uniform());
        tree.height_m = 2.0 + 33.0 * stream.uniform();
        tree.crown_base_m = tree.height_m * 0.7 * stream.uniform();
        tree.crown_radius_m = 0.5 + 0.1 * tree.height_m * stream.uniform();
        tree.leaf_area_m2 = 0.2 * tree.height_m * tree.height_m * stream.uniform();
        tree.shape = stream.uniform() < 0.5 ? forest::CrownShape::paraboloid : forest::CrownShape::ellipsoid;
        tree.deciduous = deciduous && stream.uniform() < 0.5;
    }
    return trees;
}

inline forest::LightField light(const forest::LightSite& site, const std::vector<forest::LightTree>& trees) {
    return forest::compute_light(site, forest::Canopy{site.ground(), trees}, year(), trees);
}

/// Leaves of an even depth: in every column one slab from the ground to the top of a layer.
inline std::vector<forest::LightTree> even_leaves(const config::GridFrame& frame, double leaf_area_index,
                                                  int layers, double extinction) {
    std::vector<forest::LightTree> trees;
    for (std::size_t cell = 0; cell < frame.size(); ++cell) {
        const config::Cell at = frame.cell_of(cell);
        for (int layer = 0; layer < layers; ++layer) {
            forest::LightTree slab;
            slab.x_m = frame.x_centre_m(at.column);
            slab.y_m = frame.y_centre_m(at.row);
            slab.crown_base_m = forest::layer_height_m * layer;
            slab.height_m = forest::layer_height_m * (layer + 1);
            // Without radius an ellipsoid is one stick, the same from below to above.
            slab.leaf_area_m2 = leaf_area_index * frame.cell_area_m2() / layers;
            slab.extinction = extinction;
            slab.shape = forest::CrownShape::ellipsoid;
            trees.push_back(slab);
        }
    }
    return trees;
}

}  // namespace stands
