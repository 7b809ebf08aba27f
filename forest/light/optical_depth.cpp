#include "forest/light/optical_depth.hpp"

#include <algorithm>

namespace forest {
namespace {

constexpr auto per_layer = static_cast<float>(1.0 / layer_height_m);
constexpr auto nodes_below = static_cast<float>(PrefixSums::nodes_below);

/// Least difference of height, in layers, over which a mean density is taken.
constexpr float level_layers = 0.01F;

/// Height of the ground between four columns.
inline float height_between(const float* elevation_m, std::size_t stride, const BetweenColumns& place) {
    const float* at = elevation_m + place.corner;
    return (place.shares[0] * at[0] + place.shares[1] * at[1]) +
           (place.shares[2] * at[stride] + place.shares[3] * at[stride + 1]);
}

/// A place among the nodes of a column: the node below and the share of the way to the next.
struct Node {
    std::size_t below;
    float share;
};

/// Above all leaves, and below the ground of all layers, one place is as good as another.
inline Node node_at(float layers_up) {
    constexpr float highest = nodes_below + 0.5F;
    // Written so that compilers take the minimum and maximum of the processor instead of jumping.
    const float not_above = layers_up < highest ? layers_up : highest;
    const float place = (not_above > -nodes_below ? not_above : -nodes_below) + nodes_below;
    const auto below = static_cast<std::int32_t>(place);
    return {static_cast<std::size_t>(below), place - static_cast<float>(below)};
}

inline float sum_at(const float* nodes, Node node) {
    return nodes[node.below] + node.share * (nodes[node.below + 1] - nodes[node.below]);
}

}  // namespace

template <std::size_t lanes>
OpticalDepth column_depth(const PaddedGround& ground, const PrefixSums& leaves, double top_m,
                          const RayWalk& walk, std::size_t padded_column) {
    OpticalDepth depth;
    std::array<float, lanes> tau{};
    const float* elevation_m = ground.elevation_m().data() + padded_column;
    const float start_m = elevation_m[0];
    const auto top = static_cast<float>(top_m) * per_layer;
    // Heights of the ray above the ground its start lies on, in layers.
    float low = 0.0F;
    Node low_ground = node_at(0.0F);
    Node low_cells = node_at(0.5F);
    for (const RayStep& step : walk.steps) {
        const float ground_m = height_between(elevation_m, ground.stride(), step.exit);
        const float exit = (start_m + step.rise_m - ground_m) * per_layer;
        const bool level = std::abs(exit - low) < level_layers;
        const float high = level ? low + level_layers : exit;
        const float per_height = step.length_m * per_layer / (high - low);
        const float* nodes =
            leaves.of(padded_column + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(step.column)));
        const Node high_ground = node_at(high);
        const Node high_cells = node_at(high + 0.5F);
        depth.ground += per_height * (sum_at(nodes, high_ground) - sum_at(nodes, low_ground));
        const float* at_low = nodes + low_cells.below;
        const float* at_high = nodes + high_cells.below;
        for (std::size_t l = 0; l < lanes; ++l) {
            tau[l] += per_height * ((at_high[l] + high_cells.share * (at_high[l + 1] - at_high[l])) -
                                    (at_low[l] + low_cells.share * (at_low[l + 1] - at_low[l])));
        }
        low = exit;
        low_ground = level ? node_at(exit) : high_ground;
        low_cells = level ? node_at(exit + 0.5F) : high_cells;
        if (low > top || low < -nodes_below) {
            break;
        }
    }
    std::copy(tau.begin(), tau.end(), depth.layers.begin());
    return depth;
}

template OpticalDepth column_depth<4>(const PaddedGround&, const PrefixSums&, double, const RayWalk&,
                                      std::size_t);
template OpticalDepth column_depth<8>(const PaddedGround&, const PrefixSums&, double, const RayWalk&,
                                      std::size_t);
template OpticalDepth column_depth<12>(const PaddedGround&, const PrefixSums&, double, const RayWalk&,
                                       std::size_t);

float ground_depth(const PaddedGround& ground, const PrefixSums& leaves, double top_m, const RayWalk& walk,
                   std::size_t padded_column, float enough) {
    const float* elevation_m = ground.elevation_m().data() + padded_column;
    const float start_m = height_between(elevation_m, ground.stride(), walk.start);
    const auto top = static_cast<float>(top_m) * per_layer;
    float tau = 0.0F;
    float low = 0.0F;
    for (const RayStep& step : walk.steps) {
        const float ground_m = height_between(elevation_m, ground.stride(), step.exit);
        const float exit = (start_m + step.rise_m - ground_m) * per_layer;
        const float high = std::abs(exit - low) < level_layers ? low + level_layers : exit;
        const float* nodes =
            leaves.of(padded_column + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(step.column)));
        tau += step.length_m * per_layer / (high - low) *
               (sum_at(nodes, node_at(high)) - sum_at(nodes, node_at(low)));
        low = exit;
        if (low > top || tau > enough) {
            break;
        }
    }
    return tau;
}

}  // namespace forest
