#include "rockfall/solids/mass_properties.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"

namespace rockfall::solids {

using Eigen::Matrix3d;
using Eigen::Vector3d;

VolumeIntegrals volume_integrals(const Hull& hull) {
    // Seen from a vertex, far-away origins cost no digits.
    const Vector3d origin_m = hull.vertices_m[0];
    double six_volumes = 0.0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();
    for (const Face& face : hull.faces) {
        const Vector3d a = hull.vertices_m[face.corners[0]] - origin_m;
        for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) {
            const Vector3d b = hull.vertices_m[face.corners[k]] - origin_m;
            const Vector3d c = hull.vertices_m[face.corners[k + 1]] - origin_m;
            // Of the tetrahedron 0abc with s = a + b + c: V = det / 6, the integral of x is V s / 4, that of
            // x x^T is V (a a^T + b b^T + c c^T + s s^T) / 20.
            const double det = a.dot(b.cross(c));
            const Vector3d s = a + b + c;
            six_volumes += det;
            first += det * s;
            second += det * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
        }
    }
    const double volume_m3 = six_volumes / 6.0;
    const Vector3d centre = first / (4.0 * six_volumes);
    const Matrix3d covariance = second / 120.0 - volume_m3 * centre * centre.transpose();
    return {volume_m3, origin_m + centre, covariance.trace() * Matrix3d::Identity() - covariance};
}

PrincipalAxes principal_axes(const Matrix3d& symmetric) {
    Matrix3d m = symmetric;
    Matrix3d axes = Matrix3d::Identity();
    // What rounding leaves off the diagonal of a symmetric body is no reason to turn its axes.
    const double negligible = 1e-15 * m.diagonal().cwiseAbs().maxCoeff();
    constexpr int most_sweeps = 30;  // converges quadratically: 4 to 6 are needed
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool turned = false;
        for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            if (std::abs(m(p, q)) <= negligible) {
                continue;
            }
            const double theta = (m(q, q) - m(p, p)) / (2.0 * m(p, q));
            const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
            const double c = 1.0 / std::sqrt(t * t + 1.0);
            Matrix3d turn = Matrix3d::Identity();
            turn(p, p) = turn(q, q) = c;
            turn(p, q) = t * c;
            turn(q, p) = -t * c;
            m = turn.transpose() * m * turn;
            axes = axes * turn;
            turned = true;
        }
        if (!turned) {
            break;
        }
    }
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return m(i, i) < m(j, j); });
    PrincipalAxes result{};
    for (int k = 0; k < 3; ++k) {
        const int from = order[static_cast<std::size_t>(k)];
        result.moments[k] = m(from, from);
        result.axes.col(k) = axes.col(from).normalized();
    }
    if (result.axes.determinant() < 0.0) {
        result.axes.col(2) = -result.axes.col(2);
    }
    return result;
}

double Solid::diameter_m() const {
    return config::pow_of(6.0 * volume_m3 / std::numbers::pi, 1.0 / 3.0);
}

Solid solid_of(const Hull& hull, double density_kgpm3) {
    assert(density_kgpm3 > 0.0);
    const VolumeIntegrals integrals = volume_integrals(hull);
    const PrincipalAxes principal = principal_axes(integrals.inertia_m5);
    const Matrix3d to_principal = principal.axes.transpose();
    Solid solid{hull,
                integrals.volume_m3,
                density_kgpm3 * integrals.volume_m3,
                density_kgpm3 * principal.moments,
                integrals.centroid_m,
                Eigen::Quaterniond{to_principal}.normalized(),
                0.0};
    for (Vector3d& vertex_m : solid.hull.vertices_m) {
        vertex_m = to_principal * (vertex_m - integrals.centroid_m);
        solid.bounding_radius_m = std::max(solid.bounding_radius_m, vertex_m.norm());
    }
    for (Face& face : solid.hull.faces) {
        face.offset_m -= face.normal.dot(integrals.centroid_m);
        face.normal = to_principal * face.normal;
    }
    return solid;
}

Solid ball_of(double diameter_m, double density_kgpm3) {
    assert(diameter_m > 0.0 && density_kgpm3 > 0.0);
    const double radius_m = 0.5 * diameter_m;
    const double volume_m3 = std::numbers::pi / 6.0 * diameter_m * diameter_m * diameter_m;
    const double mass_kg = density_kgpm3 * volume_m3;
    return {{},
            volume_m3,
            mass_kg,
            Eigen::Vector3d::Constant(0.4 * mass_kg * radius_m * radius_m),
            Eigen::Vector3d::Zero(),
            Eigen::Quaterniond::Identity(),
            radius_m};
}

}  // namespace rockfall::solids
