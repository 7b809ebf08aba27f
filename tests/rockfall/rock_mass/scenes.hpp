#pragma once

#include <array>
#include <vector>

#include "rockfall/rock_mass/rock_mass.hpp"
#include "rockfall/solids/shapes.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall::rock_mass::scenes {

using Eigen::Vector3d;

/// A cube with its middle at a place, its sides along the axes.
inline BlockStart cube_at(const Vector3d& middle_m, double side_m, double density_kgpm3 = 2500.0,
                          bool fixed = false) {
    return block_of(
        solids::placed(solids::box(Vector3d::Constant(side_m)), Eigen::Quaterniond::Identity(), middle_m),
        density_kgpm3, fixed);
}

/// The bond over the square that two cubes share whose middles lie a side apart.
inline BondStart bond_between(std::uint32_t first, std::uint32_t second, const Vector3d& from_m,
                              const Vector3d& to_m, double side_m, BondStrength strength = {1e99, 1e99}) {
    BondStart bond{first, second, {}, (to_m - from_m).normalized(), strength};
    const Vector3d middle_m = 0.5 * (from_m + to_m);
    const Vector3d u = 0.5 * side_m * bond.normal.unitOrthogonal();
    const Vector3d w = bond.normal.cross(u);
    bond.polygon_m = {middle_m + u + w, middle_m - u + w, middle_m - u - w, middle_m + u - w};
    return bond;
}

/// Laws without gravity, friction and damping: nothing takes energy.
inline Laws lossless() {
    Laws laws;
    laws.gravity_mps2 = 0.0;
    laws.friction = laws.ground_friction = 0.0;
    laws.damping_ratio = 0.0;
    laws.sleeping = false;
    return laws;
}

/// A plane z = x tan(dip) of two triangles, 400 m wide, through the origin; down is -x.
inline Terrain plane_of(double rise) {
    std::vector<Vertex> vertices;
    for (const auto& [x, y] : {std::array{-200.0, -200.0}, std::array{200.0, -200.0},
                               std::array{200.0, 200.0}, std::array{-200.0, 200.0}}) {
        vertices.push_back({x, y, rise * x});
    }
    std::vector<Triangle> triangles(2);
    triangles[0] = {{0, 1, 2}, {no_triangle, no_triangle, 1}};
    triangles[1] = {{0, 2, 3}, {0, no_triangle, no_triangle}};
    return Terrain{{0.0, 0.0}, std::move(vertices), std::move(triangles)};
}

/// Residual of the ledger by the energy turned over [-].
inline double residual_share(const RockMass& mass) {
    const Ledger ledger = mass.ledger();
    return ledger.residual_j() / ledger.turnover_j(mass.motion_at_start_j());
}

}  // namespace rockfall::rock_mass::scenes
