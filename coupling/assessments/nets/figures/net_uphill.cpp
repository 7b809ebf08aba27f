#include "coupling/assessments/nets/figures/net_uphill.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_try.hpp"

namespace coupling {
namespace {

/// So far apart lie the places along a line at which the ground is asked which way is uphill.
constexpr double gradient_step_m = 2.0;
constexpr double no_height_m = 1e-9;
/// Length of the mean of unit vectors below which rocks come from no common direction [choice].
constexpr double least_in_common = 0.2;

constexpr double rad_per_deg = 3.14159265358979323846 / 180.0;

}  // namespace

double Uphill::azimuth_deg() const {
    const double deg = std::atan2(direction.x(), direction.y()) / rad_per_deg;
    return deg < 0.0 ? deg + 360.0 : deg;
}

const char* name_of(Uphill::From from) {
    constexpr std::array<const char*, 3> names{"rocks", "gradient", "given"};
    return names[static_cast<std::size_t>(from)];
}

Uphill uphill_along(double azimuth_deg) {
    const double azimuth_rad = azimuth_deg * rad_per_deg;
    return {{std::sin(azimuth_rad), std::cos(azimuth_rad)}, Uphill::From::given};
}

std::optional<Eigen::Vector2d> uphill_across(const rockfall::Net& net, const rockfall::Terrain& terrain) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i + 1 < net.line_m.size(); ++i) {
        const Eigen::Vector2d way_m = net.line_m[i + 1] - net.line_m[i];
        const double length_m = way_m.norm();
        const int steps = static_cast<int>(std::ceil(length_m / gradient_step_m));
        for (int k = 0; k < steps; ++k) {
            const Eigen::Vector2d place = net.line_m[i] + (k + 0.5) / steps * way_m;
            if (const auto triangle = terrain.locate(place.x(), place.y())) {
                sum += length_m / steps * terrain.plane_of(*triangle).gradient;
            }
        }
    }
    constexpr double level = 1e-3;  // of the mean gradient
    return sum.norm() < level * length_m(net) ? std::nullopt : std::optional{sum.normalized()};
}

rockfall::NetIndex lines_alone(std::span<const NetRecord> lines) {
    std::vector<rockfall::Net> alone;
    for (const NetRecord& record : lines) {
        alone.push_back({record.net.line_m, no_height_m, 0.0, record.net.capacity_j});
    }
    return rockfall::NetIndex{alone};
}

Arrivals::Arrivals(std::span<const NetRecord> lines, const rockfall::Terrain& terrain)
    : lines_{lines}, terrain_{terrain}, index_{lines_alone(lines)}, sums_(lines.size()) {}

void Arrivals::look(const StoredPath& path) {
    TriedNets on_lines;
    try_nets(index_, terrain_, path, on_lines);
    for (std::size_t i = 0; i < on_lines.rows.size(); ++i) {
        const rockfall::NetCrossingRecord& crossing = on_lines.rows[i].crossing;
        const StoredPiece& piece = path.pieces[on_lines.when[i].first];
        const Eigen::Vector3d way = piece.flies ? piece.other : Eigen::Vector3d{piece.other - piece.start_m};
        const Eigen::Vector2d in_plan = way.head<2>();
        if (crossing.first && in_plan.norm() > 0.0) {
            Sum& sum = sums_[crossing.net][static_cast<std::size_t>(path.cover)];
            sum.directions += in_plan.normalized();
            ++sum.rocks;
        }
    }
}

std::optional<Uphill> Arrivals::uphill(std::uint32_t line) const {
    const auto& of_line = sums_[line];
    const Sum& with_forest = of_line[static_cast<std::size_t>(rockfall::Cover::forest)];
    const Sum& sum =
        with_forest.rocks > 0 ? with_forest : of_line[static_cast<std::size_t>(rockfall::Cover::bare)];
    if (sum.rocks > 0 && sum.directions.norm() >= least_in_common * static_cast<double>(sum.rocks)) {
        return Uphill{-sum.directions.normalized(), Uphill::From::rocks, sum.rocks};
    }
    const auto gradient = uphill_across(lines_[line].net, terrain_);
    return gradient ? std::optional{Uphill{*gradient, Uphill::From::gradient}} : std::nullopt;
}

}  // namespace coupling
