#include "forest/light/leaf_clumping.hpp"

#include <algorithm>
#include <numbers>

#include "config/math/elementary.hpp"

namespace forest {

namespace {

constexpr double shadow_per_cover = 1.5;
constexpr double clumped_path_per_height = 1.5;

}  // namespace

double mean_light_within(double depth) {
    constexpr double thin = 1e-4;
    constexpr double opaque = 80.0;
    return depth < thin ? 1.0 - 0.5 * depth : (1.0 - config::exp_of(-std::min(depth, opaque))) / depth;
}

double crown_depth(double extinction, double leaf_area_m2, double radius_m) {
    return extinction * leaf_area_m2 / (shadow_per_cover * std::numbers::pi * radius_m * radius_m);
}

double absorption_when_clumped(double crown_depth, double column_depth) {
    return std::min(1.0, mean_light_within(clumped_path_per_height * crown_depth) /
                             mean_light_within(clumped_path_per_height * column_depth));
}

}  // namespace forest
