#include "coupling/assessments/calibrate/sites/observation_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/calibrate/model/jumps.hpp"
#include "coupling/assessments/calibrate/model/observations.hpp"
#include "coupling/inputs/tables/words.hpp"

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
        outside += window.empty() || lies_within(window, stop.end_m) ? 0U : 1U;
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

std::string first_line(std::span<const std::size_t> lines, const char* advice) {
    return lines.empty() ? "" : joined("the first one in line ", std::to_string(lines.front()), "; ", advice);
}

/// Of the stems in these lines those on the ground of a dam or a ditch, where trees are left out.
std::size_t stems_on_works(const Site& site, std::span<const std::size_t> lines) {
    std::vector<rockfall::Roof> areas;
    for (const WorkRecord& work : site.works) {
        if (is_of_earth(work.kind)) {
            areas.push_back({work.outline_m, 0.0});
        }
    }
    return static_cast<std::size_t>(std::count_if(
        site.observed_events.trees.begin(), site.observed_events.trees.end(), [&](const ObservedTree& tree) {
            return std::find(lines.begin(), lines.end(), tree.line) != lines.end() &&
                   std::any_of(areas.begin(), areas.end(), [&](const rockfall::Roof& area) {
                       return is_below(area, tree.at_m - site.origin_m());
                   });
        }));
}

void check_trees(const Scenario& scenario, const Site& site, config::Warnings& warnings) {
    const std::string file = scenario.shown(scenario.observed.trees);
    if (site.observed_events.rocks > 0 && !site.observed_events.passages.empty()) {
        config::fail(config::ExitCode::settings, scenario.options->place_of("observed.rocks"),
                     "one number of rocks for passages and for wounds of searched stems",
                     "0: rocks of one event pass a line, but wounds are those of decades",
                     "or fit to one of the two files at a time");
    }
    if (site.trees.empty()) {
        config::fail(config::ExitCode::settings, scenario.options->place_of("observed.trees"),
                     "searched stems without stems", "trees.file: the stems of the model");
    }
    const SurveyedTrees trees{site, 0.0};
    const std::size_t all = site.observed_events.trees.size();
    if (!trees.repeated().empty()) {
        config::fail(config::ExitCode::data, {file, trees.repeated().front()},
                     "the stem of an earlier row: both are within 1 m of it", "each stem once",
                     "delete one of the rows, or add the stem to trees.file");
    }
    const std::size_t on_works = stems_on_works(site, trees.without_stem());
    if (on_works > 0) {
        warnings.add(
            joined(file, ": ", counted(on_works, "searched stem"),
                   " where dams and ditches are (works.file): not compared, as the model has no tree there"));
    }
    judge_impossible(trees.without_stem().size() - on_works, all, file,
                     "stems where trees.file has none within 1 m",
                     first_line(trees.without_stem(), "give the places of trees.file"), warnings);
    judge_impossible(trees.of_other_size().size(), all, file, "stems of another diameter than in trees.file",
                     first_line(trees.of_other_size(), "compare the places of both files"), warnings);
    if (site.observed_events.rocks > 0 && !can_count_scars(site, scenario.calibrate)) {
        warnings.add(joined(file, ": the number of scars is not compared, as observed.rocks is ",
                            std::to_string(site.observed_events.rocks), "; set calibrate.rocks to as many"));
    }
    warn_of_few(trees.scars(), file, "scar", warnings);
}

void check_outline(const Scenario& scenario, const Site& site, config::Warnings& warnings) {
    const std::string file = scenario.shown(scenario.observed.outline);
    std::size_t corners = 0;
    std::size_t outside = 0;
    for (const config::Shape& polygon : site.observed_events.outline) {
        for (const std::vector<config::Point2>& ring : polygon.parts) {
            for (const config::Point2& corner : ring) {
                const Eigen::Vector2d place_m = Eigen::Vector2d{corner.x_m, corner.y_m} - site.origin_m();
                ++corners;
                outside += site.slope.terrain.height_m(place_m.x(), place_m.y()) ? 0U : 1U;
            }
        }
    }
    judge_impossible(outside, corners, file, "corners off the terrain",
                     "take a larger terrain: rocks that leave it are not held against the outline", warnings);
    if (!site.observed_stops.empty()) {
        warnings.add(joined(file,
                            ": stops of the same blocks are given, too; leave one of the two out, or "
                            "they count twice"));
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
    if (!site.observed_events.trees.empty()) {
        check_trees(scenario, site, warnings);
    }
    if (!site.observed_events.outline.empty()) {
        check_outline(scenario, site, warnings);
    }
    if (const std::size_t jumps = jumps_along(site.observed_events.impacts).size(); jumps > 0) {
        warn_of_few(jumps, scenario.shown(scenario.observed.impacts), "jump", warnings);
    }
    if (!site.observed_events.passages.empty()) {
        warn_of_few(site.observed_events.passages.size(), scenario.shown(scenario.observed.passages),
                    "passage", warnings);
    }
}

}  // namespace coupling::calibrate
