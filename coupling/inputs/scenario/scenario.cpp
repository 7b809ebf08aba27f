#include "coupling/inputs/scenario/scenario.hpp"

#include <sstream>
#include <utility>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/scenario/ground_changes.hpp"
#include "coupling/inputs/scenario/profile_settings.hpp"
#include "coupling/inputs/scenario/scenario_checks.hpp"
#include "coupling/inputs/scenario/start_settings.hpp"

namespace coupling {

namespace {

constexpr double largest_diameter_m = 20.0;

void declare_run(config::Options& options, Scenario& s) {
    options.count("run.seed", s.seed,
                  {.low = 0.0,
                   .high = 9007199254740992.0,
                   .meaning = "key of all random numbers; the same seed gives the same results",
                   .source = "choice"});
    options.count("run.years", s.years,
                  {.unit = "yr",
                   .low = 0.0,
                   .high = 1000.0,
                   .meaning = "years to simulate; 0 assesses the trees as they stand",
                   .source = "choice"});
    options.flag("run.strict_inputs", s.strict_inputs,
                 {.meaning = "treat warnings about the inputs as errors", .source = "choice"});
    options.count(
        "run.rocks_per_part", s.rocks_per_part,
        {.low = 1.0,
         .high = 4e9,
         .meaning = "rocks after which an assessment of today is saved, to go on from there after an "
                    "interruption; changes no result",
         .source = "choice"});
}

void declare_plane(config::Options& options, PlaneGround& plane) {
    options.number("terrain.plane_width_m", plane.width_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10'000.0,
                    .meaning = "instead of a map: a plane rectangle, so wide along x (a multiple of 10 m)"});
    options.number(
        "terrain.plane_length_m", plane.length_m,
        {.unit = "m", .low = 0.0, .high = 10'000.0, .meaning = "its length along y (a multiple of 10 m)"});
    options.number(
        "terrain.plane_elevation_m", plane.elevation_m,
        {.unit = "m", .low = -500.0, .high = 9000.0, .meaning = "its height above the sea, at its middle"});
    options.number("terrain.plane_slope_deg", plane.slope_deg,
                   {.unit = "deg", .low = 0.0, .high = 75.0, .meaning = "its slope"});
    options.number("terrain.plane_aspect_deg", plane.aspect_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 360.0,
                    .meaning = "where it faces, downhill; 0 is north, 90 east"});
}

void declare_terrain(config::Options& options, Scenario& s) {
    options.file("terrain.dem", s.dem,
                 {.meaning = "ground heights in m: GeoTIFF, or ESRI ASCII grid, plain or .gz"});
    options.file("terrain.points", s.points, {.meaning = "instead: text of x y z in m, one point a line"});
    options.file("terrain.mesh", s.mesh,
                 {.meaning = "instead: a mesh whose faces stay as they are (PLY, STL), contours (DXF, CSV)"});
    options.file("terrain.meshes", s.meshes,
                 {.meaning = "instead: CSV with file, surface: several meshes with a ground type each"});
    declare_plane(options, s.plane);
    options.choice(
        "terrain.mesh_up", s.mesh_up, {{"z", MeshUp::z}, {"y", MeshUp::y}},
        {.meaning = "which axis of the mesh points up; y: (x, y, z) becomes (x, -z, y)", .source = "choice"});
    options.choice("terrain.mesh_overhangs", s.mesh_overhangs,
                   {{"refuse", MeshOverhangs::refuse}, {"keep_upper", MeshOverhangs::keep_upper}},
                   {.meaning = "faces that lie over each other: refuse them, or keep the upper ones and list "
                               "the others in mesh_left_out.csv",
                    .source = "choice"});
    options.number("terrain.longest_edge_m", s.longest_edge_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10'000.0,
                    .meaning = "for points: longer triangle edges are no terrain; 0 keeps all",
                    .source = "choice"});
    options.file("terrain.surface", s.surface,
                 {.meaning = "ground types: grid of codes on the frame of the DEM"});
    options.file("terrain.surface_polygons", s.surface_polygons,
                 {.meaning = "instead: CSV with code, wkt (POLYGON); later rows lie on top"});
    options.file("terrain.surface_types", s.surface_types,
                 {.meaning = "CSV with code, label, r_n, r_t, p_stop; or code, name of a shipped type"});
    options.file("terrain.soils", s.soils,
                 {.meaning = "CSV of soils of your own, as `bannwald info pir3d_soils` shows them; for "
                             "models that use soils"});
    options.file("terrain.stopping", s.stopping,
                 {.meaning = "CSV with code, diameter_m, p_stop; without it p_stop is scaled by size"});
    options.text(
        "terrain.ground", s.ground,
        {.meaning = "shipped ground type (see `bannwald info surfaces`) where no grid or polygon says"});
    options.file(
        "terrain.slope_grounds", s.slope_grounds,
        {.meaning = "CSV with from_deg, surface: ground types by slope where no grid or polygon says"});
    options.file(
        "terrain.profile", s.profile,
        {.meaning = "instead of all maps: CSV with distance_m, height_m, surface; a run in two dimensions"});
}

void declare_profile(config::Options& options, Scenario& s) {
    options.number("profile.start_m", s.profile_start_m,
                   {.unit = "m",
                    .low = -1e5,
                    .high = 1e5,
                    .meaning = "distance along the profile of the release; without it the upper end"});
    options.numbers("profile.stations_m", s.profile_stations_m,
                    {.unit = "m",
                     .low = -1e5,
                     .high = 1e5,
                     .meaning = "distances at which passing rocks are counted, such as 240, 340"});
    options.file("profile.stations", s.profile_stations, {.meaning = "instead: CSV with name, distance_m"});
    options.number("profile.segment_m", s.profile_segment_m,
                   {.unit = "m",
                    .low = 0.5,
                    .high = 1000.0,
                    .meaning = "slope length of the segments by which jump lengths are listed",
                    .source = "Rammer et al. 2010, 2.4.2"});
}

void declare_release(config::Options& options, Scenario& s) {
    options.file("release.source", s.source,
                 {.meaning = "grid on the frame of the DEM: 0 no source, k > 0 release zone k"});
    options.file("release.source_shapes", s.source_shapes,
                 {.meaning = "instead: CSV with wkt (points, lines or polygons) and perhaps zone"});
    options.number(
        "release.steeper_than_deg", s.steeper_than_deg,
        {.unit = "deg",
         .low = 0.0,
         .high = 89.0,
         .meaning = "> 0: rocks break off from cells steeper than this only; without other sources "
                    "from all such cells (zone 1)"});
    options.count("release.rocks", s.rocks,
                  {.low = 0.0,
                   .high = 4e9,
                   .meaning = "rocks in all; 0: rocks_per_source for each source, on a profile 10 000",
                   .source = "choice"});
    options.count("release.rocks_per_source", s.rocks_per_source,
                  {.low = 0.0,
                   .high = 1e9,
                   .meaning = "rocks for each source cell, point or line piece, on average",
                   .source = "choice"});
    declare_density(options, "release", s.density_kgpm3);
    options.flag("release.random_place", s.random_place,
                 {.meaning = "rocks start anywhere in their source; no: at its centre", .source = "choice"});
}

void declare_diameter(config::Options& options, Scenario& s) {
    options.choice("release.diameter_kind", s.diameter_kind,
                   {{"fixed", DiameterKind::fixed},
                    {"classes", DiameterKind::classes},
                    {"uniform", DiameterKind::uniform},
                    {"lognormal", DiameterKind::lognormal}},
                   {.meaning = "which law rock sizes follow", .source = "choice"});
    options.number("release.diameter_m", s.diameter_m,
                   {.unit = "m",
                    .low = 0.01,
                    .high = largest_diameter_m,
                    .meaning = "diameter (fixed), or its mean (lognormal)",
                    .source = "choice"});
    options.number("release.diameter_deviation_m", s.diameter_deviation_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = largest_diameter_m,
                    .meaning = "standard deviation of the diameter (lognormal)"});
    options.number("release.diameter_low_m", s.diameter_low_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = largest_diameter_m,
                    .meaning = "smallest diameter (uniform, lognormal)"});
    options.number("release.diameter_high_m", s.diameter_high_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = largest_diameter_m,
                    .meaning = "largest diameter (uniform, lognormal)"});
    options.numbers("release.diameter_classes_m", s.diameter_classes_m,
                    {.unit = "m",
                     .low = 0.01,
                     .high = largest_diameter_m,
                     .meaning = "diameters (classes), such as 0.5, 1, 1.5"});
    options.numbers("release.diameter_shares", s.diameter_shares,
                    {.low = 0.0, .high = 1e9, .meaning = "how often each of them occurs, in any scale"});
}

void declare_starts(config::Options& options, Scenario& s) {
    declare_start(options, "release", {s.start_height_m, s.start_speed_mps, s.start_dip_deg});
    options.number("release.start_scatter_deg", s.start_scatter_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 180.0,
                    .meaning = "largest turn of the start away from the fall line",
                    .source = "choice"});
    options.number("release.fall_height_m", s.fall_height_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "> 0: dropped at rest from this height instead",
                    .source = "choice"});
}

void declare_nets(config::Options& options, NetSettings& nets) {
    options.file("nets.file", nets.file,
                 {.meaning = "CSV with name, height_m, capacity_kj or class, gap_m, wkt (LINESTRING)"});
    options.number("nets.wanted_share", nets.wanted_share,
                   {.low = 0.5,
                    .high = 0.9999,
                    .meaning = "share of the rocks that arrive at a net which it should be able to hold",
                    .source = "choice"});
    options.flag("nets.keep_paths", nets.keep_paths,
                 {.meaning = "net_paths.bin: paths of all rocks without nets, for `bannwald net try`",
                  .source = "choice"});
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
                               "around them; rasters keep them",
                    .source = "choice"});
    options.file(
        "hazard.matrix", hazard.matrix,
        {.meaning = "CSV of hazard levels, as `bannwald info hazard_matrix` shows it; none: that one"});
}

void declare_output(config::Options& options, Scenario& s) {
    options.number(
        "output.cell_size_m", s.cell_size_m,
        {.unit = "m",
         .low = 0.0,
         .high = 1000.0,
         .meaning = "cell size of the maps; 0: that of the DEM (points: their mean spacing, rounded up)",
         .source = "choice"});
    options.flag("output.percentiles", s.percentiles,
                 {.meaning = "maps of percentiles; they need most of the memory", .source = "choice"});
    options.flag("output.rock_table", s.rock_table, {.meaning = "table of every rock", .source = "choice"});
    options.flag("output.arrivals", s.arrival_table,
                 {.meaning = "arrivals.csv, a row for each rock that reaches a target, also in results.gpkg; "
                             "no: shares and distributions at the targets only",
                  .source = "choice"});
    options.flag("output.tree_hit_table", s.tree_hit_table,
                 {.meaning = "tables of every hit on a tree and on a log", .source = "choice"});
    options.flag(
        "output.impact_table", s.impact_table,
        {.meaning = "table of every ground impact of the rocks whose paths are kept", .source = "choice"});
    options.count(
        "output.repeats", s.repeats,
        {.low = 0.0,
         .high = 64.0,
         .meaning = "rocks are shared out among so many repeats, and a map says in which share of them a "
                    "cell is reached; 0: no such map",
         .source = "Cottaz et al. 2010: up to 30 repeats"});
    options.count("output.sample_paths", s.sample_paths,
                  {.low = 0.0,
                   .high = 1e6,
                   .meaning = "how many rocks keep their path for pictures",
                   .source = "choice"});
    options.whole_numbers(
        "output.path_rocks", s.path_rocks,
        {.low = 0.0,
         .high = 4e9,
         .meaning = "numbers of rocks (tables/rocks.csv) whose paths are kept and drawn too"});
    options.flag(
        "output.geopackage", s.gis.geopackage,
        {.meaning = "results.gpkg with layers and tables, results.qlr for QGIS", .source = "choice"});
    options.flag("output.geotiff", s.gis.geotiff,
                 {.meaning = "a GeoTIFF (.tif) beside each grid", .source = "choice"});
    options.flag("output.xlsx", s.gis.workbook,
                 {.meaning = "results.xlsx: a workbook with a sheet for each table", .source = "choice"});
    options.choice(
        "output.csv", s.gis.csv, {{"plain", CsvForm::plain}, {"excel", CsvForm::excel}},
        {.meaning = "form of the tables; plain: commas and decimal points; excel: semicolons, decimal "
                    "sign of the page's language, byte-order mark",
         .source = "choice"});
    options.flag("output.vtp", s.gis.vtp,
                 {.meaning = "sampled paths as trajectories.vtp for ParaView; assessment of today",
                  .source = "choice"});
}

}  // namespace

void declare(config::Options& options, Scenario& scenario) {
    declare_run(options, scenario);
    declare_terrain(options, scenario);
    GroundChanges::declare(options);
    declare_profile(options, scenario);
    options.file("trees.file", scenario.trees,
                 {.meaning = "CSV with tree_id, x_m, y_m, species, dbh_cm, height_m; none: bare slope only"});
    options.file(
        "trees.logs", scenario.logs,
        {.meaning = "CSV of lying logs: x1_m, y1_m, x2_m, y2_m, species, dbh_cm, clearance_m, strength"});
    options.flag("trees.swap_xy", scenario.swap_tree_axes,
                 {.meaning = "x_m and y_m of trees.file stand in each other's column", .source = "choice"});
    options.flag("trees.swap_logs_xy", scenario.swap_log_axes,
                 {.meaning = "x and y of trees.logs stand in each other's columns", .source = "choice"});
    declare_release(options, scenario);
    declare_diameter(options, scenario);
    declare_starts(options, scenario);
    declare_shapes(options, scenario.shapes);
    options.file("targets.file", scenario.targets,
                 {.meaning = "CSV with target_id, name, wkt: lines that rocks cross, areas they enter"});
    options.file("observed.stops", scenario.observed_stops,
                 {.meaning = "where rocks of an event came to rest, to compare: x_m, y_m or wkt; perhaps "
                             "zone, group, x_release_m, y_release_m"});
    options.file(
        "observed.passages", scenario.observed_passages,
        {.meaning = "rocks of an event seen at targets: target_id, and of speed_mps, height_m, energy_kj, "
                    "translational_kj what is known; perhaps group"});
    options.file("observed.impacts", scenario.observed_impacts,
                 {.meaning = "single impacts on the ground: of speed_in_mps, speed_out_mps, angle_in_deg, "
                             "angle_out_deg what is known; perhaps ground (code), group"});
    options.count(
        "observed.rocks", scenario.observed_rocks,
        {.low = 0.0,
         .high = 1e9,
         .meaning = "rocks that were released in the event, for the share that passed; 0: unknown"});
    declare_nets(options, scenario.nets);
    declare_hazard(options, scenario.hazard);
    declare_output(options, scenario);
    declare(options, scenario.report);
    options.text("rockfall.preset", scenario.preset,
                 {.meaning = "default, or a named set: strict, paper_rebound, paper_initial, unity_compat"});
    rockfall::declare(options, scenario.rockfall);
    declare(options, scenario.forest);
}

bool rocks_have_shapes(const Scenario& scenario) {
    const auto& used = rockfall::description_of(scenario.rockfall.fall.motion.model).shared_settings;
    return std::find(used.begin(), used.end(), "release.shape") != used.end();
}

namespace {

/// The shapes of [release]. Throws InputError with every fault.
void take_block_shapes(Scenario& scenario) {
    if (!rocks_have_shapes(scenario)) {
        return;
    }
    config::Problems problems;
    scenario.shape_law = shape_law(
        scenario.shapes,
        [&](const std::string& name) { return scenario.options->place_of("release." + name); },
        [&](const std::string& name) { return scenario.resolve(name); }, problems);
    problems.throw_if_any();
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
    name_inputs(*scenario);
    check(*scenario);
    if (const std::string& logo = scenario->report.logo; !logo.empty()) {
        const config::Place place = scenario->options->place_of("report.logo");
        const FileBytes picture = open_file(scenario->resolve(logo), place, "a PNG, JPEG or SVG file");
        scenario->report.picture = read_logo(picture.text(), {scenario->resolve(logo).string()});
    }
    if (!scenario->profile.empty()) {
        profile::turn_deviation_off(*scenario);
    }
    rockfall::take_over(scenario->rockfall, *scenario->options);
    take_block_shapes(*scenario);
    return scenario;
}

bool wants_hazard_map(const Scenario& scenario) {
    return scenario.years == 0 && !scenario.hazard.blocks.empty() &&
           scenario.hazard.return_period_years == 0.0;
}

bool has_rocks(const Scenario& scenario) {
    return scenario.years == 0 || scenario.forest.rockfall_every > 0;
}

rockfall::StartLaw start_law(const Scenario& scenario) {
    rockfall::StartLaw law;
    law.diameter = diameter_law(scenario);
    law.density_kgpm3 = scenario.density_kgpm3;
    law.height_m = scenario.start_height_m;
    law.speed_mps = scenario.start_speed_mps;
    law.dip = config::Angle::from_degrees(scenario.start_dip_deg);
    law.heading_scatter = config::Angle::from_degrees(scenario.start_scatter_deg);
    law.random_place = scenario.random_place;
    law.shape = scenario.shape_law;
    if (law.shape) {
        if (const auto own_m = law.shape->own_diameter_m()) {
            law.diameter = rockfall::DiameterLaw::fixed(*own_m);
        }
    }
    if (scenario.fall_height_m > 0.0) {
        law.height_m = scenario.fall_height_m;
        law.speed_mps = 0.0;
    }
    return law;
}

}  // namespace coupling
