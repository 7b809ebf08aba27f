#include "forest/light/light_profile.hpp"

#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "forest/light/layer_light.hpp"

namespace forest {

namespace {

constexpr auto metres_of_layer = static_cast<std::size_t>(layer_height_m);

std::size_t layer_of(double height_m) {
    return std::min(static_cast<std::size_t>(std::max(0.0, height_m) / layer_height_m), canopy_layers - 1);
}

using Leaves = std::array<double, LightProfiles::metres>;

/// Leaf area of the trees of each patch in slices of a metre; only relative sizes matter.
std::vector<Leaves> leaves_by_metre(const Stand& stand, const SpeciesTable& species) {
    std::vector<Leaves> leaves(stand.grid().size(), Leaves{});
    for (const Tree& tree : stand.trees()) {
        const Species& kind = species[tree.species];
        const double area = tree.stems * tree.crown.leaf_area_m2 * kind.light.extinction;
        double below = 0.0;
        for (auto m = static_cast<std::size_t>(tree.crown.base_m); m < LightProfiles::metres && below < 1.0;
             ++m) {
            const double share = crown_share_below(kind.crown.shape, tree.crown.base_m, tree.height_m,
                                                   static_cast<double>(m) + 1.0);
            leaves[index_of(tree.patch)][m] += area * (share - below);
            below = share;
        }
    }
    return leaves;
}

/// The leaves of a layer over its metres, scaled to what the canopy has in it; even where the patch has none.
void fit_to_layer(Leaves& leaves, std::size_t layer, double depth) {
    const auto first = leaves.begin() + static_cast<std::ptrdiff_t>(layer * metres_of_layer);
    double sum = 0.0;
    for (auto metre = first; metre != first + metres_of_layer; ++metre) {
        sum += *metre;
    }
    for (auto metre = first; metre != first + metres_of_layer; ++metre) {
        *metre = sum > 0.0 ? *metre * depth / sum : depth / metres_of_layer;
    }
}

double relative_light(const LightField& field, std::size_t column, std::size_t layer) {
    const float open = field.open_season[column];
    const float here = field.cell(column, layer)[LightField::season_value];
    return open > 0.0F ? std::clamp(static_cast<double>(here / open), 0.0, 1.0) : 1.0;
}

/// Light in the free air above the `used` layers of a column. Where the field does not reach up there, it
/// follows from the highest layer as if its leaves hung in the light of a mean sky.
double light_above(const LightField& field, std::size_t column, std::size_t used, double depth_of_highest) {
    constexpr double path_per_height = 1.5;
    if (used < canopy_layers) {
        const double computed = relative_light(field, column, used);
        if (computed > 0.0) {
            return computed;
        }
    }
    return used == 0 ? 1.0
                     : std::min(1.0, relative_light(field, column, used - 1) *
                                         config::exp_of(0.5 * path_per_height * depth_of_highest));
}

/// Light under a depth of leaves. Nodes run from above, with rising depth; light falls exponentially between
/// them.
class LightUnderLeaves {
public:
    void add(double depth, double light) {
        depths_[count_] = depth;
        log2_lights_[count_] = config::log2_of(std::clamp(light, 1e-6, 1.0));
        ++count_;
    }

    /// Asked for rising depths.
    double at(double depth) {
        while (next_ + 1 < count_ && depths_[next_] < depth) {
            ++next_;
        }
        const std::size_t above = next_ == 0 ? 0 : next_ - 1;
        const double span = depths_[next_] - depths_[above];
        const double part = span > 1e-9 ? std::min((depth - depths_[above]) / span, 2.0) : 1.0;
        const double log2_light = log2_lights_[above] + part * (log2_lights_[next_] - log2_lights_[above]);
        return config::exp2_of(std::min(0.0, log2_light));
    }

private:
    std::array<double, canopy_layers + 1> depths_{};
    std::array<double, canopy_layers + 1> log2_lights_{};
    std::size_t count_ = 0;
    std::size_t next_ = 0;
};

}  // namespace

LightProfiles::LightProfiles(const Stand& stand, const SpeciesTable& species, const LightSite& site,
                             const Canopy& canopy, const LightField& field)
    : fine_(stand.grid().size()), coarse_(stand.grid().size()) {
    std::vector<Leaves> leaves = leaves_by_metre(stand, species);
    for (std::size_t p = 0; p < fine_.size(); ++p) {
        const std::size_t column = stand.grid().frame().index(stand.grid().patches()[p].cell);
        const float* const below =
            canopy.leaf_on().of(site.ground().padded(column)) + PrefixSums::nodes_below;
        const std::size_t used = canopy.layers_used(column);

        LightUnderLeaves light;
        const double highest = used > 0 ? static_cast<double>(below[used] - below[used - 1]) : 0.0;
        const double free = light_above(field, column, used, highest);
        light.add(0.0, free);
        coarse_[p].fill(static_cast<float>(free));
        double depth = 0.0;
        for (std::size_t layer = used; layer-- > 0;) {
            const double of_layer = std::max(0.0, static_cast<double>(below[layer + 1] - below[layer]));
            const double here = relative_light(field, column, layer);
            coarse_[p][layer] = static_cast<float>(here);
            light.add(depth + 0.5 * of_layer, here);
            fit_to_layer(leaves[p], layer, of_layer);
            depth += of_layer;
        }
        fine_[p].fill(static_cast<float>(free));
        double overhead = 0.0;
        for (std::size_t m = used * metres_of_layer; m-- > 0;) {
            overhead += leaves[p][m];
            fine_[p][m] = static_cast<float>(light.at(overhead));
        }
    }
}

double LightProfiles::at(PatchId patch, double height_m) const {
    const double clipped_m = std::clamp(height_m, 0.0, canopy_height_m);
    const auto below = std::min(static_cast<std::size_t>(clipped_m), metres - 1);
    const Profile& profile = fine_[index_of(patch)];
    const auto part = static_cast<float>(clipped_m - static_cast<double>(below));
    return static_cast<double>(profile[below] + part * (profile[below + 1] - profile[below]));
}

double LightProfiles::in_cell(PatchId patch, double height_m) const {
    return static_cast<double>(coarse_[index_of(patch)][layer_of(height_m)]);
}

double LightProfiles::shaded_below_m(PatchId patch, double wanted) const {
    const Profile& profile = fine_[index_of(patch)];
    for (std::size_t m = metres; m-- > 0;) {
        if (static_cast<double>(profile[m]) < wanted) {
            const auto here = static_cast<double>(profile[m]);
            const auto above = static_cast<double>(profile[m + 1]);
            return static_cast<double>(m) +
                   (above > here ? std::min(1.0, (wanted - here) / (above - here)) : 1.0);
        }
    }
    return 0.0;
}

double within_layers(const LightProfiles& profiles, const Tree& tree, CrownShape shape) {
    // Heights in the crown with an eighth, three, five and seven eighths of its leaves below [crown lengths]:
    // from 1 - (1 - u)^2 and 3u^2 - 2u^3.
    constexpr std::array<double, 4> paraboloid = {0.064586, 0.209431, 0.387628, 0.646447};
    constexpr std::array<double, 4> ellipsoid = {0.221063, 0.415873, 0.584127, 0.778937};
    const double length_m = tree.height_m - tree.crown.base_m;
    double fine = 0.0;
    double coarse = 0.0;
    for (const double share : shape == CrownShape::paraboloid ? paraboloid : ellipsoid) {
        const double height_m = tree.crown.base_m + share * length_m;
        fine += profiles.at(tree.patch, height_m);
        coarse += profiles.in_cell(tree.patch, height_m);
    }
    return coarse > 0.0 ? fine / coarse : 1.0;
}

}  // namespace forest
