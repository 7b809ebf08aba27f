#include "forest/light/ray_walk.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace forest {
namespace {

/// Between which centres the point (x, y) lies, in columns from the centre of the first column, y upwards.
BetweenColumns between(double x, double y, std::size_t stride) {
    const double left = std::floor(x);
    const double above = std::ceil(y);
    const double to_right = x - left;
    const double down = above - y;
    BetweenColumns place;
    // Rows count downwards.
    place.corner = static_cast<std::int32_t>(left) -
                   static_cast<std::int32_t>(above) * static_cast<std::int32_t>(stride);
    place.shares = {static_cast<float>((1.0 - to_right) * (1.0 - down)),
                    static_cast<float>(to_right * (1.0 - down)), static_cast<float>((1.0 - to_right) * down),
                    static_cast<float>(to_right * down)};
    return place;
}

/// Distance along a horizontal unit step to the next border of columns on one axis.
double to_border(double at, int column, double step) {
    if (step == 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const double border = column + (step > 0.0 ? 0.5 : -0.5);
    return (border - at) / step;
}

}  // namespace

RayWalk walk_towards(const Direction& towards, double x_m, double y_m, double column_m, std::size_t stride,
                     double rise_m, double reach_m) {
    assert(towards.z > 0.0);
    const double flat = std::sqrt(towards.x * towards.x + towards.y * towards.y);
    RayWalk walk;
    const double x = x_m / column_m;
    const double y = y_m / column_m;
    walk.start = between(x, y, stride);
    // A ray nearly straight up would divide by nothing; it leaves the canopy inside its column.
    const double run = std::max(flat, 1e-4);
    walk.cosine = run;
    const double step_x = towards.x / run;
    const double step_y = towards.y / run;
    const double tangent = towards.z / run;
    walk.tangent = tangent;
    walk.across_x = step_x;
    walk.across_y = step_y;
    const double reach = std::min(reach_m, rise_m / tangent) / column_m;
    double gone = 0.0;
    int column = 0;
    int row = 0;
    while (gone < reach) {
        const double across = to_border(x, column, step_x);
        const double along = to_border(y, row, step_y);
        const double next = std::min({across, along, reach});
        if (next > gone + 1e-9) {
            RayStep step;
            step.column = column - row * static_cast<std::int32_t>(stride);
            step.length_m = static_cast<float>((next - gone) * column_m * std::sqrt(1.0 + tangent * tangent));
            step.rise_m = static_cast<float>(next * column_m * tangent);
            step.exit = between(x + next * step_x, y + next * step_y, stride);
            walk.steps.push_back(step);
        }
        gone = next;
        column += across <= next ? (step_x > 0.0 ? 1 : -1) : 0;
        row += along <= next ? (step_y > 0.0 ? 1 : -1) : 0;
    }
    return walk;
}

}  // namespace forest
