// The time step of a rock mass, and the mass that the thinnest blocks get for it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "rockfall/rock_mass/rock_mass.hpp"

namespace rockfall::rock_mass {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

/// Stiffness of a block held on all of its faces by springs of c = 1: half of it matters to each of three
/// directions and three axes of rotation. A quadrature of the second order over each triangle.
struct HeldStiffness {
    Matrix3d shift = Matrix3d::Zero();
    Matrix3d turn = Matrix3d::Zero();
};

HeldStiffness held_stiffness(const solids::Solid& solid, double shear_share) {
    HeldStiffness held;
    for (const solids::Face& face : solid.hull.faces) {
        const Vector3d& n = face.normal;
        const Matrix3d by_area = (1.0 - shear_share) * n * n.transpose() + shear_share * Matrix3d::Identity();
        for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) {
            const Vector3d& a = solid.hull.vertices_m[face.corners[0]];
            const Vector3d& b = solid.hull.vertices_m[face.corners[k]];
            const Vector3d& c = solid.hull.vertices_m[face.corners[k + 1]];
            const double third = (b - a).cross(c - a).norm() / 6.0;
            for (const Vector3d& at :
                 {Vector3d{0.5 * (a + b)}, Vector3d{0.5 * (b + c)}, Vector3d{0.5 * (c + a)}}) {
                Matrix3d cross;
                cross << 0.0, -at.z(), at.y(), at.z(), 0.0, -at.x(), -at.y(), at.x(), 0.0;
                held.shift += third * by_area;
                held.turn += third * cross * by_area * cross.transpose();
            }
        }
    }
    return held;
}

/// No smaller than the largest eigenvalue of a symmetric matrix.
double largest_eigenvalue(const Matrix3d& matrix) {
    return matrix.cwiseAbs().rowwise().sum().maxCoeff();
}

}  // namespace

/// 2 sqrt(m / sum k) of a block that others hold on all faces, rotation included.
double RockMass::critical_step_s(std::size_t i) const {
    const Block& block = blocks_[i];
    solids::Solid solid;
    const PlacedBlock shape = placed(i);
    const Quaterniond back = block.rotation.attitude.conjugate();
    for (const Vector3d& vertex_m : shape.vertices_m) {
        solid.hull.vertices_m.push_back(back * (vertex_m - block.centre_m));
    }
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const std::span<const std::uint16_t> corners = shape.corners_of(f);
        solid.hull.faces.push_back({{corners.begin(), corners.end()}, back * shape.faces[f].normal, 0.0});
    }
    const HeldStiffness held = held_stiffness(solid, 1.0 / laws_.stiffness_ratio);
    const double foundation_npm3 = laws_.modulus_pa / (2.0 * block.half_side_m);
    const Vector3d scale = block.inertia_kgm2.cwiseSqrt().cwiseInverse();
    const double shift = largest_eigenvalue(held.shift) / block.mass_kg;
    const double turn = largest_eigenvalue(scale.asDiagonal() * held.turn * scale.asDiagonal());
    return 2.0 / std::sqrt(foundation_npm3 * std::max(shift, turn));
}

std::vector<double> RockMass::critical_steps_s() const {
    std::vector<double> steps_s(blocks_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (blocks_[i].status != BlockStatus::fixed) {
            steps_s[i] = critical_step_s(i);
        }
    }
    return steps_s;
}

/// The step of the thinnest block, but for the share of blocks that get so much mass that they allow it.
void RockMass::set_step() {
    const std::vector<double> critical_s = critical_steps_s();
    std::vector<double> sorted_s = critical_s;
    std::sort(sorted_s.begin(), sorted_s.end());
    const auto free = static_cast<std::size_t>(
        std::count_if(sorted_s.begin(), sorted_s.end(), [](double step_s) { return std::isfinite(step_s); }));
    if (free == 0) {
        step_s_ = step_when_held_s_ = 1e-3;
        return;
    }
    const double critical_of_all_s =
        sorted_s[static_cast<std::size_t>(laws_.heavier_share * static_cast<double>(free))];
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (critical_s[i] < critical_of_all_s) {
            Block& block = blocks_[i];
            block.mass_factor = std::pow(critical_of_all_s / critical_s[i], 2);
            block.mass_kg *= block.mass_factor;
            block.inertia_kgm2 *= block.mass_factor;
            block.weight_n *= block.mass_factor;
            block.rotation.momentum_nms *= block.mass_factor;
        }
    }
    step_s_ = laws_.step_factor * critical_of_all_s;
    step_when_held_s_ = held_step_factor() * sorted_s[free / 2];
}

ScaledMass RockMass::scaled_mass() const {
    ScaledMass scaled;
    double all_kg = 0.0, added_kg = 0.0;
    for (const Block& block : blocks_) {
        if (block.status != BlockStatus::fixed) {
            scaled.blocks += block.mass_factor > 1.0 ? 1 : 0;
            scaled.largest_factor = std::max(scaled.largest_factor, block.mass_factor);
            all_kg += block.mass_kg / block.mass_factor;
            added_kg += block.mass_kg - block.mass_kg / block.mass_factor;
        }
    }
    scaled.added_share = all_kg > 0.0 ? added_kg / all_kg : 0.0;
    return scaled;
}

}  // namespace rockfall::rock_mass
