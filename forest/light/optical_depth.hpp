#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "forest/light/canopy.hpp"
#include "forest/light/ground.hpp"
#include "forest/light/layers.hpp"
#include "forest/light/ray_walk.hpp"

namespace forest {

/// One number for each layer of a column.
using Layers = std::array<float, canopy_layers>;

/// e^-x for x >= 0, relative error below 5e-6 up to x = 80 and no smaller than e^-80. Only additions and
/// products: the same bits everywhere.
inline float exp_minus(float x) {
    constexpr float to_nearest = 12582912.0F;  // 1.5 * 2^23: adding it rounds to a whole number
    const float y = -1.4426950408889634F * (x < 80.0F ? x : 80.0F);
    const float shifted = y + to_nearest;
    const float f = (y - (shifted - to_nearest)) * 0.69314718055994531F;  // |f| < 0.3466
    const float series = 1.0F + f * (1.0F + f * (0.5F + f * (1.0F / 6 + f * (1.0F / 24 + f * (1.0F / 120)))));
    const std::uint32_t exponent = (std::bit_cast<std::uint32_t>(shifted) + 127U) << 23;
    return series * std::bit_cast<float>(exponent);
}

/// What stands between a column and one direction of the sky.
struct OpticalDepth {
    Layers layers{};      ///< above the centre of each cell
    float ground = 0.0F;  ///< above the ground at the centre
    float climb = 0.0F;   ///< gain of height above ground per horizontal metre where the ray starts
};

/// Follows the rays from the centres of the lowest `lanes` cells of a column, 4, 8 or all 12, and from the
/// ground below them, towards one direction; cells above keep depth 0.
///
/// Performance: a straight ray has the same fractional offset from the layers in each column it passes,
/// whichever layer it starts in; so all of them are one vector, two interpolations and a difference a column.
/// Terrain above a ray makes it opaque.
template <std::size_t lanes>
[[nodiscard]] OpticalDepth column_depth(const PaddedGround& ground, const PrefixSums& leaves, double top_m,
                                        const RayWalk& walk, std::size_t padded_column);

/// The same for one ray from the start of the walk on the ground; ends early beyond `enough`.
[[nodiscard]] float ground_depth(const PaddedGround& ground, const PrefixSums& leaves, double top_m,
                                 const RayWalk& walk, std::size_t padded_column, float enough);

}  // namespace forest
