#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "rockfall/rock_mass/bond.hpp"
#include "rockfall/rock_mass/overlap.hpp"

namespace rockfall::rock_mass {

/// Motion of a second body against a first one for which an overlap need not be clipped again [-]: towards
/// the contact, turns included, by the way on which its force would vanish at its stiffness (the depth of
/// faces, a third of that of a corner), and along it by the side of the square of its area [choice].
/// Less where the pressure is so uneven that part of the contact opens within that way: at edges, corners and
/// tilted faces. There the force falls with a higher power of the depth, and each bounce of a cube on an edge
/// lost 0.6 % of its energy with the larger share.
inline constexpr double held_share_of_depth = 0.3;
inline constexpr double held_share_where_it_opens = 0.1;
/// Of a rectangle whose shallowest depth is 0.3 of the mean: 0.7^2 / 3.
inline constexpr double unevenness_that_opens = 0.163;
inline constexpr double held_share_of_side = 0.05;
/// Error of a force that does not matter, by the weight of the lighter block [-] [choice]: contacts that hold
/// little more (blocks that share an edge of a joint, corners) are carried on for longer. Where the area
/// grows with the depth the force is off by (way / depth)^2 / 4 of itself.
inline constexpr double held_share_of_weight = 1e-3;
/// Clippings without a slope after one that was of use for a step or less [choice].
inline constexpr std::uint8_t clippings_without_slope = 8;

/// An overlap that was clipped once and is carried on by its slope while two bodies hardly move against each
/// other.
///
/// The force is linear in the motion there: that of a spring with the exact stiffness of the place at which
/// it was clipped. For faces that lie on each other this is exact as long as no part of them opens; else the
/// error is of the second order in the motion. Everything is kept in the axes of one body, the holder, so
/// that turns of both together change nothing.
class HeldOverlap {
public:
    /// Whether the next clipping should compute the slope: not where the last one was of use for a step or
    /// less.
    [[nodiscard]] bool wants_slope() const { return without_slope_ == 0; }
    [[nodiscard]] bool second_holds() const { return second_holds_; }
    [[nodiscard]] bool is_valid() const { return is_valid_; }

    /// Forgets everything.
    void clear();

    /// Keeps an overlap of `other`, moments about its centre. `reach_m`: farthest that a point in contact may
    /// be from its middle; not more than half the diagonal of the square of equal area is used. `slack_m3`:
    /// error that does not matter.
    void keep(const Overlap& overlap, const OverlapSlope& slope, const BlockPose& holder,
              const BlockPose& other, double reach_m, bool second_holds, double slack_m3 = 0.0);
    /// That it was clipped without a slope.
    void skip() { without_slope_ = static_cast<std::uint8_t>(without_slope_ - (without_slope_ > 0 ? 1 : 0)); }

    /// The overlap of `other` as it is now, about its centre; false where it has to be clipped again.
    /// Requires `is_valid`.
    bool carry_on(const BlockPose& holder, const BlockPose& other, Overlap& overlap);

private:
    bool is_valid_ = false;
    bool second_holds_ = false;
    std::uint8_t steps_ = 0;
    std::uint8_t without_slope_ = 0;
    double share_of_depth_ = 0.0;
    double most_towards_m_ = 0.0;
    double most_along_m_ = 0.0;
    double reach_m_ = 0.0;
    double depth_m3_ = 0.0;
    double surface_m2_ = 0.0;
    double friction_radius_m_ = 0.0;
    // In the axes of the holder.
    Eigen::Vector3d place_m_;      ///< of the other one's centre
    Eigen::Quaterniond attitude_;  ///< of the other one
    std::array<Eigen::Vector3d, 2> arms_m_;
    Eigen::Vector3d normal_, force_m3_, moment_m4_, area_m2_;
    Eigen::Vector3d pressure_centre_m_;  ///< from the centre of the holder
    OverlapSlope slope_;
};

}  // namespace rockfall::rock_mass
