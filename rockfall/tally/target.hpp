#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rockfall {

/// The roof of a gallery: rocks on it or above it do not hit what lies below, up to a kinetic energy.
struct Roof {
    std::vector<Eigen::Vector2d> ring_m;  ///< closed, in coordinates of the terrain
    double capacity_j = 0.0;              ///< rocks with more break through; infinite: none does
};

/// Whether a place lies below a roof.
bool is_below(const Roof& roof, const Eigen::Vector2d& place_m);

/// What is to be protected: a line that rocks cross (road) or an area that they enter (house), or a mark at
/// which they are counted. Vertices in coordinates of the terrain; the rings of an area are closed.
struct Target {
    std::string id;
    std::string name;
    bool is_area = false;
    bool is_hit_by_side = false;  ///< also by a rock whose centre passes it within the rock's radius
    std::vector<std::vector<Eigen::Vector2d>> parts;  ///< polylines, or rings by the even-odd rule
    std::vector<Roof> roofs{};                        ///< over parts of a line

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

/// Share of the way from `from` to `to` at which the centre of a straight path is first within `radius_m` of
/// the target's lines [0, 1], on the map.
std::optional<double> first_touch(const Target& target, const Eigen::Vector2d& from_m,
                                  const Eigen::Vector2d& to_m, double radius_m);

/// How a rock arrived at a target: where its centre first meets the lines of the target, or else where its
/// side first touches them.
struct Arrival {
    bool reached = false;
    bool by_side = false;  ///< the centre has not met it
    float x_m = 0.0F;      ///< in coordinates of the terrain
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
