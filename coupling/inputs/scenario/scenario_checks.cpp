#include "coupling/inputs/scenario/scenario_checks.hpp"

#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/profile_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

/// Adds problems at the line where a setting stands.
class SettingsChecker {
public:
    explicit SettingsChecker(const Scenario& scenario) : options_{*scenario.options} {}

    void refuse(const std::string& key, std::string found, std::string expected, std::string advice = "") {
        problems_.add(ExitCode::settings, options_.place_of(key), std::move(found), std::move(expected),
                      std::move(advice));
    }
    /// Exactly one of two files has to be named.
    void one_of(const std::string& first, const std::string& first_name, const std::string& second,
                const std::string& second_name) {
        if (first_name.empty() && second_name.empty()) {
            refuse(first, "neither " + first + " nor " + second, "one of them");
        }
        not_both(first, first_name, second, second_name);
    }
    void not_both(const std::string& first, const std::string& first_name, const std::string& second,
                  const std::string& second_name) {
        if (!first_name.empty() && !second_name.empty()) {
            refuse(second, second + " beside " + first, "only one of them");
        }
    }
    [[nodiscard]] bool was_set(const std::string& key) const { return options_.was_set(key); }
    [[nodiscard]] config::Problems& problems() { return problems_; }

private:
    const config::Options& options_;
    config::Problems problems_;
};

void check_extent(const Scenario& s, SettingsChecker& checker) {
    const std::vector<double>& extent_m = s.terrain.extent_m;
    if (extent_m.empty() || !s.terrain.profile.empty()) {
        return;
    }
    if (extent_m.size() != 4 || !(extent_m[0] < extent_m[2]) || !(extent_m[1] < extent_m[3])) {
        checker.refuse("terrain.extent_m", "terrain.extent_m that is no part of a map",
                       "west, south, east, north: four numbers, west below east and south below north");
    } else if (s.terrain.dem.empty()) {
        checker.refuse("terrain.extent_m", "terrain.extent_m without terrain.dem", "a grid of heights to cut",
                       "remove the line, or cut points and meshes in a GIS program");
    }
}

/// Its codes mean nothing without the table of ground types; a setting without effect is worse than none.
void check_stopping(const Scenario& s, SettingsChecker& checker) {
    if (!s.terrain.stopping.empty() && s.terrain.surface_types.empty()) {
        checker.refuse("terrain.stopping", "terrain.stopping without terrain.surface_types",
                       "a table of what its codes mean");
    }
    if (!s.terrain.soils.empty() && s.terrain.surface_types.empty()) {
        checker.refuse("terrain.soils", "terrain.soils without terrain.surface_types",
                       "a table whose column soil names them");
    }
}

void check_terrain(const Scenario& s, SettingsChecker& checker) {
    checker.not_both("terrain.surface", s.terrain.surface, "terrain.surface_polygons",
                     s.terrain.surface_polygons);
    const bool has_codes = !s.terrain.surface.empty() || !s.terrain.surface_polygons.empty();
    if (!has_codes && s.terrain.ground.empty() && !s.terrain.has_mesh() &&
        s.terrain.slope_grounds.empty()) {  // faces of a mesh may carry codes
        checker.refuse(
            "terrain.surface", "no ground types",
            "terrain.surface, terrain.surface_polygons or terrain.ground",
            "set terrain.ground for one ground type everywhere (`bannwald info surfaces` lists them)");
    }
    if (has_codes && s.terrain.surface_types.empty()) {
        checker.refuse("terrain.surface_types", "surface codes without terrain.surface_types",
                       "a table of what the codes mean");
    }
    if (!s.terrain.surface.empty() && s.terrain.dem.empty() && !s.terrain.points.empty()) {
        checker.refuse("terrain.surface", "a surface grid beside terrain.points",
                       "terrain.surface_polygons or terrain.ground: points have no grid to match");
    }
}

/// A plane is whole patches of forest, and the only ground.
void check_plane(const Scenario& s, SettingsChecker& checker) {
    for (const auto& [key, length_m] : {std::pair{"terrain.plane_width_m", s.terrain.plane.width_m},
                                        std::pair{"terrain.plane_length_m", s.terrain.plane.length_m}}) {
        if (checker.was_set(key) && (length_m < 30.0 || std::remainder(length_m, 10.0) != 0.0)) {
            checker.refuse(key, joined(key, " ", config::to_text(length_m)),
                           "30 m or more, a multiple of 10 m: patches of forest are 10 m wide");
        }
    }
    if ((s.terrain.plane.width_m > 0.0) != (s.terrain.plane.length_m > 0.0)) {
        checker.refuse(s.terrain.plane.width_m > 0.0 ? "terrain.plane_length_m" : "terrain.plane_width_m",
                       "one side of a plane", "terrain.plane_width_m and terrain.plane_length_m");
    }
    for (const auto& [key, name] :
         {std::pair{"terrain.dem", s.terrain.dem}, std::pair{"terrain.points", s.terrain.points},
          std::pair{"terrain.mesh", s.terrain.mesh}, std::pair{"terrain.meshes", s.terrain.meshes}}) {
        checker.not_both("terrain.plane_width_m", s.terrain.plane.is_given() ? "a plane" : "", key, name);
    }
    for (const char* key :
         {"terrain.plane_elevation_m", "terrain.plane_slope_deg", "terrain.plane_aspect_deg"}) {
        if (!s.terrain.plane.is_given() && s.terrain.profile.empty() && checker.was_set(key)) {
            checker.refuse(key, joined(key, " without terrain.plane_width_m"), "a plane, or no such setting");
        }
    }
}

void check_release(const Scenario& s, SettingsChecker& checker) {
    if (s.release.steeper_than_deg > 0.0) {
        checker.not_both("release.source", s.release.source, "release.source_shapes",
                         s.release.source_shapes);
    } else {
        checker.one_of("release.source", s.release.source, "release.source_shapes", s.release.source_shapes);
    }
    if (!s.release.source.empty() && s.terrain.dem.empty() && !s.terrain.points.empty()) {
        checker.refuse("release.source", "a source grid beside terrain.points",
                       "release.source_shapes: points have no grid to match");
    }
    if (s.release.rocks == 0 && s.release.rocks_per_source == 0) {
        checker.refuse("release.rocks_per_source", "no rocks: both rocks and rocks_per_source are 0",
                       "one of them above 0");
    }
}

/// The forest stands still while rocks fall, so the setting would have no effect.
void check_trees_over_years(const Scenario& s, SettingsChecker& checker) {
    if (s.run.years != 0 && s.rockfall.fall.tree.remove_broken) {
        checker.refuse("tree_impact.remove_broken",
                       "tree_impact.remove_broken beside run.years " + std::to_string(s.run.years),
                       "no: trees stand while the rocks of a year fall");
    }
}

/// Settings that would have no effect, or that the hazard map cannot do without.
void check_hazard(const Scenario& s, SettingsChecker& checker) {
    if (s.hazard.blocks.empty()) {
        for (const char* key : {"hazard.return_period_years", "hazard.rule", "hazard.energy",
                                "hazard.least_reach_percent", "hazard.smallest_zone_m2", "hazard.matrix"}) {
            if (s.options->was_set(key)) {
                checker.refuse(key, joined(key, " without hazard.blocks"),
                               "a table of rocks by return period and zone");
            }
        }
        return;
    }
    if (!s.terrain.profile.empty()) {
        checker.refuse("hazard.blocks", "hazard.blocks beside terrain.profile",
                       "no hazard map: a profile has no zones");
    }
    if (s.run.years != 0 && s.hazard.return_period_years == 0.0) {
        checker.refuse("hazard.blocks",
                       joined("hazard.blocks beside run.years ", std::to_string(s.run.years)),
                       "hazard.return_period_years: over years rocks of one return period fall");
    }
    if (s.output.percentiles || s.hazard.return_period_years != 0.0) {
        return;
    }
    const bool is_percentile = s.hazard.energy != HazardEnergy::mean && s.hazard.energy != HazardEnergy::max;
    if (is_percentile) {
        checker.refuse("output.percentiles", "output.percentiles no beside a percentile as hazard.energy",
                       "yes, or hazard.energy mean or max");
    }
}

/// How often rocks start: hazard.blocks says it of a hazard map, a setting of a run over years.
void check_rocks_of_risk(const Scenario& s, SettingsChecker& checker) {
    const double real = s.risk.rocks_per_year;
    if (s.run.years == 0) {
        if (s.hazard.blocks.empty()) {
            checker.refuse("risk.assess", "risk.assess without hazard.blocks and without run.years",
                           "hazard.blocks, a table of rocks by return period and zone, or run.years above 0 "
                           "with risk.rocks_per_year: risk is counted by the year");
        } else if (real > 0.0) {
            checker.refuse("risk.rocks_per_year", "risk.rocks_per_year without run.years above 0",
                           "no such setting: hazard.blocks says how often rocks start");
        }
        return;
    }
    if (s.forest.rockfall_every == 0) {
        checker.refuse("risk.assess", "risk.assess beside run.rockfall_every 0",
                       "rocks that fall: run.rockfall_every = 1");
    }
    const double by_feedback = s.forest.feedback ? s.forest.rocks_per_year : 0.0;
    if (real == 0.0 && by_feedback == 0.0) {
        checker.refuse(
            "risk.rocks_per_year", "risk.assess without risk.rocks_per_year",
            "how many rocks really start in a year on the whole slope: release.rocks only says how "
            "many are simulated");
    }
    if (real > 0.0 && by_feedback > 0.0 && real != by_feedback) {
        checker.refuse("risk.rocks_per_year",
                       joined("risk.rocks_per_year ", config::to_text(real),
                              " beside feedback.rocks_per_year ", config::to_text(by_feedback)),
                       "one number of rocks, or feedback.rocks_per_year alone");
    }
}

/// A risk needs how often rocks start, targets, and the energy of each rock that hits one.
void check_risk(const Scenario& s, SettingsChecker& checker) {
    check(s.risk, *s.options, checker.problems());
    if (!s.risk.assess) {
        return;
    }
    check_rocks_of_risk(s, checker);
    if (s.targets.file.empty()) {
        checker.refuse("risk.assess", "risk.assess without targets.file", "roads or houses that rocks hit");
    }
    if (!s.output.arrival_table && s.run.years == 0) {
        checker.refuse("output.arrivals", "output.arrivals no beside risk.assess",
                       "output.arrivals = yes: the energy of each rock that hits a target counts");
    }
}

/// Observed stops are held against rows of rocks.csv.
void check_observed(const Scenario& s, SettingsChecker& checker) {
    if (s.observed.stops.empty()) {
        return;
    }
    if (s.run.years != 0 || wants_hazard_map(s)) {
        checker.refuse("observed.stops",
                       joined("observed.stops beside ", s.run.years != 0 ? "run.years" : "hazard.blocks"),
                       "an assessment of today: the rocks of one event");
    }
    if (!s.output.rock_table) {
        checker.refuse("observed.stops", "observed.stops beside output.rock_table = no",
                       "output.rock_table = yes: its rows are compared");
    }
}

/// Passages are held against rows of arrivals.csv, impacts against falls of rocks alone.
void check_observed_events(const Scenario& s, SettingsChecker& checker) {
    for (const auto& [key, file] : {std::pair{"observed.passages", s.observed.passages},
                                    std::pair{"observed.impacts", s.observed.impacts}}) {
        if (!file.empty() && (s.run.years != 0 || wants_hazard_map(s))) {
            checker.refuse(key, joined(key, " beside ", s.run.years != 0 ? "run.years" : "hazard.blocks"),
                           "an assessment of today: the rocks of one event");
        }
    }
    if (!s.observed.passages.empty() && s.targets.file.empty()) {
        checker.refuse("observed.passages", "observed.passages without targets.file",
                       "the lines or areas at which rocks were seen");
    }
    if (!s.observed.passages.empty() && !s.output.arrival_table) {
        checker.refuse("observed.passages", "observed.passages beside output.arrivals = no",
                       "output.arrivals = yes: its rows are compared");
    }
    if (!s.observed.impacts.empty() && s.rockfall.fall.tree.remove_broken) {
        checker.refuse("observed.impacts", "observed.impacts beside tree_impact.remove_broken",
                       "one of them: a rock that falls alone meets trees that others broke");
    }
    if (s.observed.rocks > 0 && s.observed.passages.empty() && s.observed.trees.empty()) {
        checker.refuse("observed.rocks", "observed.rocks without observed.passages or observed.trees",
                       "rocks that were seen at targets, or stems that were searched for scars");
    }
}

/// Repeats are shares of the rocks of an assessment of today.
void check_repeats(const Scenario& s, SettingsChecker& checker) {
    if (s.output.repeats == 0) {
        return;
    }
    if (s.output.repeats == 1) {
        checker.refuse("output.repeats", "output.repeats 1", "0, or 2 to 64 repeats to compare");
    }
    if (s.run.years != 0 || !s.terrain.profile.empty() || wants_hazard_map(s)) {
        checker.refuse("output.repeats",
                       joined("output.repeats beside ", s.run.years != 0             ? "run.years"
                                                        : !s.terrain.profile.empty() ? "terrain.profile"
                                                                                     : "hazard.blocks"),
                       "an assessment of today on a map");
    }
    if (s.release.rocks == 0 && s.release.rocks_per_source < s.output.repeats) {
        checker.refuse("output.repeats",
                       joined("output.repeats ", std::to_string(s.output.repeats),
                              " with release.rocks_per_source ", std::to_string(s.release.rocks_per_source)),
                       "at least one rock of each source in every repeat",
                       "raise release.rocks_per_source: a repeat has a share of the rocks");
    }
}

/// The rocks of the table of impacts fall a second time.
void check_impact_table(const Scenario& s, SettingsChecker& checker) {
    if (!s.output.impact_table) {
        return;
    }
    if (s.run.years != 0 || !s.terrain.profile.empty()) {
        checker.refuse(
            "output.impact_table",
            joined("output.impact_table beside ", s.run.years != 0 ? "run.years" : "terrain.profile"),
            "an assessment of today on a map");
    }
    if (s.output.sample_paths == 0 && s.output.path_rocks.empty()) {
        checker.refuse("output.impact_table", "output.impact_table without paths",
                       "rocks whose impacts are wanted", "set output.sample_paths or output.path_rocks");
    }
    if (s.rockfall.fall.tree.remove_broken) {
        checker.refuse("output.impact_table", "output.impact_table beside tree_impact.remove_broken",
                       "one of them: a rock that falls alone meets trees that others broke");
    }
}

void check_range(const Scenario& s, SettingsChecker& checker) {
    if (!(s.release.diameter_low_m > 0.0)) {
        checker.refuse("release.diameter_low_m",
                       "release.diameter_low_m " + config::to_text(s.release.diameter_low_m),
                       "a diameter > 0 m");
    }
    if (!(s.release.diameter_high_m > s.release.diameter_low_m)) {
        checker.refuse("release.diameter_high_m",
                       "release.diameter_high_m " + config::to_text(s.release.diameter_high_m),
                       "more than release.diameter_low_m " + config::to_text(s.release.diameter_low_m));
    }
}

void check_classes(const Scenario& s, SettingsChecker& checker) {
    if (s.release.diameter_classes_m.empty()) {
        checker.refuse("release.diameter_classes_m", "no release.diameter_classes_m",
                       "at least one diameter for diameter_kind = classes");
    } else if (s.release.diameter_classes_m.size() != s.release.diameter_shares.size()) {
        checker.refuse("release.diameter_shares",
                       std::to_string(s.release.diameter_shares.size()) + " shares for " +
                           std::to_string(s.release.diameter_classes_m.size()) + " diameters",
                       "as many of both");
    } else if (!(std::accumulate(s.release.diameter_shares.begin(), s.release.diameter_shares.end(), 0.0) >
                 0.0)) {
        checker.refuse("release.diameter_shares", "shares that are all 0", "at least one above 0");
    }
}

void check_diameter(const Scenario& s, SettingsChecker& checker) {
    switch (s.release.diameter_kind) {
        case DiameterKind::fixed:
            break;
        case DiameterKind::classes:
            check_classes(s, checker);
            break;
        case DiameterKind::uniform:
            check_range(s, checker);
            break;
        case DiameterKind::lognormal:
            check_range(s, checker);
            if (!(s.release.diameter_deviation_m > 0.0)) {
                checker.refuse("release.diameter_deviation_m", "release.diameter_deviation_m 0",
                               "more than 0 m for diameter_kind = lognormal");
            }
            break;
    }
}

}  // namespace

void check(const Scenario& scenario) {
    SettingsChecker checker{scenario};
    if (scenario.run.years != 0 && !scenario.terrain.profile.empty()) {
        checker.refuse("run.years",
                       "run.years " + std::to_string(scenario.run.years) + " beside terrain.profile",
                       "0: no forest grows along a profile");
    }
    check(scenario.trees, *scenario.options, checker.problems());
    check(scenario.forest, scenario.run.years, !scenario.trees.source().empty(), *scenario.options,
          checker.problems());
    if (scenario.run.years != 0 && !scenario.trees.logs.empty()) {
        checker.refuse("trees.logs", "trees.logs beside run.years above 0",
                       "no list: the logs of a growing forest are its own");
    }
    if (!scenario.terrain.profile.empty() && !scenario.nets.file.empty()) {
        checker.refuse("nets.file", "nets.file beside terrain.profile", "no nets: they stand on maps alone");
    }
    checker.not_both("terrain.profile", scenario.terrain.profile, "works.file", scenario.works.file);
    if (scenario.nets.keep_paths && !scenario.works.file.empty()) {
        checker.refuse("nets.keep_paths", "nets.keep_paths beside works.file",
                       "one of them: stored paths are those of a slope without walls and galleries");
    }
    if (scenario.nets.keep_paths && (scenario.run.years != 0 || !scenario.terrain.profile.empty())) {
        checker.refuse(
            "nets.keep_paths",
            joined("nets.keep_paths beside ", scenario.run.years != 0 ? "run.years" : "terrain.profile"),
            "no paths: those of an assessment of today can be kept");
    }
    if (scenario.nets.keep_paths && scenario.rockfall.fall.tree.remove_broken) {
        checker.refuse("nets.keep_paths", "nets.keep_paths beside tree_impact.remove_broken",
                       "one of them: a rock that a net holds breaks no trees for the rocks after it");
    }
    check_hazard(scenario, checker);
    check(scenario.report, *scenario.options, checker.problems());
    check(scenario.design, *scenario.options, checker.problems());
    check_risk(scenario, checker);
    check_observed(scenario, checker);
    check_observed_events(scenario, checker);
    check_impact_table(scenario, checker);
    check_repeats(scenario, checker);
    for (const double rock : scenario.output.path_rocks) {
        if (rock != std::floor(rock)) {
            checker.refuse("output.path_rocks", joined("rock ", config::to_text(rock)), "whole numbers");
        }
    }
    if (!scenario.output.path_rocks.empty() && !scenario.terrain.profile.empty()) {
        checker.refuse("output.path_rocks", "output.path_rocks beside terrain.profile",
                       "output.sample_paths: a run along a profile draws a sample");
    }
    profile::check_settings(scenario, checker.problems());
    check_stopping(scenario, checker);
    check_plane(scenario, checker);
    check_extent(scenario, checker);
    if (scenario.terrain.profile.empty()) {
        if (!scenario.terrain.has_mesh() && !scenario.terrain.plane.is_given()) {
            checker.one_of("terrain.dem", scenario.terrain.dem, "terrain.points", scenario.terrain.points);
        }
        checker.not_both("terrain.dem", scenario.terrain.dem, "terrain.mesh", scenario.terrain.mesh);
        checker.not_both("terrain.points", scenario.terrain.points, "terrain.mesh", scenario.terrain.mesh);
        checker.not_both("terrain.dem", scenario.terrain.dem, "terrain.meshes", scenario.terrain.meshes);
        checker.not_both("terrain.points", scenario.terrain.points, "terrain.meshes",
                         scenario.terrain.meshes);
        checker.not_both("terrain.mesh", scenario.terrain.mesh, "terrain.meshes", scenario.terrain.meshes);
        for (const char* key : {"terrain.mesh_up", "terrain.mesh_overhangs"}) {
            if (!scenario.terrain.has_mesh() && scenario.options->was_set(key)) {
                checker.refuse(key, joined(key, " without terrain.mesh"), "a mesh, or no such setting");
            }
        }
    }
    if (scenario.terrain.profile.empty() && has_rocks(scenario)) {
        check_terrain(scenario, checker);
        check_release(scenario, checker);
        check_trees_over_years(scenario, checker);
    }
    check_diameter(scenario, checker);
    checker.problems().throw_if_any();
}

}  // namespace coupling
