// The targets that a footprint meets.

#include <algorithm>
#include <cmath>

#include "rockfall/tally/footprint.hpp"

namespace rockfall {

std::optional<Footprint::Meeting> Footprint::meeting(std::uint32_t target, const Eigen::Vector2d& from_m,
                                                     const Eigen::Vector2d& to_m) const {
    if (reached_[target] == by_centre) {
        return std::nullopt;
    }
    if (const auto share = first_crossing(targets_[target], from_m, to_m)) {
        return Meeting{*share, false};
    }
    if (!targets_[target].is_hit_by_side || reached_[target] == by_side) {
        return std::nullopt;
    }
    const auto share = first_touch(targets_[target], from_m, to_m, radius_m_);
    return share ? std::optional{Meeting{*share, true}} : std::nullopt;
}

std::optional<Footprint::Meeting> Footprint::meeting_beside_roofs(
    std::uint32_t target, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
    const std::function<double(double)>& energy_j) const {
    const std::vector<Roof>& roofs = targets_[target].roofs;
    const Eigen::Vector2d way_m = to_m - from_m;
    const double length_m = way_m.norm();
    constexpr double past_m = 1e-3;  // a line that was met below a roof is met again beyond it
    double begin = 0.0;
    while (begin <= 1.0) {
        std::optional<Meeting> met = meeting(target, from_m + begin * way_m, to_m);
        if (!met) {
            return std::nullopt;
        }
        met->share = begin + met->share * (1.0 - begin);
        const Eigen::Vector2d place_m = from_m + met->share * way_m;
        const bool is_held = std::any_of(roofs.begin(), roofs.end(), [&](const Roof& roof) {
            return is_below(roof, place_m) && energy_j(met->share) <= roof.capacity_j;
        });
        if (!is_held) {
            return met;
        }
        begin = met->share + past_m / std::max(length_m, past_m);
    }
    return std::nullopt;
}

std::size_t Footprint::arrive(std::uint32_t target, bool side, const Eigen::Vector2d& place_m,
                              double energy_j, double translational_j, double speed_mps, double height_m) {
    const auto touched = reached_[target] == by_side
                             ? std::find_if(arrivals_.begin(), arrivals_.end(),
                                            [&](const TargetArrival& seen) { return seen.target == target; })
                             : arrivals_.insert(arrivals_.end(), TargetArrival{target, {}});
    reached_[target] = side ? by_side : by_centre;
    touched->arrival = {true,
                        side,
                        static_cast<float>(place_m.x()),
                        static_cast<float>(place_m.y()),
                        static_cast<float>(energy_j),
                        static_cast<float>(translational_j),
                        static_cast<float>(speed_mps),
                        static_cast<float>(std::max(0.0, height_m)),
                        static_cast<float>(height_m + radius_m_),
                        static_cast<float>(height_m + 2.0 * radius_m_)};
    return static_cast<std::size_t>(touched - arrivals_.begin());
}

namespace {

/// Whether a rock that comes down at a place with so much energy breaks a roof there.
bool breaks_roof(const Target& target, const Eigen::Vector2d& place_m, double energy_j) {
    return std::any_of(target.roofs.begin(), target.roofs.end(), [&](const Roof& roof) {
        return energy_j > roof.capacity_j && is_below(roof, place_m);
    });
}

}  // namespace

void Footprint::watch_targets(const Rock& rock, const Flight& flight, double until_s,
                              std::span<const Stretch> stretches, double rotation_j) {
    const Eigen::Vector2d from = flight.start_m.head<2>();
    const Eigen::Vector2d to = flight.position_m(until_s).head<2>();
    const auto enter = [&](std::uint32_t target, bool side, double time_s) {
        const Eigen::Vector3d place = flight.position_m(time_s);
        std::size_t k = 0;
        while (k + 1 < stretches.size() && stretches[k].end_s < time_s) {
            ++k;
        }
        const double ground_m = terrain_.plane_of(stretches[k].triangle).height_m(place.x(), place.y());
        const double squared_speed = flight.squared_speed_at(time_s);
        const double translational_j = 0.5 * rock.mass_kg * squared_speed;
        wait_for_pose(time_s, arrive(target, side, place.head<2>(), translational_j + rotation_j,
                                     translational_j, std::sqrt(squared_speed), place.z() - ground_m));
    };
    const double end_j = 0.5 * rock.mass_kg * flight.squared_speed_at(until_s) + rotation_j;
    for (const std::uint32_t i : target_index_.near_piece(from, to)) {
        // In the air above a roof a rock passes what lies below; where it comes down it may break the roof.
        if (const auto met = meeting(i, from, to, [](double) { return 0.0; })) {
            enter(i, met->by_side, met->share * until_s);
        }
        if (reached_[i] != by_centre && breaks_roof(targets_[i], to, end_j)) {
            enter(i, false, until_s);
        }
    }
}

}  // namespace rockfall
