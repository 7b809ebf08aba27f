#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/terrain/terrain.hpp"

// Slopes that the tests of the terrain share. Randomness comes from the engines whose numbers the standard
// fixes.

namespace rockfall {

inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Uniform on [0, 1), the same on every machine.
inline double uniform(std::mt19937_64& engine) {
    return static_cast<double>(engine() >> 11U) * 0x1.0p-53;
}

/// Normal with mean 0 and standard deviation 1, nearly: the sum of twelve uniform numbers.
inline double bell(std::mt19937_64& engine) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) {
        sum += uniform(engine);
    }
    return sum;
}

/// A grid with national coordinates and a cell size without an exact binary form.
inline config::GridFrame frame_of(int columns, int rows, double cell_m = 4.9976889066) {
    return {.columns = columns,
            .rows = rows,
            .x_west_m = 177198.333999,
            .y_south_m = 376897.531312,
            .cell_width_m = cell_m,
            .cell_height_m = cell_m};
}

/// Heights from a function of the distance to the grid's south-western corner.
template <class HeightAt>
config::Raster<double> grid_of(const config::GridFrame& frame, HeightAt height_at) {
    config::Raster<double> heights{frame};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        heights.values[i] = height_at(frame.x_centre_m(cell.column) - frame.x_west_m,
                                      frame.y_centre_m(cell.row) - frame.y_south_m);
    }
    return heights;
}

inline config::Raster<double> tilted_grid(const config::GridFrame& frame) {
    return grid_of(frame, [](double x_m, double y_m) { return 1000.0 + 0.25 * x_m + 0.78 * y_m; });
}

inline config::Raster<double> rough_grid(const config::GridFrame& frame, double noise_m, std::uint64_t seed) {
    config::Raster<double> heights = tilted_grid(frame);
    std::mt19937_64 engine{seed};
    for (double& height_m : heights.values) {
        height_m += noise_m * bell(engine);
    }
    return heights;
}

/// Every cell is missing with the given probability.
inline void punch_holes(config::Raster<double>& heights, double probability, std::uint64_t seed) {
    std::mt19937_64 engine{seed};
    for (double& height_m : heights.values) {
        if (uniform(engine) < probability) {
            height_m = missing;
        }
    }
}

inline std::vector<Eigen::Vector3d> scattered_points(int count, double extent_m, std::uint64_t seed) {
    std::mt19937_64 engine{seed};
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double x_m = extent_m * uniform(engine);
        const double y_m = extent_m * uniform(engine);
        points.emplace_back(177198.0 + x_m, 376897.0 + y_m, 1000.0 + 0.7 * y_m + bell(engine));
    }
    return points;
}

/// Twice the signed area of a triangle in plan.
inline double twice_area_m2(const Vertex& a, const Vertex& b, const Vertex& c) {
    return (b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m);
}

inline double plan_area_m2(const Terrain& terrain) {
    double sum_m2 = 0.0;
    for (const Triangle& t : terrain.triangles()) {
        const auto vertices = terrain.vertices();
        sum_m2 += 0.5 * twice_area_m2(vertices[t.corners[0]], vertices[t.corners[1]], vertices[t.corners[2]]);
    }
    return sum_m2;
}

}  // namespace rockfall
