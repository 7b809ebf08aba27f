#include "coupling/inputs/observed/stops.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::observed {

namespace {

/// A way from release to stop in plan.
struct Way {
    Eigen::Vector2d start_m;
    Eigen::Vector2d end_m;
    bool left_terrain = false;

    [[nodiscard]] double run_out_m() const { return (end_m - start_m).norm(); }
};

std::vector<Way> ways_of(std::span<const SimulatedStop> simulated, const std::set<std::uint32_t>& zones) {
    std::vector<Way> ways;
    for (const SimulatedStop& stop : simulated) {
        if (zones.empty() || zones.contains(stop.zone)) {
            ways.push_back({stop.start_m, stop.end_m, stop.left_terrain});
        }
    }
    return ways;
}

Eigen::Vector2d mean_start(const std::vector<Way>& ways) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Way& way : ways) {
        sum += way.start_m;
    }
    return sum / static_cast<double>(ways.size());
}

/// The release that is given, else the mean one of the rocks of its zone.
std::vector<Way> ways_of(std::span<const ObservedStop> observed, std::span<const SimulatedStop> simulated) {
    std::vector<Way> ways;
    for (const ObservedStop& stop : observed) {
        if (stop.start_m) {
            ways.push_back({*stop.start_m, stop.end_m});
            continue;
        }
        const std::vector<Way> like =
            ways_of(simulated, stop.zone ? std::set{*stop.zone} : std::set<std::uint32_t>{});
        if (!like.empty()) {
            ways.push_back({mean_start(like), stop.end_m});
        }
    }
    return ways;
}

Eigen::Vector2d axis_of(const std::vector<Way>& ways) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Way& way : ways) {
        sum += way.end_m - way.start_m;
    }
    return sum.norm() > 0.0 ? Eigen::Vector2d{sum.normalized()} : Eigen::Vector2d::UnitX();
}

Distribution run_outs(const std::vector<Way>& ways) {
    std::vector<double> values;
    values.reserve(ways.size());
    for (const Way& way : ways) {
        values.push_back(way.run_out_m());
    }
    return Distribution{std::move(values)};
}

StopFigures figures_of(const std::vector<Way>& ways, const Distribution& run_out,
                       const Eigen::Vector2d& axis) {
    StopFigures figures;
    figures.rocks = ways.size();
    figures.mean_m = run_out.mean();
    figures.deviation_m = run_out.deviation();
    for (std::size_t i = 0; i < quantile_shares.size(); ++i) {
        figures.quantiles_m[i] = run_out.quantile(quantile_shares[i]);
    }
    figures.longest_m = run_out.quantile(1.0);
    std::vector<double> sideways;
    std::size_t left = 0;
    for (const Way& way : ways) {
        const Eigen::Vector2d along = way.end_m - way.start_m;
        sideways.push_back(axis.x() * along.y() - axis.y() * along.x());
        left += way.left_terrain ? 1 : 0;
    }
    figures.sideways_m = Distribution{std::move(sideways)}.deviation();
    figures.left_terrain = static_cast<double>(left) / static_cast<double>(ways.size());
    return figures;
}

std::optional<StopComparison> compare(const std::string& group, std::span<const ObservedStop> observed,
                                      std::span<const SimulatedStop> simulated) {
    std::set<std::uint32_t> zones;
    bool of_any_zone = false;
    for (const ObservedStop& stop : observed) {
        if (stop.zone) {
            zones.insert(*stop.zone);
        } else {
            of_any_zone = true;
        }
    }
    const std::vector<Way> seen = ways_of(observed, simulated);
    const std::vector<Way> fallen = ways_of(simulated, of_any_zone ? std::set<std::uint32_t>{} : zones);
    if (seen.empty() || fallen.empty()) {
        return std::nullopt;
    }
    const Eigen::Vector2d axis = axis_of(seen);
    const Distribution seen_run_out = run_outs(seen);
    const Distribution fallen_run_out = run_outs(fallen);
    StopComparison comparison;
    comparison.group = group;
    comparison.observed = figures_of(seen, seen_run_out, axis);
    comparison.simulated = figures_of(fallen, fallen_run_out, axis);
    comparison.largest_distance = largest_distance(seen_run_out, fallen_run_out);
    comparison.distance_by_chance = distance_by_chance(seen.size(), fallen.size());
    comparison.energy_distance_m = energy_distance(seen_run_out, fallen_run_out);
    comparison.observed_run_out_m.assign(seen_run_out.values().begin(), seen_run_out.values().end());
    comparison.simulated_run_out_m.assign(fallen_run_out.values().begin(), fallen_run_out.values().end());
    return comparison;
}

}  // namespace

std::vector<StopComparison> compare_stops(std::span<const ObservedStop> observed,
                                          std::span<const SimulatedStop> simulated) {
    std::vector<StopComparison> comparisons;
    if (auto all = compare("", observed, simulated)) {
        comparisons.push_back(std::move(*all));
    }
    std::set<std::string> groups;
    for (const ObservedStop& stop : observed) {
        groups.insert(stop.group);
    }
    if (groups.size() < 2) {
        return comparisons;
    }
    for (const std::string& group : groups) {
        std::vector<ObservedStop> members;
        std::copy_if(observed.begin(), observed.end(), std::back_inserter(members),
                     [&](const ObservedStop& stop) { return stop.group == group; });
        if (auto one = compare(group, members, simulated)) {
            comparisons.push_back(std::move(*one));
        }
    }
    return comparisons;
}

}  // namespace coupling::observed
