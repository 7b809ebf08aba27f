#include "coupling/assessments/today/figures/static_layouts.hpp"

#include "config/text/joined.hpp"
#include "coupling/assessments/nets/figures/net_layouts.hpp"
#include "coupling/assessments/today/figures/ground_columns.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr const char* simulated = "simulated";
constexpr const char* counted = "counted over the simulated rocks";

Column rock_column() {
    return {"rock", "-", "number of the rock; the same rock falls with forest and over the bare slope",
            simulated};
}

/// Absolute easting, northing and height.
std::vector<Column> place_columns(const std::string& infix, const std::string& of_what) {
    return {{"x" + infix + "_m", "m", "easting of " + of_what, simulated},
            {"y" + infix + "_m", "m", "northing of " + of_what, simulated},
            {"z" + infix + "_m", "m", "height above sea of " + of_what, simulated}};
}

TableLayout targets() {
    const std::vector<Column> kind{
        {"kind", "text", "line: a rock arrives when it crosses it; area: when it enters it",
         "input targets.file"},
        cover_column()};
    return {"targets.csv", "a target on one slope", together(target_columns(), kind, arrival_columns())};
}

TableLayout protection() {
    const std::vector<Column> more{
        {"rocks_for_half_interval", "-",
         "rocks that would halve the interval of the protection effect; empty where it is one-sided",
         "widths shrink with the square root of the number of rocks"}};
    return {"protection.csv", "a target", together(target_columns(), protection_columns(), more)};
}

TableLayout target_distributions() {
    return {"target_distributions.csv",
            "a filled bin of a quantity at a target on one slope",
            {target_columns().front(),
             cover_column(),
             {"quantity", "text", "energy, speed or height at the first arrival", simulated},
             {"unit", "text", "unit of the bin: kJ, m/s or m", "definition"},
             {"bin_low", "as the row says", "lower end of the bin", "128 bins to a doubling"},
             {"bin_high", "as the row says", "upper end of the bin", "128 bins to a doubling"},
             {"rocks", "-", "rocks that arrived in this bin", counted}}};
}

TableLayout runs() {
    return {"runs.csv", "a slope", together(std::vector<Column>{cover_column()}, slope_columns())};
}

TableLayout run_out() {
    return {"run_out.csv",
            "a bin of run-out on one slope",
            {cover_column(),
             {"run_out_low_m", "m", "lower end of the bin of the plan distance from release to end",
              "bins of 10 m"},
             {"run_out_high_m", "m", "upper end of the bin; empty: everything further", "bins of 10 m"},
             {"rocks", "-", "rocks that stopped on the terrain in this bin", counted},
             {"not_stopped", "-",
              "rocks that left the terrain or were given up in this bin: their run-out is at least so long",
              counted}}};
}

TableLayout tree_hits_per_rock() {
    return {"tree_hits_per_rock.csv",
            "a number of tree hits",
            {{"tree_hits", "-", "trees hit by one rock", simulated},
             {"or_more", "text", "yes: the row takes all higher numbers too", "definition"},
             {"rocks", "-", "rocks with so many hits, on the slope with forest", counted}}};
}

TableLayout stems() {
    return {
        "stems.csv",
        "a tree",
        {{"tree_id", "text", "name of the tree", "input trees.file"},
         {"x_m", "m", "easting of the stem", "input trees.file"},
         {"y_m", "m", "northing of the stem", "input trees.file"},
         {"species", "text", "species as the list of trees names it", "input trees.file"},
         {"dbh_cm", "cm", "diameter at breast height", "input trees.file"},
         {"height_m", "m", "height of the tree", "input trees.file, or estimated where the list has none"},
         {"hits", "-", "hits by rocks", counted},
         {"broken", "-", "hits with more energy than the tree can take", counted},
         {"energy_kj", "kJ", "energy it took from all rocks", simulated}}};
}

TableLayout logs() {
    constexpr const char* from_list = "input trees.logs";
    return {"logs.csv",
            "a lying log",
            {{"log_id", "text", "name of the log", from_list},
             {"x1_m", "m", "easting of the first end", from_list},
             {"y1_m", "m", "northing of the first end", from_list},
             {"x2_m", "m", "easting of the second end", from_list},
             {"y2_m", "m", "northing of the second end", from_list},
             {"species", "text", "species as the list of logs names it", from_list},
             {"diameter1_cm", "cm", "diameter at the first end", from_list},
             {"diameter2_cm", "cm", "diameter at the second end", from_list},
             {"clearance_m", "m", "from the ground to the underside, normal to the ground", from_list},
             {"strength", "-", "share of the strength of fresh wood, falls with decay, 0 to 1", from_list},
             {"hits", "-", "hits by rocks", counted},
             {"broken", "-", "hits that break it", counted},
             {"resting", "-", "rocks that rest upslope of it", counted},
             {"energy_kj", "kJ", "energy it took from all rocks", simulated}}};
}

TableLayout grounds() {
    const std::vector<Column> first{
        {"code", "-", "code of the ground type; 0 for that of terrain.ground", "input terrain"},
        {"ground", "text", "name of the ground type", "input terrain"},
        {"area_share", "-", "share of the cells of the maps with ground", "counted over the cells"}};
    return {"grounds.csv", "a ground type that occurs", together(first, ground_table_columns())};
}

TableLayout impacts() {
    const std::vector<Column> first{
        rock_column(),
        cover_column(),
        {"impact", "-", "number of the impact along the path, from 0", simulated}};
    const std::vector<Column> rest{
        {"ground", "-", "code of the ground type", "input terrain"},
        {"speed_in_mps", "m/s", "speed before it", simulated},
        {"angle_in_deg", "deg", "of the velocity before it below the face of the terrain", simulated},
        {"onward", "text", "jumps, rolls or stops", simulated},
        {"speed_out_mps", "m/s", "speed after it", simulated},
        {"angle_out_deg", "deg", "of the velocity after it above the face of the terrain; 0 where it rolls",
         simulated},
        {"jump_length_m", "m", "straight length of the jump that ended here", simulated},
        {"jump_plan_length_m", "m", "the same in plan", simulated},
        {"jump_height_m", "m", "its largest height above the ground, vertical", simulated},
        {"jump_time_s", "s", "its time", simulated}};
    return {"impacts.csv", "an impact on the ground of a rock whose path is kept",
            together(first, place_columns("", "the rock's underside"), rest)};
}

TableLayout observed_events() {
    return {
        "observed_events.csv",
        "a quantity of passages or impacts, observed or simulated",
        {{"event", "text", "passage at a target, or impact on the ground", "definition"},
         {"target_id", "text", "target of a passage", "input observed.passages"},
         {"group", "text", "column group; all: every row", "input observed.passages, observed.impacts"},
         {"quantity", "text", "what was measured; passing_share: of all rocks; speed_ratio: after by before",
          "definition"},
         {"unit", "text", "unit of the figures", "definition"},
         {"side", "text", "observed or simulated", "definition"},
         {"count", "-", "values", counted},
         {"mean", "as the row says", "mean; of passing_share the share", "as the row says"},
         {"deviation", "as the row says", "standard deviation (n - 1)", "as the row says"},
         {"p10", "as the row says", "10 % quantile", "as the row says"},
         {"p25", "as the row says", "25 % quantile", "as the row says"},
         {"p50", "as the row says", "median", "as the row says"},
         {"p75", "as the row says", "75 % quantile", "as the row says"},
         {"p90", "as the row says", "90 % quantile", "as the row says"},
         {"largest", "as the row says", "largest value", "as the row says"},
         {"ks", "-", "largest distance between the distributions (Kolmogorov-Smirnov)", "both distributions"},
         {"ks_by_chance", "-", "what 5 % of samples of one distribution exceed", "Smirnov 1948"},
         {"energy_distance", "as the row says", "2 E|X - Y| - E|X - X'| - E|Y - Y'|",
          "Szekely & Rizzo 2013"}}};
}

TableLayout mesh_left_out() {
    const std::vector<Column> first{
        {"mesh", "text", "file of the face", "input terrain.mesh"},
        {"face", "-", "number of the face in the file, from 1", "input terrain.mesh"}};
    const std::vector<Column> rest{{"area_m2", "m2", "area of the face in space", "input terrain.mesh"},
                                   {"wkt", "text", "the face as POLYGON Z in metres", "input terrain.mesh"}};
    return {"mesh_left_out.csv", "a face of the mesh that lay below another one",
            together(first, place_columns("", "the middle of the face"), rest)};
}

TableLayout observed_stops() {
    const auto run_out = [](const char* name, const std::string& of) {
        return Column{name, "m", joined(of, " of the plan distance from release to stop"), "as the row says"};
    };
    return {"observed_stops.csv",
            "a group of stops, observed or simulated",
            {{"group", "text", "column group of the observed stops; all: every stop", "input observed.stops"},
             {"side", "text", "observed or simulated", "definition"},
             {"rocks", "-", "stops", counted},
             run_out("run_out_mean_m", "mean"),
             run_out("run_out_deviation_m", "standard deviation (n - 1)"),
             run_out("run_out_p10_m", "10 % quantile"),
             run_out("run_out_p25_m", "25 % quantile"),
             run_out("run_out_p50_m", "median"),
             run_out("run_out_p75_m", "75 % quantile"),
             run_out("run_out_p90_m", "90 % quantile"),
             run_out("run_out_longest_m", "largest value"),
             {"sideways_deviation_m", "m",
              "standard deviation of the distance from the axis, which leads from the mean release to the "
              "mean observed stop",
              "as the row says"},
             {"left_terrain_share", "-", "share that left the terrain: their run-out ends there", simulated},
             {"ks", "-", "largest distance between the distributions of run-out (Kolmogorov-Smirnov)",
              "both distributions"},
             {"ks_by_chance", "-", "what 5 % of samples of one distribution exceed", "Smirnov 1948"},
             {"energy_distance_m", "m", "2 E|X - Y| - E|X - X'| - E|Y - Y'| of the run-outs",
              "Szekely & Rizzo 2013"}}};
}

TableLayout along_lines() {
    const std::vector<Column> place{
        {"from_m", "m", "where the stretch begins, in plan along the line from its first vertex",
         "stretches of 10 m"},
        {"to_m", "m", "where it ends", "stretches of 10 m"},
        {"x_m", "m", "easting of the middle of the stretch", "input targets.file"},
        {"y_m", "m", "northing of the middle of the stretch", "input targets.file"},
        cover_column()};
    return {"along_lines.csv", "a stretch of 10 m of a line on one slope",
            together(target_columns(), place, arrival_columns())};
}

TableLayout by_zone() {
    const std::vector<Column> zone{{"zone", "-",
                                    "release zone; shares are those of the rocks that it released",
                                    "input release.source"}};
    return {
        "by_zone.csv", "a release zone, a target and a slope",
        together(together(zone, target_columns()), std::vector<Column>{cover_column()}, arrival_columns())};
}

TableLayout by_size() {
    const std::vector<Column> size{
        {"diameter_low_m", "m", "smallest diameter of the class; shares are those of its rocks", simulated},
        {"diameter_high_m", "m", "largest diameter of the class", simulated}};
    return {
        "by_size.csv", "a class of block size, a target and a slope",
        together(together(size, target_columns()), std::vector<Column>{cover_column()}, arrival_columns())};
}

TableLayout rocks() {
    const std::vector<Column> first{
        rock_column(),
        cover_column(),
        {"zone", "-", "release zone", "input release"},
        {"source", "-", "number of the release source, from 0", "input release"},
        {"diameter_m", "m", "diameter of the rock",
         "that of its source, else drawn as release.diameter_kind says"},
        {"stop_reason", "text",
         "at_rest, caught (by the roughness of the ground), tree, log, net, left_terrain or gave_up",
         simulated}};
    const std::vector<Column> rest{
        {"run_out_m", "m", "plan distance from release to end", simulated},
        {"azimuth_deg", "deg",
         "direction in plan from release to end, clockwise from north; empty on the spot", simulated},
        {"end_ground", "-", "code of the ground type at the end", "input terrain"},
        {"path_m", "m", "length of the path in space", simulated},
        {"time_s", "s", "time from release to end", simulated},
        {"max_speed_mps", "m/s", "highest speed", simulated},
        {"mean_speed_mps", "m/s", "path divided by time", simulated},
        {"min_speed_mps", "m/s", "smallest speed on the way; 0 where it starts at rest or rolls to a stop",
         simulated},
        {"max_energy_kj", "kJ", joined("highest kinetic energy, ", rockfall::what_energies_count()),
         simulated},
        {"max_height_m", "m", "largest height of the underside above the ground, vertical", simulated},
        {"mean_jump_height_m", "m", "mean over the jumps of their largest heights", simulated},
        {"jumps", "-", "jumps", simulated},
        {"min_jump_length_m", "m",
         "shortest jump, straight from launch to end; jumps below 1 mm do not count", simulated},
        {"mean_jump_length_m", "m", "mean of these lengths", simulated},
        {"max_jump_length_m", "m", "longest jump", simulated},
        {"ground_impacts", "-", "impacts on the ground", simulated},
        {"impacts_by_ground", "text",
         "code of the ground type and impacts on it, such as 3:12 5:2; blanks between the grounds",
         simulated},
        {"tree_hits", "-", "hits on trees", simulated},
        {"trees_broken", "-", "hits with more energy than the tree can take", simulated},
        {"tree_energy_kj", "kJ", "energy taken by trees", simulated},
        {"log_hits", "-", "hits on lying logs", simulated},
        {"logs_broken", "-", "hits that break a log", simulated},
        {"log_energy_kj", "kJ", "energy taken by logs", simulated}};
    return {"rocks.csv", "a rock on one slope",
            together(first, place_columns("_start", "the release"), place_columns("_end", "the end"), rest)};
}

TableLayout arrivals() {
    return {
        "arrivals.csv",
        "a rock that reached a target on one slope",
        {rock_column(),
         target_columns().front(),
         cover_column(),
         {"x_m", "m", "easting of the first arrival", simulated},
         {"y_m", "m", "northing of the first arrival", simulated},
         {"energy_kj", "kJ", joined("kinetic energy there, ", rockfall::what_energies_count()), simulated},
         {"translational_kj", "kJ", "the translational part of it", simulated},
         {"speed_mps", "m/s", "speed there", simulated},
         {"height_m", "m", "height of the underside above the ground there, vertical", simulated},
         {"centre_height_m", "m", "height of the rock's centre above the ground there, vertical", simulated},
         {"top_height_m", "m", "height of the rock's highest point above the ground there, vertical",
          simulated}}};
}

TableLayout tree_hits() {
    const std::vector<Column> first{rock_column(),
                                    {"tree_id", "text", "tree that was hit", "input trees.file"}};
    const std::vector<Column> rest{
        {"height_m", "m", "height of the rock's centre above the ground at the stem", simulated},
        {"energy_kj", "kJ", "kinetic energy of the rock before the hit", simulated},
        {"energy_taken_kj", "kJ", "energy that the tree took", simulated},
        {"hit_type", "text", "frontal, lateral or scratch", simulated},
        {"broken", "text", "yes: the hit had more energy than the tree can take", simulated},
        {"stopped", "text", "yes: the rock stopped at the tree", simulated}};
    return {"tree_hits.csv", "a hit of a rock on a tree",
            together(first, place_columns("", "the rock's underside"), rest)};
}

TableLayout log_hits() {
    const std::vector<Column> first{rock_column(),
                                    {"log_id", "text", "log that was hit", "input trees.logs"}};
    const std::vector<Column> rest{
        {"energy_kj", "kJ", "kinetic energy of the rock before the hit", simulated},
        {"energy_taken_kj", "kJ", "energy that the log took", simulated},
        {"outcome", "text", "climbed, broke, turned or stopped", simulated}};
    return {"log_hits.csv", "a hit of a rock on a lying log",
            together(first, place_columns("", "the rock's underside"), rest)};
}

TableLayout trajectories() {
    const std::vector<Column> first{rock_column(),
                                    cover_column(),
                                    {"point", "-", "number of the corner along the path, from 0", simulated}};
    const std::vector<Column> rest{
        {"energy_kj", "kJ", joined("kinetic energy, ", rockfall::what_energies_count()), simulated},
        {"height_m", "m", "height of the underside above the ground, vertical", simulated}};
    return {"trajectories.csv", "a corner of a sampled path",
            together(first, place_columns("", "the rock's underside"), rest)};
}

TableLayout trajectories_wkt() {
    return {"trajectories_wkt.csv",
            "a sampled path",
            {rock_column(),
             cover_column(),
             {"energy_max_kj", "kJ", "largest kinetic energy at the corners of the path", simulated},
             {"wkt", "text", "the path as LINESTRING Z in metres", simulated}}};
}

}  // namespace

const std::vector<TableLayout>& static_layouts() {
    static const std::vector<TableLayout> layouts = [] {
        std::vector<TableLayout> all{targets(),        protection(),   target_distributions(),
                                     runs(),           run_out(),      tree_hits_per_rock(),
                                     grounds(),        stems(),        logs(),
                                     rocks(),          arrivals(),     tree_hits(),
                                     log_hits(),       trajectories(), trajectories_wkt(),
                                     observed_stops(), impacts(),      along_lines(),
                                     by_zone(),        by_size(),      mesh_left_out(),
                                     observed_events()};
        const std::vector<TableLayout> of_nets = net_layouts();
        all.insert(all.end(), of_nets.begin(), of_nets.end());
        return all;
    }();
    return layouts;
}

}  // namespace coupling
