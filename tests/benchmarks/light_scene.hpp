#pragma once

#include <vector>

#include "forest/light/light.hpp"

namespace benchmarks {

/// Forty hectares of rough slope, 80 x 50 columns, with 40 000 trees in groups; the same in every run.
struct LightScene {
    forest::LightGround ground;
    std::vector<forest::LightTree> trees;
    forest::LightYear year;
};

/// With trees of one kind of leaf, or every third deciduous.
[[nodiscard]] LightScene light_scene(bool deciduous);

/// Sky of the Eastern Alps in zones of a height, 45 degrees wide.
[[nodiscard]] forest::Sky light_sky(const LightScene& scene, double zone_height_deg);

}  // namespace benchmarks
