#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "rockfall/laws/rock.hpp"
#include "rockfall/terrain/face.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// A rolling sphere moves like a sliding point of 7/5 its mass: m / (m + I / R^2).
inline constexpr double rolling_mass_factor = 5.0 / 7.0;

/// When rocks roll.
struct RollingLaw {
    double friction = 0.5;  ///< rolling friction coefficient of every ground type [-] (Azzoni et al. 1995)
    double edge_angle_tangent =
        0.0699;                  ///< tan of the angle at an edge above which a rolling rock takes off or hits
    double start_factor = 0.7;   ///< a rock slower than this times sqrt(g R cos b) after an impact rolls [-]
    double launch_factor = 1.0;  ///< a rolling rock faster than this times sqrt(g R cos b) jumps [-]
};

/// No piece of rolling is shorter unless the rock stops in it: at the walking pace of rolling rocks it runs
/// over an edge a little (millimetres) instead of being handed to and fro by two faces in ever smaller steps.
/// Where the ground beyond rises or falls more steeply than `largest_overrun_tangent` against the face, at a
/// cliff or a wall, the piece ends at the edge after all; so does every piece of sliding, which may be fast.
/// There run_if_pressed() takes the rock along the edge.
inline constexpr double shortest_rolling_piece_s = 5e-3;
inline constexpr double largest_overrun_tangent = 3.0;

enum class RollingEnd : std::uint8_t { edge, standstill, launch_speed, piece };

/// Motion at an end of a piece of a block that neither rolls nor slides.
struct OwnMotion {
    double squared_speed = 0.0;  ///< of the centroid [m2/s2]
    double rotation_j = -1.0;    ///< energy of rotation; below 0: the rock has no motion of its own
};

/// A piece of rolling with constant acceleration on one triangle.
///
/// Of a block with a motion of its own the piece is the chord of its way: velocity and acceleration place it
/// on the chord, and its energies are those of `own_start` and `own_end`, between which they change evenly
/// along the way. The mean speed of a short chord may be far from the block's.
struct RollingPiece {
    Eigen::Vector3d start_m;
    Eigen::Vector3d velocity_mps;
    Eigen::Vector3d acceleration_mps2;
    double duration_s;
    RollingEnd end;
    std::uint32_t next_triangle;  ///< beyond the edge that ends the piece, or that a shortest piece ran over
    bool ran_over = false;        ///< ends a little beyond its edge
    bool slides = false;          ///< moves without spin
    OwnMotion own_start{};        ///< of a block that neither rolls nor slides
    OwnMotion own_end{};

    [[nodiscard]] bool has_own() const { return own_end.rotation_j >= 0.0; }
    [[nodiscard]] double squared_speed_start() const {
        return has_own() ? own_start.squared_speed : velocity_mps.squaredNorm();
    }
    [[nodiscard]] double squared_speed_end() const {
        return has_own() ? own_end.squared_speed : velocity_at(duration_s).squaredNorm();
    }
    /// The block's motion after a time of the piece.
    [[nodiscard]] OwnMotion own_at(double time_s) const;
    /// Ends the piece earlier.
    void end_after(double time_s) {
        own_end = own_at(time_s);
        duration_s = time_s;
    }
    [[nodiscard]] Eigen::Vector3d position_m(double time_s) const {
        return start_m + time_s * velocity_mps + 0.5 * time_s * time_s * acceleration_mps2;
    }
    [[nodiscard]] Eigen::Vector3d velocity_at(double time_s) const {
        return velocity_mps + time_s * acceleration_mps2;
    }
    /// When a share [0, 1] of the straight way to the end of the piece is covered.
    [[nodiscard]] double time_along_s(double share) const;
};

/// Energy of rotation on a piece of the ground at the square of a speed [J]: that of rolling, none of
/// sliding, or the block's own.
inline double rotation_on_ground_j(const Rock& rock, bool slides, double own_j, double squared_speed) {
    if (own_j >= 0.0) {
        return own_j;
    }
    return slides ? 0.0 : 0.5 * rock.inertia_kgm2 / (rock.radius_m * rock.radius_m) * squared_speed;
}

/// Acceleration of a sphere that rolls on a plane: 5/7 (g_t - mu g n_z v/|v|) (Azzoni et al. 1995, in vector
/// form). `direction` is the unit vector of the motion.
Eigen::Vector3d rolling_acceleration(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction,
                                     double friction);

/// The next piece of rolling from a point on a triangle.
///
/// Along the fall line a piece is exact and runs to the edge or to standstill; across it pieces are so short
/// that the direction turns by less than 2 degrees, with friction taken at mid-piece. Ends at the edge of the
/// triangle, at standstill on ground too flat to start again, or on reaching `launch_speed_mps`. Requires a
/// velocity in the plane of the triangle.
RollingPiece roll(const Terrain& terrain, std::uint32_t triangle, const Face& face,
                  const Eigen::Vector3d& start_m, const Eigen::Vector3d& velocity_mps, double friction,
                  double launch_speed_mps);

}  // namespace rockfall
