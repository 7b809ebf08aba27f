#include "coupling/assessments/calibrate/observation_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// So many of a kind tell roughly what widths allow already.
constexpr std::size_t few_points = 20;
/// More than this share that cannot be is no slip.
constexpr double most_impossible = 0.2;

/// Warns of observations that cannot be, or refuses them where they are many.
void judge_impossible(std::size_t impossible, std::size_t all, const std::string& file,
                      const std::string& what, const std::string& advice, config::Warnings& warnings) {
    if (impossible == 0) {
        return;
    }
    const std::string found = joined(std::to_string(impossible), " of ", std::to_string(all), " ", what);
    if (static_cast<double>(impossible) > most_impossible * static_cast<double>(all)) {
        config::fail(config::ExitCode::data, {file}, found, "observations of these rocks", advice);
    }
    warnings.add(joined(file, ": ", found, "; ", advice));
}

void check_stops(const Scenario& scenario, const Site& site, config::Warnings& warnings) {
    double highest_m = -std::numeric_limits<double>::infinity();
    for (const rockfall::ReleaseSource& source : site.sources) {
        for (const Eigen::Vector2d& end_m : {source.first_m, source.last_m}) {
            if (const auto height_m = site.slope.terrain.height_m(end_m.x(), end_m.y())) {
                highest_m = std::max(highest_m, *height_m);
            }
        }
    }
    std::size_t above = 0;
    std::size_t outside = 0;
    for (const ObservedStop& stop : site.observed_stops) {
        const Eigen::Vector2d place_m = stop.end_m - site.origin_m();
        const auto height_m = site.slope.terrain.height_m(place_m.x(), place_m.y());
        above += height_m && *height_m > highest_m ? 1U : 0U;
        const auto& window = site.observed_events.window;
        outside += !window.empty() &&
                           std::none_of(
                               window.begin(), window.end(),
                               [&](const config::Shape& polygon) {
                                   return config::point_in_polygon(polygon, {stop.end_m.x(), stop.end_m.y()});
                               })
                       ? 1U
                       : 0U;
    }
    const std::string file = scenario.shown(scenario.observed.stops);
    judge_impossible(above, site.observed_stops.size(), file, "stops above all sources",
                     "give the sources that they came from, or take the stops out", warnings);
    judge_impossible(outside, site.observed_stops.size(), file, "stops outside of calibrate.window",
                     "the window is where stops were looked for: widen it, or take the stops out", warnings);
}

void check_scars(const Scenario& scenario, const Site& site, config::Warnings& warnings) {
    const std::string file = scenario.shown(scenario.observed.scars);
    if (site.trees.empty()) {
        config::fail(config::ExitCode::settings, scenario.options->place_of("observed.scars"),
                     "scars without stems", "trees.file: the stems that were hit");
    }
    double tallest_m = 0.0;
    for (const TreeRecord& tree : site.trees) {
        tallest_m = std::max(tallest_m, tree.stem.height_m);
    }
    const auto above = static_cast<std::size_t>(
        std::count_if(site.observed_events.scars.begin(), site.observed_events.scars.end(),
                      [&](const ObservedScar& scar) { return scar.height_m > tallest_m; }));
    judge_impossible(above, site.observed_events.scars.size(), file, "scars higher than the tallest tree",
                     "heights are metres above the ground", warnings);
}

void warn_of_few(std::size_t count, const std::string& file, const char* what, config::Warnings& warnings) {
    if (count < few_points) {
        warnings.add(joined(file, ": ", counted(count, what),
                            "; with fewer than 20 most parameters stay about as wide as before"));
    }
}

}  // namespace

void check_observations(const Scenario& scenario, const Site& site, config::Warnings& warnings) {
    if (site.rocks() == 0) {
        config::fail(config::ExitCode::settings, {scenario.file.string()}, "no rocks", "a release");
    }
    if (!site.observed_stops.empty()) {
        check_stops(scenario, site, warnings);
        warn_of_few(site.observed_stops.size(), scenario.shown(scenario.observed.stops), "stop", warnings);
    }
    if (!site.observed_events.scars.empty()) {
        check_scars(scenario, site, warnings);
        warn_of_few(site.observed_events.scars.size(), scenario.shown(scenario.observed.scars), "scar",
                    warnings);
    }
    if (!site.observed_events.passages.empty()) {
        warn_of_few(site.observed_events.passages.size(), scenario.shown(scenario.observed.passages),
                    "passage", warnings);
    }
}

}  // namespace coupling::calibrate
