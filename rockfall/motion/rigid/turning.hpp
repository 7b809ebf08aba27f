#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "rockfall/solids/free_rotation.hpp"

namespace rockfall::rigid {

/// Attitude of a free block at any time of a flight.
///
/// A block with three or two equal moments turns in closed form: about its momentum in space at |L| / I, and
/// about its own axis at (1/I_3 - 1/I) L_3. Any other is followed in the equal steps of rotate_free, counted
/// from the start of the flight, so that the result does not depend on the times that were asked for before.
class Turning {
public:
    explicit Turning(const Eigen::Vector3d& inertia_kgm2);

    void begin(const solids::Rotation& start);
    /// The rotation a time >= 0 after the start.
    solids::Rotation at(double time_s);

private:
    enum class Kind : std::uint8_t { ball, top, any };
    Eigen::Vector3d inertia_kgm2_;
    Kind kind_;
    int axis_ = 2;  ///< of a top
    solids::Rotation start_{Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()};
    Eigen::Vector3d direction_ = Eigen::Vector3d::UnitZ();  ///< of the momentum in space
    double rate_radps_ = 0.0;                               ///< about it
    double step_s_ = 0.0;
    double steps_done_ = 0.0;
    solids::Rotation reached_{Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()};
};

}  // namespace rockfall::rigid
