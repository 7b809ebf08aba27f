#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;
using rockfall::PathRecord;

/// A path that is worth a drawing, and why.
struct ChosenPath {
    const PathRecord* path;
    std::string why;
};

float largest_energy_j(const PathRecord& path) {
    float most_j = 0.0F;
    for (const rockfall::PathPoint& point : path.points) {
        most_j = std::max(most_j, point.energy_j);
    }
    return most_j;
}

double run_out_m(const PathRecord& path) {
    return (path.points.back().position_m - path.points.front().position_m).head<2>().norm();
}

/// As many lines as a chart can hold apart.
constexpr std::size_t most_lines = 3;

/// The rocks that the user named, the first ones of them.
std::vector<ChosenPath> named(const RunResults& results, Cover cover) {
    std::vector<ChosenPath> chosen;
    for (const double rock : results.scenario.output.path_rocks) {
        const auto found =
            std::find_if(results.paths.begin(), results.paths.end(), [&](const PathRecord& path) {
                return path.cover == cover && static_cast<double>(path.rock) == rock &&
                       path.points.size() > 1;
            });
        if (found != results.paths.end() && chosen.size() < most_lines) {
            chosen.push_back({&*found, "output.path_rocks"});
        }
    }
    return chosen;
}

/// Of the sampled paths on a slope: the one with the most energy, the one that goes farthest, and the one in
/// the middle by run-out.
std::vector<ChosenPath> choose(const RunResults& results, Cover cover) {
    std::vector<const PathRecord*> paths;
    for (const PathRecord& path : results.paths) {
        if (path.cover == cover && path.points.size() > 1) {
            paths.push_back(&path);
        }
    }
    if (paths.empty()) {
        return {};
    }
    std::stable_sort(paths.begin(), paths.end(),
                     [](const PathRecord* a, const PathRecord* b) { return run_out_m(*a) < run_out_m(*b); });
    const auto strongest = std::max_element(
        paths.begin(), paths.end(),
        [](const PathRecord* a, const PathRecord* b) { return largest_energy_j(*a) < largest_energy_j(*b); });
    const std::array<std::pair<const PathRecord*, std::string>, 3> wanted{
        {{*strongest, page_text("most energy")},
         {paths.back(), page_text("farthest")},
         {paths[paths.size() / 2], page_text("median run-out")}}};
    std::vector<ChosenPath> chosen;
    for (const auto& [path, why] : wanted) {
        const auto same = std::find_if(chosen.begin(), chosen.end(),
                                       [path = path](const ChosenPath& c) { return c.path == path; });
        if (same == chosen.end()) {
            chosen.push_back({path, why});
        } else {
            same->why = join_with_commas({same->why, why});
        }
    }
    return chosen;
}

/// Plan distance along a path at each of its corners.
std::vector<double> distances_m(const PathRecord& path) {
    std::vector<double> distances{0.0};
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        distances.push_back(distances.back() +
                            (path.points[i].position_m - path.points[i - 1].position_m).head<2>().norm());
    }
    return distances;
}

/// A quantity along chosen paths; energy in kJ, heights in m.
std::string chart(const std::vector<ChosenPath>& chosen, const std::string& title, const std::string& y_title,
                  double (*value)(const rockfall::PathPoint&), bool energy_marks,
                  const std::string& caption) {
    double longest_m = 1.0;
    double highest = 1e-3;
    for (const ChosenPath& c : chosen) {
        longest_m = std::max(longest_m, distances_m(*c.path).back());
        for (const rockfall::PathPoint& point : c.path->points) {
            highest = std::max(highest, value(point));
        }
    }
    Chart drawn{title, Axis::from_zero(page_text("Distance in plan along the path, m"), longest_m),
                Axis::from_zero(y_title, highest)};
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const std::vector<double> distances = distances_m(*chosen[i].path);
        std::vector<ChartPoint> points;
        for (std::size_t k = 0; k < distances.size(); ++k) {
            points.push_back({distances[k], value(chosen[i].path->points[k])});
        }
        const std::string series = joined("path", std::to_string(i));
        drawn.add_line(series, points);
        drawn.add_name(series, page_text("rock {chosen_rock}: {chosen_why}",
                                         {{"chosen_rock", std::to_string(chosen[i].path->rock)},
                                          {"chosen_why", chosen[i].why}}));
    }
    if (energy_marks) {
        for (const double limit_kj : intensity_limits_kj) {
            if (limit_kj < highest && limit_kj > 0.1 * highest) {  // else it covers the lines
                drawn.add_label(0.0, limit_kj,
                                page_text("{limit_kj} kJ", {{"limit_kj", tick_text(limit_kj)}}));
            }
        }
    }
    return drawn.figure(caption);
}

}  // namespace

std::optional<PageFields> single_paths(const RunResults& results) {
    const bool are_named = !results.scenario.output.path_rocks.empty();
    std::string charts;
    for (const Cover cover : covers_of(results)) {
        const std::vector<ChosenPath> chosen = are_named ? named(results, cover) : choose(results, cover);
        if (chosen.empty()) {
            continue;
        }
        charts += chart(
            chosen, join_with_commas({page_text("Energy along paths"), title_of(cover)}),
            page_text("Kinetic energy, kJ"),
            [](const rockfall::PathPoint& point) { return static_cast<double>(point.energy_j) / 1000.0; },
            true, page_text("Drops are contacts with the ground and hits on trees, logs and nets."));
        charts += chart(
            chosen, join_with_commas({page_text("Height along paths"), title_of(cover)}),
            page_text("Height above ground, m"),
            [](const rockfall::PathPoint& point) { return static_cast<double>(point.height_m); }, false,
            page_text("Underside of the rock, vertically above the ground."));
    }
    return charts.empty() ? std::nullopt
                          : std::optional{PageFields{{"named", are_named}, {"charts", charts}}};
}

}  // namespace coupling::report
