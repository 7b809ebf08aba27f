#pragma once

#include <Eigen/Core>

namespace rockfall::pir3d {

/// Place and velocity of a point.
struct PointState {
    Eigen::Vector3d position_m;
    Eigen::Vector3d velocity_mps;
};

/// A step of the equation of motion and its error.
struct NystromStep {
    PointState end;
    double error_m;
};

/// One step of x'' = f(x, x') by the fourth-order scheme of Runge, Kutta and Nystroem with its error estimate
/// h^2 |k1 - k2 - k3 + k4|_1 (Lund et al. 2009, the scheme that Cottaz et al. 2010 use).
///
/// `acceleration(position_m, velocity_mps)` gives x''. Its place in a step is the same for k2 and k3.
template <class Acceleration>
NystromStep nystrom_step(const PointState& start, double step_s, const Acceleration& acceleration) {
    const Eigen::Vector3d& x = start.position_m;
    const Eigen::Vector3d& v = start.velocity_mps;
    const double h = step_s;
    const Eigen::Vector3d k1 = acceleration(x, v);
    const Eigen::Vector3d middle = x + 0.5 * h * v + 0.125 * h * h * k1;
    const Eigen::Vector3d k2 = acceleration(middle, Eigen::Vector3d{v + 0.5 * h * k1});
    const Eigen::Vector3d k3 = acceleration(middle, Eigen::Vector3d{v + 0.5 * h * k2});
    const Eigen::Vector3d k4 =
        acceleration(Eigen::Vector3d{x + h * v + 0.5 * h * h * k3}, Eigen::Vector3d{v + h * k3});
    return {{x + h * v + h * h / 6.0 * (k1 + k2 + k3), v + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)},
            h * h * (k1 - k2 - k3 + k4).lpNorm<1>()};
}

}  // namespace rockfall::pir3d
