#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "forest/light/direction.hpp"

namespace forest {

/// Four neighbouring columns between whose centres a point lies, and their shares in the height of the ground
/// there.
struct BetweenColumns {
    std::int32_t corner = 0;  ///< the upper left one, as an offset in the padded arrays
    std::array<float, 4> shares{1.0F, 0.0F, 0.0F,
                                0.0F};  ///< upper left, upper right, lower left, lower right
};

/// One column that a ray crosses.
struct RayStep {
    std::int32_t column = 0;  ///< offset of the column in the padded arrays
    float length_m = 0.0F;    ///< of the ray inside it
    float rise_m = 0.0F;      ///< of the ray from its start to the exit
    BetweenColumns exit;      ///< where it leaves
};

/// The columns that a ray in one direction crosses, seen from the column it starts in. The same for all
/// columns, so it is found once for a direction; how high the ground lies there is not part of it.
struct RayWalk {
    BetweenColumns start;
    std::vector<RayStep> steps;
    double tangent = 0.0;   ///< rise per horizontal metre
    double cosine = 1.0;    ///< of the elevation, > 0
    double across_x = 0.0;  ///< where it goes on the map
    double across_y = 0.0;
};

/// A walk that starts at (x, y) metres from the centre of its column, inside it, until the ray has risen by
/// `rise_m` or gone `reach_m` far. Requires a direction above the horizon; one straight up stays in its
/// column.
[[nodiscard]] RayWalk walk_towards(const Direction& towards, double x_m, double y_m, double column_m,
                                   std::size_t stride, double rise_m, double reach_m);

}  // namespace forest
