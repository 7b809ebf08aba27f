#pragma once

#include <Eigen/Core>

#include "config/units/constants.hpp"
#include "rockfall/solids/free_rotation.hpp"
#include "rockfall/solids/mass_properties.hpp"

namespace rockfall::rigid {

/// A block at one moment: centroid, velocity, attitude and angular momentum.
struct Body {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    solids::Rotation rotation{Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()};

    [[nodiscard]] Eigen::Vector3d spin_radps(const solids::Solid& solid) const {
        return rotation.spin_radps(solid.inertia_kgm2);
    }
    /// Translation and rotation.
    [[nodiscard]] double kinetic_j(const solids::Solid& solid) const {
        return 0.5 * solid.mass_kg * velocity_mps.squaredNorm() + rotation.energy_j(solid.inertia_kgm2);
    }
    /// Height energy over z = 0.
    [[nodiscard]] double potential_j(const solids::Solid& solid) const {
        return solid.mass_kg * config::gravity_mps2 * centre_m.z();
    }
    /// Inverse of the tensor of inertia in the axes of space.
    [[nodiscard]] Eigen::Matrix3d inverse_inertia(const solids::Solid& solid) const {
        const Eigen::Matrix3d turn = rotation.attitude.toRotationMatrix();
        return turn * solid.inertia_kgm2.cwiseInverse().asDiagonal() * turn.transpose();
    }
};

}  // namespace rockfall::rigid
