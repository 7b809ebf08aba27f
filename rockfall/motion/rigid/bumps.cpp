#include "rockfall/motion/rigid/bumps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Vector2d;

constexpr double steepest_share = 0.25;
constexpr double row_share = std::numbers::sqrt3 / 2.0;  ///< distance of rows by that of nodes

/// The sum of two uniforms has its standard deviation times this as its largest value.
const double largest_by_deviation = std::sqrt(6.0);

double deviation_on(const Law& law, const SurfaceType& type, double spacing_m) {
    return std::min(roughness_of(law, type.roughness_m), steepest_share * spacing_m);
}

/// Distance of neighbouring points of the survey by the triangle between them: the leg of a right-angled one
/// with two equal legs, as a grid has them [m].
double cell_of(const Terrain& terrain, std::uint32_t triangle) {
    const Triangle& t = terrain.triangles()[triangle];
    double longest_m = 0.0;
    Vector2d corners_m[3];
    for (int k = 0; k < 3; ++k) {
        const Vertex& v = terrain.vertices()[t.corners[k]];
        corners_m[k] = {v.x_m, v.y_m};
    }
    for (int k = 0; k < 3; ++k) {
        longest_m = std::max(longest_m, (corners_m[(k + 1) % 3] - corners_m[k]).norm());
    }
    const Vector2d a = corners_m[1] - corners_m[0], b = corners_m[2] - corners_m[0];
    return std::numbers::sqrt2 * std::abs(a.x() * b.y() - a.y() * b.x()) / longest_m;
}

}  // namespace

Bumps::Bumps(const SlopeView& slope, const Law& law, double diameter_m, const config::StreamKey& key)
    : slope_{slope}, law_{&law}, draws_{key, config::Purpose::roughness}, spacing_m_{diameter_m} {
    for (const SurfaceType& type : slope.types()) {
        highest_m_ = std::max(highest_m_, largest_by_deviation * deviation_on(law, type, spacing_m_));
    }
    const config::FourUniforms shift = draws_.uniforms_of(0), turn = draws_.uniforms_of(1);
    origin_m_ = spacing_m_ * Vector2d{shift[2], shift[3]};
    // The lattice is the same again after a sixth of a turn.
    const config::SinCos of_turn = config::sin_cos_of(std::numbers::pi / 3.0 * turn[2]);
    along_ = {of_turn.cos, of_turn.sin};
}

Bumps::Place Bumps::place_of(const Vector2d& plan_m) const {
    const Vector2d off_m = plan_m - origin_m_;
    const double x = off_m.dot(along_) / spacing_m_;
    const double v = off_m.dot(Vector2d{-along_.y(), along_.x()}) / (row_share * spacing_m_);
    return {x - 0.5 * v, v};
}

Eigen::Vector3d Bumps::normal_of(const Vector2d& gradient, const Vector2d& slope_m) const {
    const double along = slope_m.x() / spacing_m_;
    const double across = (slope_m.y() - 0.5 * slope_m.x()) / (row_share * spacing_m_);
    const Vector2d whole = gradient + along * along_ + across * Vector2d{-along_.y(), along_.x()};
    return Eigen::Vector3d{-whole.x(), -whole.y(), 1.0}.normalized();
}

Vector2d Bumps::plan_of(int u, int v) const {
    return origin_m_ +
           spacing_m_ * ((u + 0.5 * v) * along_ + row_share * v * Vector2d{-along_.y(), along_.x()});
}

double Bumps::deviation_m(std::uint32_t triangle, const Vector2d& plan_m) const {
    const double hidden = 1.0 - spacing_m_ / cell_of(slope_.terrain(), triangle);
    return hidden > 0.0
               ? std::sqrt(hidden) *
                     deviation_on(*law_, slope_.type_at(triangle, plan_m.x(), plan_m.y()), spacing_m_)
               : 0.0;
}

void Bumps::find_nodes(const Vector2d& centre_m, double radius_m, std::uint32_t under, Nodes& nodes) const {
    const Place centre = place_of(centre_m);
    const double reach = radius_m / (row_share * spacing_m_);
    nodes.first_u = static_cast<int>(std::floor(centre.u - reach));
    nodes.first_v = static_cast<int>(std::floor(centre.v - reach));
    nodes.along_u = static_cast<int>(std::floor(centre.u + reach)) + 2 - nodes.first_u;
    nodes.along_v = static_cast<int>(std::floor(centre.v + reach)) + 2 - nodes.first_v;
    nodes.heights_m.assign(static_cast<std::size_t>(nodes.along_u * nodes.along_v), 0.0);
    nodes.flat = true;
    constexpr unsigned low_bits = 0xFFFU;
    for (int i = 0; i < nodes.along_u * nodes.along_v; ++i) {
        const int u = nodes.first_u + i % nodes.along_u, v = nodes.first_v + i / nodes.along_u;
        const Vector2d plan_m = plan_of(u, v);
        const auto triangle = slope_.terrain().locate(plan_m.x(), plan_m.y(), under);
        const double deviation = triangle ? deviation_m(*triangle, plan_m) : 0.0;
        if (deviation > 0.0) {
            const config::FourUniforms draw = draws_.uniforms_of((static_cast<unsigned>(u) & low_bits) << 12 |
                                                                 (static_cast<unsigned>(v) & low_bits));
            nodes.heights_m[static_cast<std::size_t>(i)] =
                largest_by_deviation * deviation * (draw[0] + draw[1] - 1.0);
            nodes.flat = false;
        }
    }
}

}  // namespace rockfall::rigid
