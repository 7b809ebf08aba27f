#include "forest/light/stand_light.hpp"

#include <algorithm>
#include <cassert>

#include "forest/light/layer_light.hpp"
#include "forest/light/leaf_clumping.hpp"
#include "forest/light/light_profile.hpp"

namespace forest {

namespace {

double without_shade_of_group(double ratio, const Tree& tree, const Species& kind) {
    if (tree.stems == 1) {
        return ratio;
    }
    const double depth = kind.light.extinction * tree.crown.leaf_area_m2 / patch_area_m2;
    return std::min(1.0, ratio * mean_light_within(tree.stems * depth) / mean_light_within(depth));
}

/// What the leaves of a tree absorb in its crown, relative to what the light model has for its column.
double clumped(const Tree& tree, const Species& kind, double column_depth) {
    const double depth = crown_depth(kind.light.extinction, tree.crown.leaf_area_m2, tree.crown.radius_m);
    return absorption_when_clumped(depth, column_depth);
}

}  // namespace

std::vector<LightTree> light_trees_of(const Stand& stand, const SpeciesTable& species) {
    std::vector<LightTree> trees;
    trees.reserve(stand.trees().size());
    for (const Tree& tree : stand.trees()) {
        const Species& kind = species[tree.species];
        trees.push_back({.x_m = tree.x_m,
                         .y_m = tree.y_m,
                         .crown_base_m = tree.crown.base_m,
                         .height_m = tree.height_m,
                         .crown_radius_m = tree.crown.radius_m,
                         .leaf_area_m2 = tree.stems * tree.crown.leaf_area_m2,
                         .extinction = kind.light.extinction,
                         .shape = kind.crown.shape,
                         .deciduous = !kind.evergreen});
    }
    return trees;
}

StandLight light_in_stand(const Stand& stand, const SpeciesTable& species, const LightSite& site,
                          const Canopy& canopy, const LightField& field) {
    const std::span<const Tree> trees = stand.trees();
    assert(field.light_ratio.size() == trees.size());
    const LightProfiles profiles{stand, species, site, canopy, field};
    StandLight light{std::vector<double>(trees.size()), std::vector<AbsorbedByMonth>(trees.size()),
                     std::vector<double>(trees.size())};
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Tree& tree = trees[i];
        const Species& kind = species[tree.species];
        const double of_cells = without_shade_of_group(static_cast<double>(field.light_ratio[i]), tree, kind);
        light.ratios[i] = std::min(1.0, of_cells * within_layers(profiles, tree, kind.crown.shape));
        light.shaded_below_m[i] = profiles.shaded_below_m(tree.patch, kind.light.min_crown);
        const std::size_t column =
            stand.grid().frame().index(stand.grid().patches()[index_of(tree.patch)].cell);
        const float* const below =
            canopy.leaf_on().of(site.ground().padded(column)) + PrefixSums::nodes_below;
        const double share = clumped(tree, kind, static_cast<double>(below[canopy.layers_used(column)]));
        for (std::size_t month = 0; month < light.absorbed[i].size(); ++month) {
            light.absorbed[i][month] =
                share * static_cast<double>(field.absorbed_mj[i * light.absorbed[i].size() + month]);
        }
    }
    return light;
}

StandLight light_by_layers(const Stand& stand, const SpeciesTable& species,
                           const MonthlyRadiation& radiation) {
    const std::span<const Tree> trees = stand.trees();
    const std::vector<LayerLight> by_layers = layer_light(trees, species, stand.grid().area_m2());
    StandLight light{std::vector<double>(trees.size()), std::vector<AbsorbedByMonth>(trees.size()),
                     std::vector<double>(trees.size())};
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Light& leaves = species[trees[i].species].light;
        light.ratios[i] = by_layers[i].light_ratio;
        light.shaded_below_m[i] = by_layers[i].shaded_below_m;
        for (std::size_t m = 0; m < light.absorbed[i].size(); ++m) {
            const bool in_leaf = leaves.in_leaf(static_cast<int>(m) + 1);
            const double area_m2 = in_leaf ? trees[i].stems * by_layers[i].absorbed_m2 : 0.0;
            light.absorbed[i][m] = area_m2 * (radiation.direct_mjpm2[m] + radiation.diffuse_mjpm2[m]);
        }
    }
    return light;
}

}  // namespace forest
