#include "rockfall/tally/reach_angle.hpp"

#include <algorithm>
#include <cstddef>

#include "config/math/elementary.hpp"

namespace rockfall {
namespace {

config::Angle below_horizon(double fall_m, double distance_m) {
    constexpr double at_once_m = 1e-9;
    return config::Angle::from_radians(config::atan_of(fall_m / std::max(distance_m, at_once_m)));
}

/// The first cliff on the way from the stop back to the start; the start where there is none.
Eigen::Vector2d lowest_cliff_m(const Terrain& terrain, const Eigen::Vector2d& start_m,
                               const Eigen::Vector2d& stop_m, const CliffRule& rule) {
    const auto steps = static_cast<std::size_t>((start_m - stop_m).norm()) + 1;
    for (std::size_t step = 1; step < steps; ++step) {
        const Eigen::Vector2d place_m =
            stop_m + static_cast<double>(step) / static_cast<double>(steps) * (start_m - stop_m);
        if (is_cliff(terrain, place_m, rule)) {
            return place_m;
        }
    }
    return start_m;
}

}  // namespace

bool is_cliff(const Terrain& terrain, const Eigen::Vector2d& place_m, const CliffRule& rule) {
    const double half_m = 0.5 * rule.over_m;
    const auto west = terrain.height_m(place_m.x() - half_m, place_m.y());
    const auto east = terrain.height_m(place_m.x() + half_m, place_m.y());
    const auto south = terrain.height_m(place_m.x(), place_m.y() - half_m);
    const auto north = terrain.height_m(place_m.x(), place_m.y() + half_m);
    if (!west || !east || !south || !north) {
        return false;
    }
    const auto [sine, cosine] = config::sin_cos_of(rule.from.in_radians());
    const Eigen::Vector2d rise_m{*east - *west, *north - *south};
    return rise_m.norm() * cosine >= rule.over_m * sine;
}

std::optional<ReachAngles> reach_angles(const Terrain& terrain, const Eigen::Vector2d& start_m,
                                        const Eigen::Vector2d& stop_m, const CliffRule& rule) {
    const auto start_height_m = terrain.height_m(start_m.x(), start_m.y());
    const auto stop_height_m = terrain.height_m(stop_m.x(), stop_m.y());
    if (!start_height_m || !stop_height_m) {
        return {};
    }
    const double fall_m = *start_height_m - *stop_height_m;
    ReachAngles angles{fall_m, below_horizon(fall_m, (start_m - stop_m).norm()), {}};
    if (!is_cliff(terrain, stop_m, rule)) {
        const Eigen::Vector2d cliff_m = lowest_cliff_m(terrain, start_m, stop_m, rule);
        const double cliff_height_m = terrain.height_m(cliff_m.x(), cliff_m.y()).value_or(*start_height_m);
        angles.shadow = below_horizon(cliff_height_m - *stop_height_m, (cliff_m - stop_m).norm());
    }
    return angles;
}

}  // namespace rockfall
