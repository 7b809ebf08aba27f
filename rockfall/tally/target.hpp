#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rockfall {

/// What is to be protected: a line that rocks cross (road) or an area that they enter (house).
/// Vertices in coordinates of the terrain; the rings of an area are closed.
struct Target {
    std::string id;
    std::string name;
    bool is_area = false;
    std::vector<std::vector<Eigen::Vector2d>> parts;  ///< polylines, or rings by the even-odd rule

    // Bounding box, by `with_bounds`.
    Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d high_m = Eigen::Vector2d::Zero();
};

/// The same target with its bounding box computed. Requires at least one vertex.
Target with_bounds(Target target);

/// Whether a point lies in an area target.
bool is_inside(const Target& target, const Eigen::Vector2d& point_m);

/// Share of the way from `from` to `to` at which a straight path first meets the target's lines [0, 1].
std::optional<double> first_crossing(const Target& target, const Eigen::Vector2d& from_m,
                                     const Eigen::Vector2d& to_m);

/// How a rock arrived at a target.
struct Arrival {
    bool reached = false;
    float x_m = 0.0F;  ///< in coordinates of the terrain
    float y_m = 0.0F;
    float energy_j = 0.0F;  ///< translation and rotation
    float translational_j = 0.0F;
    float speed_mps = 0.0F;
    float height_m = 0.0F;         ///< of the underside above ground, vertical
    float centre_height_m = 0.0F;  ///< of the centre, likewise
    float top_height_m = 0.0F;     ///< of the highest point, likewise
};

/// The arrival of a rock at the target of a number.
struct TargetArrival {
    std::uint32_t target;
    Arrival arrival;
};

}  // namespace rockfall
