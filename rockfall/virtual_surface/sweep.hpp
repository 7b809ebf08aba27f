#pragma once

#include <Eigen/Core>
#include <optional>

#include "rockfall/virtual_surface/block_cover.hpp"

namespace rockfall {

/// Where a rock that moves straight on first touches a block.
struct BlockContact {
    double along_m = 0.0;  ///< way of the rock's centre until then
    Eigen::Vector3d towards{
        Eigen::Vector3d::Zero()};  ///< unit vector from the rock's centre to the point of contact
};

/// A rock that is swept over a virtual surface, its centre never lower than its radius.
class Sweep {
public:
    /// Keeps a reference to the cover. Requires diameter_m > 0.
    Sweep(const BlockCover& cover, double diameter_m);

    [[nodiscard]] double radius_m() const { return radius_m_; }
    /// Height of the centre from which on the rock is clear of every block.
    [[nodiscard]] double clear_height_m() const { return cover_.highest_m() + radius_m_; }

    /// The first block that the rock touches on a straight way of its centre, if any:
    /// |c(t) - b| = R + r for the smallest t >= 0, met from outside.
    ///
    /// `widest_sine` in (0, 1] leaves out blocks whose centre lies further off the line of flight than
    /// that share of R + r: 1 takes every touch, the sine of an angle only hits within that angle of the
    /// flight direction. Requires a unit `direction`.
    [[nodiscard]] std::optional<BlockContact> first_contact(const Eigen::Vector3d& centre_m,
                                                            const Eigen::Vector3d& direction, double length_m,
                                                            double widest_sine = 1.0) const;

private:
    const BlockCover& cover_;
    double radius_m_;
    double reach_m_;  ///< largest distance in plan at which a block can be touched
};

}  // namespace rockfall
