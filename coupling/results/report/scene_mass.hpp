#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rockfall/solids/hull.hpp"

namespace coupling::report {

/// Where a block of a rock mass is at a time.
struct SceneBlockPlace {
    double x_m = 0.0;  ///< absolute
    double y_m = 0.0;
    double z_m = 0.0;
    float attitude[4]{};  ///< w, x, y, z
    float speed_mps = 0.0F;
};

/// A rock mass that breaks up, at some times.
struct SceneMass {
    std::vector<double> times_s;
    std::vector<rockfall::solids::Hull> blocks;        ///< about their centres
    std::vector<std::vector<SceneBlockPlace>> frames;  ///< of these blocks, for each time
    std::size_t all_blocks = 0;                        ///< those that are not drawn included
};

/// Speeds [m/s] at which the colour of a block changes.
inline constexpr double block_speed_bounds_mps[] = {1.0, 5.0, 15.0};
/// 0 below the first bound.
std::uint8_t block_speed_class(double speed_mps);

/// The mass as numbers for the view in three dimensions. Places count from the corner of the map and from
/// its lowest ground.
std::string mass_json(const SceneMass& mass, double west_m, double south_m, double low_m);

/// Vertices and triangles of a hull as members of a JSON object.
std::string hull_json(const rockfall::solids::Hull& hull);

}  // namespace coupling::report
