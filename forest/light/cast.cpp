#include "forest/light/cast.hpp"

#include <algorithm>

namespace forest {
namespace {

constexpr auto layer_m = static_cast<float>(layer_height_m);
constexpr auto half_layer_m = 0.5F * layer_m;
constexpr auto nodes_below = static_cast<float>(PrefixSums::nodes_below);

/// Least difference of height over which a mean density is taken.
constexpr float flat_m = 0.05F;

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

inline Node node_at(float height_m) {
    // Heights are kept where nodes exist for all layers above; beyond lies nothing but air, or soil.
    const float place = std::clamp(height_m / layer_m, -nodes_below, nodes_below + 0.5F) + nodes_below;
    const auto below = static_cast<std::int32_t>(place);
    return {static_cast<std::size_t>(below), place - static_cast<float>(below)};
}

inline float sum_at(const float* nodes, Node node) {
    return nodes[node.below] + node.share * (nodes[node.below + 1] - nodes[node.below]);
}

}  // namespace

OpticalDepth cast_column(const PaddedGround& ground, const PrefixSums& leaves, double top_m,
                         const RayWalk& walk, std::size_t padded_column) {
    OpticalDepth depth;
    float tau[canopy_layers] = {};
    const float* elevation_m = ground.elevation_m().data() + padded_column;
    const float start_m = elevation_m[0];
    const auto top = static_cast<float>(top_m);
    float low_m = 0.0F;
    const RayStep& first = walk.steps.front();
    const float first_exit_m =
        start_m + first.rise_m - height_between(elevation_m, ground.stride(), first.exit);
    depth.climb = first_exit_m * walk.tangent / first.rise_m;
    for (const RayStep& step : walk.steps) {
        const float exit_m = start_m + step.rise_m - height_between(elevation_m, ground.stride(), step.exit);
        const float high_m = std::abs(exit_m - low_m) < flat_m ? low_m + flat_m : exit_m;
        const float per_m = step.length_m / (high_m - low_m);
        const float* nodes =
            leaves.of(padded_column + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(step.column)));
        const Node ground_low = node_at(low_m);
        const Node ground_high = node_at(high_m);
        depth.ground += per_m * (sum_at(nodes, ground_high) - sum_at(nodes, ground_low));
        const Node low = node_at(low_m + half_layer_m);
        const Node high = node_at(high_m + half_layer_m);
        const float* at_low = nodes + low.below;
        const float* at_high = nodes + high.below;
        for (std::size_t l = 0; l < canopy_layers; ++l) {
            tau[l] += per_m * ((at_high[l] + high.share * (at_high[l + 1] - at_high[l])) -
                               (at_low[l] + low.share * (at_low[l + 1] - at_low[l])));
        }
        low_m = exit_m;
        if (low_m > top || low_m < -static_cast<float>(canopy_height_m)) {
            break;
        }
    }
    for (std::size_t l = 0; l < canopy_layers; ++l) {
        depth.layers[l] = tau[l];
    }
    return depth;
}

float cast_ground(const PaddedGround& ground, const PrefixSums& leaves, double top_m, const RayWalk& walk,
                  std::size_t padded_column, float enough) {
    const float* elevation_m = ground.elevation_m().data() + padded_column;
    const float start_m = height_between(elevation_m, ground.stride(), walk.start);
    const auto top = static_cast<float>(top_m);
    float tau = 0.0F;
    float low_m = 0.0F;
    for (const RayStep& step : walk.steps) {
        const float exit_m = start_m + step.rise_m - height_between(elevation_m, ground.stride(), step.exit);
        const float high_m = std::abs(exit_m - low_m) < flat_m ? low_m + flat_m : exit_m;
        const float* nodes =
            leaves.of(padded_column + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(step.column)));
        tau += step.length_m / (high_m - low_m) *
               (sum_at(nodes, node_at(high_m)) - sum_at(nodes, node_at(low_m)));
        low_m = exit_m;
        if (low_m > top || tau > enough) {
            break;
        }
    }
    return tau;
}

}  // namespace forest
