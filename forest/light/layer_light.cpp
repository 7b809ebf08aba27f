#include "forest/light/layer_light.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "config/math/elementary.hpp"

namespace forest {

namespace {

constexpr double layer_m = 1.0;
constexpr double cell_area_m2 = 100.0;  // of the spatial light model

/// A band of the sky: sine of its elevation and its share in the light on a horizontal plane.
struct Band {
    double sine;
    double share;
};

// Bands of 18 degrees of the standard overcast sky, share = 6/7 [(s2^2 - s1^2)/2 + 2/3 (s2^3 - s1^3)].
constexpr std::array<Band, 5> bands = {{{0.156434, 0.057787},
                                        {0.453990, 0.206324},
                                        {0.707107, 0.318969},
                                        {0.891007, 0.296132},
                                        {0.987688, 0.120789}}};

/// Sums over bands of the light transmitted through an optical depth, which is that of vertical rays.
struct Transmitted {
    double flat = 0.0;    ///< share of the light on a horizontal plane
    double normal = 0.0;  ///< share of the light on planes at right angles to the rays
};

Transmitted transmitted(double depth) {
    Transmitted sum;
    double normal_weight = 0.0;
    for (const Band& band : bands) {
        const double through = config::exp_of(-std::min(depth / band.sine, 50.0));
        sum.flat += band.share * through;
        sum.normal += band.share / band.sine * through;
        normal_weight += band.share / band.sine;
    }
    sum.normal /= normal_weight;
    return sum;
}

/// Light at the tops, middles and bottoms of layers.
struct LayersByHeight {
    std::vector<double> leaf_depth;     ///< sum of extinction times leaf area index in the layer
    std::vector<double> absorbed;       ///< share of the light on a horizontal plane
    std::vector<double> in_the_middle;  ///< share of the light at right angles to the rays
};

LayersByHeight layers_of(std::span<const Tree> trees, const SpeciesTable& species, double area_m2) {
    double top_m = 0.0;
    for (const Tree& tree : trees) {
        top_m = std::max(top_m, tree.height_m);
    }
    const auto count = static_cast<std::size_t>(std::ceil(top_m / layer_m));
    LayersByHeight layers{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
    for (const Tree& tree : trees) {
        const Species& kind = species[tree.species];
        const double depth = kind.light.extinction * tree.stems * tree.crown.leaf_area_m2 / area_m2;
        double below = 0.0;
        for (auto l = static_cast<std::size_t>(tree.crown.base_m / layer_m); l < count && below < 1.0; ++l) {
            const double share = crown_share_below(kind.crown.shape, tree.crown.base_m, tree.height_m,
                                                   static_cast<double>(l + 1) * layer_m);
            layers.leaf_depth[l] += depth * (share - below);
            below = share;
        }
    }
    double above = 0.0;
    for (std::size_t l = count; l-- > 0;) {
        const double below = above + layers.leaf_depth[l];
        layers.absorbed[l] = transmitted(above).flat - transmitted(below).flat;
        layers.in_the_middle[l] = transmitted(0.5 * (above + below)).normal;
        above = below;
    }
    return layers;
}

}  // namespace

double crown_share_below(CrownShape shape, double base_m, double top_m, double height_m) {
    const double u = std::clamp((height_m - base_m) / (top_m - base_m), 0.0, 1.0);
    return shape == CrownShape::paraboloid ? 1.0 - (1.0 - u) * (1.0 - u) : u * u * (3.0 - 2.0 * u);
}

std::vector<LayerLight> layer_light(std::span<const Tree> trees, const SpeciesTable& species,
                                    double area_m2) {
    assert(area_m2 > 0.0);
    const LayersByHeight layers = layers_of(trees, species, area_m2);
    std::vector<LayerLight> light(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Tree& tree = trees[i];
        const Species& kind = species[tree.species];
        const double depth = kind.light.extinction * tree.crown.leaf_area_m2 / area_m2;
        double mean_light = 0.0;
        double below = 0.0;
        for (auto l = static_cast<std::size_t>(tree.crown.base_m / layer_m);
             l < layers.leaf_depth.size() && below < 1.0; ++l) {
            const double share = crown_share_below(kind.crown.shape, tree.crown.base_m, tree.height_m,
                                                   static_cast<double>(l + 1) * layer_m);
            light[i].absorbed_m2 +=
                layers.absorbed[l] * depth * (share - below) / layers.leaf_depth[l] * area_m2;
            mean_light += (share - below) * layers.in_the_middle[l];
            below = share;
        }
        const double own_depth = kind.light.extinction * tree.crown.leaf_area_m2 / cell_area_m2;
        const double own_shade = own_depth > 1e-9 ? (1.0 - config::exp_of(-own_depth)) / own_depth : 1.0;
        light[i].light_ratio = std::min(1.0, mean_light / own_shade);
        for (std::size_t l = 0; l < layers.in_the_middle.size(); ++l) {
            if (layers.in_the_middle[l] < kind.light.min_crown) {
                light[i].shaded_below_m = static_cast<double>(l + 1) * layer_m;
            }
        }
    }
    return light;
}

}  // namespace forest
