#include "coupling/inputs/scenario/scenario.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/scenario/ground_changes.hpp"
#include "coupling/inputs/scenario/profile_checks.hpp"
#include "coupling/inputs/scenario/scenario_checks.hpp"
#include "coupling/inputs/scenario/start_settings.hpp"
#include "rockfall/motion/models.hpp"
#include "rockfall/motion/seam/presets.hpp"

namespace coupling {

namespace {

using config::joined;

void declare_run(config::Options& options, Scenario& s) {
    options.count("run.seed", s.run.seed,
                  {.low = 0.0,
                   .high = 9007199254740992.0,
                   .meaning = "key of all random numbers; the same seed gives the same results",
                   .source = "choice"});
    options.count("run.years", s.run.years,
                  {.unit = "yr",
                   .low = 0.0,
                   .high = 1000.0,
                   .meaning = "years to simulate; 0 assesses the trees as they stand",
                   .source = "choice"});
    options.flag("run.strict_inputs", s.run.strict_inputs,
                 {.meaning = "treat warnings about the inputs as errors", .source = "choice"});
    options.flag(
        "run.parameter_draws", s.run.parameter_draws,
        {.meaning = "what is not known of ground and trees is drawn for each stratum of rocks; an assessment "
                    "of today shows a second interval for it; no: the values of the tables for all rocks",
         .source = "choice",
         .presets = rockfall::published("no")});
    options.file("run.drawing", s.run.drawing,
                 {.meaning = "GeoPackage to draw in, as `bannwald init --draw` makes it: its layers that are "
                             "still empty count as not given"});
    options.file("run.parameters", s.run.parameters,
                 {.meaning = "CSV with parameter, width: changes the widths of `bannwald info "
                             "parameter_widths`; or posterior.csv of `bannwald calibrate`"});
    options.count(
        "run.rocks_per_part", s.run.rocks_per_part,
        {.low = 1.0,
         .high = 4e9,
         .meaning = "rocks after which an assessment of today is saved, to go on from there after an "
                    "interruption; changes no result",
         .source = "choice"});
}

void declare_profile(config::Options& options, Scenario& s) {
    options.number("profile.start_m", s.profile.start_m,
                   {.unit = "m",
                    .low = -1e5,
                    .high = 1e5,
                    .meaning = "distance along the profile of the release; without it the upper end"});
    options.numbers("profile.stations_m", s.profile.stations_m,
                    {.unit = "m",
                     .low = -1e5,
                     .high = 1e5,
                     .meaning = "distances at which passing rocks are counted, such as 240, 340"});
    options.file("profile.stations", s.profile.stations, {.meaning = "instead: CSV with name, distance_m"});
    options.number("profile.segment_m", s.profile.segment_m,
                   {.unit = "m",
                    .low = 0.5,
                    .high = 1000.0,
                    .meaning = "slope length of the segments by which jump lengths are listed",
                    .source = "Rammer et al. 2010, 2.4.2"});
}

void declare_nets(config::Options& options, NetSettings& nets) {
    options.file("nets.file", nets.file,
                 {.meaning = "CSV with name, height_m, capacity_kj or class, gap_m, wkt (LINESTRING)"});
    options.number("nets.wanted_share", nets.wanted_share,
                   {.low = 0.5,
                    .high = 0.9999,
                    .meaning = "share of the energy along a line, and of its rocks, that nets of `net place` "
                               "should keep from it",
                    .source = "choice",
                    .needs = {{"run.years", {"0"}}}});
    options.flag("nets.keep_paths", nets.keep_paths,
                 {.meaning = "net_paths.bin: paths of all rocks without nets, for `bannwald net try`",
                  .source = "choice"});
}

void declare_works(config::Options& options, WorkSettings& works) {
    options.file("works.file", works.file,
                 {.meaning = "dams, ditches, walls and galleries: name, kind, height_m, width_m, "
                             "uphill_face_deg, downhill_face_deg, capacity_kj, surface, investment, "
                             "life_years, maintenance_percent, wkt"});
}

void declare_hazard(config::Options& options, HazardSettings& hazard) {
    options.file("hazard.blocks", hazard.blocks,
                 {.meaning = "CSV with return_period_years, zone (none: all others), diameter_m or mass_t or "
                             "volume_m3: a hazard map"});
    options.number("hazard.return_period_years", hazard.return_period_years,
                   {.unit = "yr",
                    .low = 0.0,
                    .high = 1e6,
                    .meaning = "only the rocks of this return period; 0: all, and the hazard map",
                    .source = "choice"});
    options.choice("hazard.rule", hazard.rule,
                   {{"cadanav", HazardRule::cadanav},
                    {"arrival", HazardRule::arrival},
                    {"release", HazardRule::release}},
                   {.meaning = "what a level is taken from; cadanav: how often rocks of each class of "
                               "energy arrive; arrival, release: hazard.energy with the return period of "
                               "the arrival or of the release",
                    .source = "Hantz et al. 2021"});
    options.choice(
        "hazard.energy", hazard.energy,
        {{"mean", HazardEnergy::mean},
         {"50", HazardEnergy::p50},
         {"90", HazardEnergy::p90},
         {"95", HazardEnergy::p95},
         {"98", HazardEnergy::p98},
         {"99", HazardEnergy::p99},
         {"max", HazardEnergy::max}},
        {.meaning = "percentile of the rocks' energies in a cell that is its intensity", .source = "choice"});
    options.number("hazard.least_reach_percent", hazard.least_reach_percent,
                   {.unit = "%",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "cells with a smaller reach probability are left out of the hazard map",
                    .source = "choice"});
    options.number("hazard.smallest_zone_m2", hazard.smallest_zone_m2,
                   {.unit = "m2",
                    .low = 0.0,
                    .high = 1e6,
                    .meaning = "zones of the hazard map (layer hazard_zones) below this area take the level "
                               "around them if it is higher; rasters keep them",
                    .source = "choice"});
    options.number(
        "hazard.reference_width_m", hazard.reference_width_m,
        {.unit = "m",
         .low = 0.0,
         .high = 1000.0,
         .meaning = "rules cadanav and arrival: how often a cell is passed counts all rocks that come "
                    "into a square at least so wide around it, each once; 0: those in the cell alone",
         .source = "choice",
         .needs = {{"hazard.rule", {"cadanav", "arrival"}}}});
    options.file(
        "hazard.matrix", hazard.matrix,
        {.meaning = "CSV of hazard levels, as `bannwald info hazard_matrix` shows it; none: that one"});
}

/// Sections that only a run over years reads, and settings of single motion models.
void declare_needs_of_runs_and_models(config::Options& options) {
    const std::set<std::string> of_years{"stands",      "soil",    "climate", "forest",
                                         "disturbance", "regimes", "feedback"};
    for (const config::ParameterRow& row : options.rows()) {
        if (of_years.contains(row.key.substr(0, row.key.find('.')))) {
            options.need(row.key, {"run.years"});
        }
        std::vector<std::string> users;
        for (const rockfall::MotionModel model : rockfall::all_models()) {
            const rockfall::ModelDescription& description = rockfall::description_of(model);
            const auto& shared = description.shared_settings;
            if (row.key.starts_with(joined(description.name, ".")) ||
                std::find(shared.begin(), shared.end(), row.key) != shared.end()) {
                users.emplace_back(description.name);
            }
        }
        if (!users.empty()) {
            options.need(row.key, {"rockfall.motion", std::move(users)});
        }
    }
}

void declare_calibrate(config::Options& options, CalibrateSettings& s) {
    options.count("calibrate.sets", s.sets,
                  {.low = 50.0,
                   .high = 10'000.0,
                   .meaning = "parameter sets of the sample that `bannwald calibrate` keeps",
                   .source = "choice"});
    options.count("calibrate.first_sets", s.first_sets,
                  {.low = 64.0,
                   .high = 65'536.0,
                   .meaning = "parameter sets of its first round, spread evenly over what the widths allow",
                   .source = "choice"});
    options.count("calibrate.most_sets", s.most_sets,
                  {.low = 64.0,
                   .high = 10'000'000.0,
                   .meaning = "parameter sets that it tries in all: the search ends there at the latest",
                   .source = "choice"});
    options.count(
        "calibrate.rocks", s.rocks,
        {.low = 50.0, .high = 100'000.0, .meaning = "rocks of each parameter set", .source = "choice"});
    options.choice(
        "calibrate.emulator", s.emulator,
        {{"auto", Emulates::by_model}, {"yes", Emulates::yes}, {"no", Emulates::no}},
        {.meaning = "do not simulate parameter sets that polynomials, fitted to those before, rule "
                    "out; auto: where rocks have a shape of their own and take long",
         .source = "choice; Craig et al. 1997"});
    options.number(
        "calibrate.hold_out_percent", s.hold_out_percent,
        {.unit = "%",
         .low = 5.0,
         .high = 80.0,
         .meaning = "share of each kind of observation that is not fitted to: the result is judged "
                    "by it",
         .source = "choice"});
    options.text("calibrate.hold_out_group", s.hold_out_group,
                 {.meaning = "instead: the group (column group) that is not fitted to"});
    options.file("calibrate.sites", s.sites,
                 {.meaning = "scenarios of further sites, with observations of their own: what describes "
                             "grounds of the same name, trees and motion is fitted to all sites together"});
    options.flag("calibrate.transfer", s.transfer,
                 {.meaning = "with further sites: fit to all of them but one, too, for each of them, and say "
                             "how far what was observed there is from what the others predict",
                  .source = "choice",
                  .needs = {{"calibrate.sites"}}});
    options.file(
        "calibrate.window", s.window,
        {.meaning = "CSV or layer of polygons (wkt): where stops were looked for; none: everywhere"});
    options.number("calibrate.least_diameter_m", s.least_diameter_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "diameter below which rocks were not looked for",
                    .source = "choice"});
    options.number("calibrate.least_scar_dbh_cm", s.least_scar_dbh_cm,
                   {.unit = "cm",
                    .low = 0.0,
                    .high = 300.0,
                    .meaning = "DBH below which stems were not searched for scars",
                    .source = "choice"});
    options.number("calibrate.outline_percent", s.outline_percent,
                   {.unit = "%",
                    .low = 50.0,
                    .high = 99.0,
                    .meaning = "share of the blocks that lie within observed.outline",
                    .source = "choice"});
    options.count(
        "calibrate.outline_blocks", s.outline_blocks,
        {.low = 8.0,
         .high = 10'000.0,
         .meaning = "number of blocks around which observed.outline was drawn: a larger one gives it "
                    "more weight",
         .source = "choice"});
    options.number("calibrate.least_jump_m", s.least_jump_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "jumps below this length do not count; 0: below the shortest observed one",
                    .source = "choice"});
}

}  // namespace

void declare(config::Options& options, Scenario& scenario) {
    declare_run(options, scenario);
    declare(options, scenario.terrain);
    GroundChanges::declare(options);
    declare_profile(options, scenario);
    declare(options, scenario.trees);
    declare(options, scenario.release);
    options.file("targets.file", scenario.targets.file,
                 {.meaning = "CSV with target_id, name, wkt: lines that rocks cross, areas they enter, or "
                             "that their side touches"});
    options.file("observed.stops", scenario.observed.stops,
                 {.meaning = "where rocks of an event came to rest, to compare: x_m, y_m or wkt; perhaps "
                             "zone, group, x_release_m, y_release_m"});
    options.file(
        "observed.passages", scenario.observed.passages,
        {.meaning = "rocks of an event seen at targets: target_id, and of speed_mps, height_m, energy_kj, "
                    "translational_kj what is known; perhaps group"});
    options.file(
        "observed.impacts", scenario.observed.impacts,
        {.meaning = "single impacts on the ground: of speed_in_mps, speed_out_mps, angle_in_deg, "
                    "angle_out_deg what is known; or x_m, y_m, track; perhaps ground (code), group"});
    options.file(
        "observed.scars", scenario.observed.scars,
        {.meaning = "wounds of an event on stems, for `bannwald calibrate`: height_m; perhaps x_m, y_m, "
                    "dbh_cm, group"});
    options.file("observed.trees", scenario.observed.trees,
                 {.meaning = "all stems that were searched for wounds, for `bannwald calibrate`: x_m, y_m, "
                             "scars (their number, also 0); perhaps dbh_cm"});
    options.file("observed.outline", scenario.observed.outline,
                 {.meaning = "polygons (wkt) around the blocks of an event, for `bannwald calibrate`"});
    options.count(
        "observed.rocks", scenario.observed.rocks,
        {.low = 0.0,
         .high = 1e9,
         .meaning =
             "rocks that were released in the event, for the share that passed and the number of wounds; "
             "0: unknown"});
    declare_calibrate(options, scenario.calibrate);
    declare_nets(options, scenario.nets);
    declare_works(options, scenario.works);
    declare(options, scenario.design);
    declare_hazard(options, scenario.hazard);
    declare(options, scenario.risk);
    declare(options, scenario.output);
    declare(options, scenario.report);
    options.text("rockfall.preset", scenario.preset,
                 {.meaning = "default, or a named set: strict, paper_rebound, paper_initial, unity_compat"});
    rockfall::declare(options, scenario.rockfall);
    declare(options, scenario.forest);
    declare_needs_of_runs_and_models(options);
}

namespace {

/// Layers of run.drawing that are still empty count as not given; then the steep cells are the sources.
void leave_out_undrawn(Scenario& s) {
    if (s.run.drawing.empty()) {
        return;
    }
    const auto setting = [](const char* key, std::string& value) {
        return LayerSetting{key, value, list_of_files(value)};
    };
    const std::array layers{setting("terrain.surface_polygons", s.terrain.surface_polygons),
                            setting("trees.file", s.trees.file),
                            setting("trees.logs", s.trees.logs),
                            setting("release.source_shapes", s.release.source_shapes),
                            setting("targets.file", s.targets.file),
                            setting("nets.file", s.nets.file),
                            setting("works.file", s.works.file),
                            setting("stands.polygons", s.forest.stand_polygons),
                            setting("stands.records", s.forest.stand_records)};
    s.undrawn = take_out_undrawn({s.run.drawing, s.options->place_of("run.drawing"),
                                  [&](const std::string& name) { return s.resolve(name); }},
                                 layers);
    const bool no_sources = std::any_of(s.undrawn.begin(), s.undrawn.end(), [](const Undrawn& undrawn) {
        return undrawn.key == "release.source_shapes" && undrawn.is_all;
    });
    if (no_sources && s.release.undrawn_steeper_than_deg > 0.0) {
        s.release.steeper_than_deg = s.release.undrawn_steeper_than_deg;
    }
}

/// The shapes of [release]. Throws InputError with every fault.
void take_block_shapes(Scenario& scenario) {
    constexpr std::array says_shapes{"release.shape", "release.sides", "release.sides_m"};
    const bool blocks = rocks_have_shapes(scenario.rockfall);
    if (!blocks && std::none_of(says_shapes.begin(), says_shapes.end(),
                                [&](const char* key) { return scenario.options->was_set(key); })) {
        return;
    }
    config::Problems problems;
    const auto shapes = shape_law(
        scenario.release.shapes,
        [&](const std::string& name) { return scenario.options->place_of("release." + name); },
        [&](const std::string& name) { return scenario.resolve(name); }, problems);
    problems.throw_if_any();
    scenario.release.shape_elongation =
        shapes ? rockfall::ElongationLaw{*shapes} : rockfall::ElongationLaw{1.0, 0.0};
    scenario.release.shape_law = blocks ? shapes : nullptr;
}

}  // namespace

std::unique_ptr<Scenario> read_scenario(const std::filesystem::path& file,
                                        const std::vector<std::string>& overrides,
                                        const std::filesystem::path& inputs_within) {
    auto scenario = std::make_unique<Scenario>();
    scenario->file = file;
    scenario->inputs_within = inputs_within;
    scenario->options = std::make_shared<config::Options>();
    declare(*scenario->options, *scenario);

    const FileBytes bytes = open_file(file, {file.string()}, "a scenario file");
    std::istringstream in{std::string{bytes.text()}};
    scenario->options->read(in, file.string(), overrides, "rockfall.preset");
    leave_out_undrawn(*scenario);
    name_inputs(*scenario);
    check(*scenario);
    if (const std::string& logo = scenario->report.logo; !logo.empty()) {
        const config::Place place = scenario->options->place_of("report.logo");
        const FileBytes picture = open_file(scenario->resolve(logo), place, "a PNG, JPEG or SVG file");
        scenario->report.picture = read_logo(picture.text(), {scenario->resolve(logo).string()});
    }
    if (!scenario->terrain.profile.empty()) {
        profile::turn_deviation_off(*scenario);
    }
    rockfall::take_over(scenario->rockfall, *scenario->options);
    take_block_shapes(*scenario);
    return scenario;
}

bool wants_hazard_map(const Scenario& scenario) {
    return scenario.run.years == 0 && !scenario.hazard.blocks.empty() &&
           scenario.hazard.return_period_years == 0.0;
}

bool has_rocks(const Scenario& scenario) {
    return scenario.run.years == 0 || scenario.forest.rockfall_every > 0;
}

}  // namespace coupling
