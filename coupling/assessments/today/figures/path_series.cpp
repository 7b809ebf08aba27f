#include "coupling/assessments/today/figures/path_series.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "config/units/constants.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using rockfall::PathPoint;
using rockfall::PathRecord;

/// What a path has at a time, straight between its corners; at a time of several corners, as after them.
PathPoint point_at(const PathRecord& path, double time_s) {
    const auto& points = path.points;
    const auto next = std::upper_bound(
        points.begin(), points.end(), time_s,
        [](double time, const PathPoint& p) { return time < static_cast<double>(p.time_s); });
    if (next == points.end()) {
        return points.back();
    }
    if (next == points.begin()) {
        return points.front();
    }
    const PathPoint& before = *std::prev(next);
    const double between_s = static_cast<double>(next->time_s - before.time_s);
    const double share = (time_s - static_cast<double>(before.time_s)) / between_s;
    PathPoint at = before;
    at.position_m += share * (next->position_m - before.position_m);
    const auto go_on = [&](float PathPoint::*value) {
        at.*value += static_cast<float>(share) * ((*next).*value - before.*value);
    };
    go_on(&PathPoint::energy_j);
    go_on(&PathPoint::speed_mps);
    return at;
}

double run_out_of_path_m(const PathRecord& path) {
    return (path.points.back().position_m - path.points.front().position_m).head<2>().norm();
}

float largest_on_path_mps(const PathRecord& path) {
    float most_mps = 0.0F;
    for (const PathPoint& point : path.points) {
        most_mps = std::max(most_mps, point.speed_mps);
    }
    return most_mps;
}

std::string path_words(const std::vector<PathReason>& reasons) {
    std::string words;
    for (const PathReason reason : reasons) {
        words += words.empty() ? "" : " ";
        words += reason == PathReason::fastest    ? "fastest"
                 : reason == PathReason::farthest ? "farthest"
                 : reason == PathReason::median   ? "median"
                                                  : "named";
    }
    return words;
}

struct PathSeriesRow {
    const SeriesPath& shown;
    const PathMoment& moment;
    const Eigen::Vector2d& origin_m;
};

template <class Row, class Value>
ColumnsOf<Row> path_energy(const char* name, const char* meaning, const Value& value_j) {
    return {name, 3, meaning, [value_j](const Row& row) { return value_j(row) / j_per_kj; }};
}

constexpr const char* what_acceleration_is =
    "change of the mean velocity from the 0.1 s before to the 0.1 s after, by 0.1 s";

TableOf<PathSeriesRow> path_series_table() {
    return {
        "path_series.csv",
        "Chosen paths of blocks over time: place, speed, acceleration, energies.",
        "a block at a time on one slope",
        {{rock_column(), [](const auto& row) { return row.shown.path->rock; }},
         {cover_column(), [](const auto& row) { return name_of(row.shown.path->cover); }},
         {"chosen",
          "fastest: highest speed of all sampled paths on the slope; farthest: ends farthest from its "
          "release; median: in the middle by run-out; named: by output.path_rocks; blanks between several",
          [](const auto& row) { return path_words(row.shown.reasons); }},
         {"time_s", 3, "since the release", [](const auto& row) { return row.moment.time_s; }},
         {place_columns("", "the rock's underside"),
          [](const auto& row) {
              return Eigen::Vector3d{row.moment.place_m.x() + row.origin_m.x(),
                                     row.moment.place_m.y() + row.origin_m.y(), row.moment.place_m.z()};
          }},
         {"displacement_m", 3, "distance from the release",
          [](const auto& row) { return row.moment.displacement_m; }},
         {"speed_mps", 3, "speed of the centre", [](const auto& row) { return row.moment.speed_mps; }},
         {"acceleration_mps2", 3, what_acceleration_is,
          [](const auto& row) { return row.moment.acceleration_mps2; }},
         path_energy<PathSeriesRow>("energy_kj", "kinetic energy, translation and rotation",
                                    [](const auto& row) { return row.moment.kinetic_j; }),
         path_energy<PathSeriesRow>(
             "taken_kj",
             "taken by ground, trees, logs and nets so far: what the lost height released and "
             "the start gave, less the kinetic energy",
             [](const auto& row) { return row.moment.taken_j(); })}};
}

TableOf<PathMean> path_mean_table() {
    const auto energy = [](const char* name, const char* meaning, double PathMean::*part) {
        return path_energy<PathMean>(name, meaning, [part](const PathMean& mean) { return mean.*part; });
    };
    return {"path_means.csv",
            "Means of all sampled paths of blocks over time: speed, acceleration, displacement, energies.",
            "a time on one slope",
            {{cover_column(), [](const auto& mean) { return name_of(mean.cover); }},
             {"time_s", 3, "since the release", &PathMean::time_s},
             {"rocks", "sampled rocks that are under way", from_counting, &PathMean::rocks},
             {"displacement_m", 3,
              "mean distance of all sampled rocks from the release; those at their end count with that",
              &PathMean::displacement_m},
             {"speed_mps", 3, "mean speed of those under way", &PathMean::speed_mps},
             {"acceleration_mps2", 3, "mean over those under way of path_series.csv's acceleration",
              &PathMean::acceleration_mps2},
             energy("energy_kj", "mean kinetic energy of those under way", &PathMean::kinetic_j),
             energy("taken_kj", "mean over those under way: taken by ground, trees, logs and nets so far",
                    &PathMean::taken_j)}};
}

}  // namespace

std::vector<PathMoment> series_of(const PathRecord& path, double mass_kg, double step_s) {
    const double end_s = static_cast<double>(path.points.back().time_s);
    const PathPoint& start = path.points.front();
    const auto place_at = [&](double time_s) { return point_at(path, time_s).position_m; };
    std::vector<PathMoment> moments;
    const auto add = [&](double time_s, bool is_inside) {
        const PathPoint at = point_at(path, time_s);
        PathMoment moment;
        moment.time_s = time_s;
        moment.place_m = at.position_m;
        moment.displacement_m = (at.position_m - start.position_m).norm();
        moment.speed_mps = static_cast<double>(at.speed_mps);
        moment.kinetic_j = static_cast<double>(at.energy_j);
        moment.released_j = static_cast<double>(start.energy_j) +
                            mass_kg * config::gravity_mps2 * (start.position_m.z() - at.position_m.z());
        if (is_inside) {
            const Eigen::Vector3d change_m =
                place_at(time_s + step_s) - 2.0 * at.position_m + place_at(time_s - step_s);
            moment.acceleration_mps2 = change_m.norm() / (step_s * step_s);
        }
        moments.push_back(moment);
    };
    constexpr double rounding_s = 1e-6;
    for (std::size_t k = 0;; ++k) {
        const double time_s = static_cast<double>(k) * step_s;
        if (time_s > end_s - rounding_s) {
            break;
        }
        add(time_s, k > 0 && time_s + step_s <= end_s);
    }
    add(end_s, false);
    return moments;
}

double mass_of_rock_kg(const RunResults& results, const PathRecord& path) {
    const auto after = std::upper_bound(
        results.site.sources.begin(), results.site.sources.end(), path.rock,
        [](std::uint64_t rock, const rockfall::ReleaseSource& source) { return rock < source.first_rock; });
    double density_kgpm3 = results.scenario.release.density_kgpm3;
    if (after != results.site.sources.begin() && std::prev(after)->own_start) {
        density_kgpm3 = std::prev(after)->own_start->density_kgpm3;
    }
    return rockfall::Rock::sphere(static_cast<double>(path.diameter_m), density_kgpm3).mass_kg;
}

std::vector<PathMean> means_of_paths(const RunResults& results, rockfall::Cover cover) {
    struct Sum : PathMean {
        std::uint64_t accelerated = 0;
    };
    std::vector<Sum> sums;
    double ended_m = 0.0;  // of rocks at their end, for rows after it
    std::vector<std::pair<std::size_t, double>> ends;
    std::uint64_t paths = 0;
    for (const PathRecord& path : results.paths) {
        if (path.cover != cover || path.points.size() < 2) {
            continue;
        }
        ++paths;
        std::vector<PathMoment> moments = series_of(path, mass_of_rock_kg(results, path));
        const double end_m = moments.back().displacement_m;
        moments.pop_back();  // the end has a time of its own
        while (sums.size() < moments.size()) {
            Sum& sum = sums.emplace_back();
            sum.cover = cover;
            sum.time_s = static_cast<double>(sums.size() - 1) * series_step_s;
        }
        for (std::size_t k = 0; k < moments.size(); ++k) {
            const PathMoment& moment = moments[k];
            Sum& sum = sums[k];
            ++sum.rocks;
            sum.displacement_m += moment.displacement_m;
            sum.speed_mps += moment.speed_mps;
            sum.kinetic_j += moment.kinetic_j;
            sum.taken_j += moment.taken_j();
            if (moment.acceleration_mps2) {
                sum.acceleration_mps2 = sum.acceleration_mps2.value_or(0.0) + *moment.acceleration_mps2;
                ++sum.accelerated;
            }
        }
        ends.emplace_back(moments.size(), end_m);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<PathMean> means;
    auto end = ends.begin();
    for (std::size_t k = 0; k < sums.size(); ++k) {
        for (; end != ends.end() && end->first <= k; ++end) {
            ended_m += end->second;
        }
        Sum& sum = sums[k];
        const auto rocks = static_cast<double>(sum.rocks);
        sum.displacement_m = (sum.displacement_m + ended_m) / static_cast<double>(paths);
        for (double* value : {&sum.speed_mps, &sum.kinetic_j, &sum.taken_j}) {
            *value /= rocks;
        }
        if (sum.acceleration_mps2) {
            *sum.acceleration_mps2 /= static_cast<double>(sum.accelerated);
        }
        means.push_back(sum);
    }
    return means;
}

std::vector<SeriesPath> paths_of_series(const RunResults& results, rockfall::Cover cover) {
    std::vector<const PathRecord*> paths;
    for (const PathRecord& path : results.paths) {
        if (path.cover == cover && path.points.size() > 1) {
            paths.push_back(&path);
        }
    }
    if (paths.empty()) {
        return {};
    }
    std::stable_sort(paths.begin(), paths.end(), [](const PathRecord* a, const PathRecord* b) {
        return run_out_of_path_m(*a) < run_out_of_path_m(*b);
    });
    const auto fastest =
        std::max_element(paths.begin(), paths.end(), [](const PathRecord* a, const PathRecord* b) {
            return largest_on_path_mps(*a) < largest_on_path_mps(*b);
        });
    std::vector<SeriesPath> chosen;
    const auto choose = [&](const PathRecord* path, PathReason reason) {
        const auto same = std::find_if(chosen.begin(), chosen.end(),
                                       [&](const SeriesPath& other) { return other.path == path; });
        if (same == chosen.end()) {
            chosen.push_back({path, {reason}});
        } else {
            same->reasons.push_back(reason);
        }
    };
    choose(*fastest, PathReason::fastest);
    choose(paths.back(), PathReason::farthest);
    choose(paths[paths.size() / 2], PathReason::median);
    for (const double rock : results.scenario.output.path_rocks) {
        const auto found = std::find_if(paths.begin(), paths.end(), [&](const PathRecord* path) {
            return static_cast<double>(path->rock) == rock;
        });
        if (found != paths.end()) {
            choose(*found, PathReason::named);
        }
    }
    return chosen;
}

bool has_path_series(const RunResults& results) {
    return rockfall::description_of(results.scenario.rockfall.fall.motion.model).has_shape &&
           std::any_of(results.paths.begin(), results.paths.end(),
                       [](const PathRecord& path) { return path.points.size() > 1; });
}

std::vector<TableLayout> path_series_layouts() {
    return {path_series_table(), path_mean_table()};
}

void write_path_series(const RunResults& results, const std::filesystem::path& folder,
                       std::vector<WrittenFile>& written) {
    if (!has_path_series(results)) {
        return;
    }
    const Eigen::Vector2d origin_m = results.site.origin_m();
    written.push_back(path_series_table().write(folder, [&](auto& rows) {
        for (const Cover cover : covers_of(results)) {
            for (const SeriesPath& path : paths_of_series(results, cover)) {
                for (const PathMoment& moment : series_of(*path.path, mass_of_rock_kg(results, *path.path))) {
                    rows.add({path, moment, origin_m});
                }
            }
        }
    }));
    written.push_back(path_mean_table().write(folder, [&](auto& rows) {
        for (const Cover cover : covers_of(results)) {
            rows.add_all(means_of_paths(results, cover));
        }
    }));
}

}  // namespace coupling
