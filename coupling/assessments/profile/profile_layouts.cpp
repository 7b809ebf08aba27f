#include "coupling/assessments/profile/profile_layouts.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::profile {
namespace {

using config::joined;

constexpr const char* simulated = "simulated";
constexpr const char* counted_rocks = "counted over the simulated rocks";
constexpr const char* from_bins = "simulated; fine bins, at most 0.4 % from the value";
constexpr const char* from_wide_bins = "simulated; bins, at most 3.2 % from the value";
constexpr const char* exact_interval = "Clopper and Pearson 1934";

TableLayout rocks() {
    return {"rocks.csv",
            "a rock",
            {{"rock", "-", "number of the rock", simulated},
             {"diameter_m", "m", "diameter of the rock", "drawn as release.diameter_kind says"},
             {"stop_reason", "text",
              "at_rest, caught (by the roughness of the ground), left_terrain or gave_up", simulated},
             {"start_distance_m", "m", "plan distance of the release along the profile", simulated},
             {"start_height_m", "m", "height of the release above sea", simulated},
             {"end_distance_m", "m", "plan distance of the end along the profile", simulated},
             {"end_height_m", "m", "height of the end above sea", simulated},
             {"run_out_m", "m", "plan distance from release to end", simulated},
             {"path_m", "m", "length of the path in space", simulated},
             {"time_s", "s", "time from release to end", simulated},
             {"max_speed_mps", "m/s", "highest speed", simulated},
             {"mean_speed_mps", "m/s", "path divided by time", simulated},
             {"min_speed_mps", "m/s",
              "smallest speed on the way; 0 where it starts at rest or rolls to a stop", simulated},
             {"max_energy_kj", "kJ", joined("highest kinetic energy, ", rockfall::what_energies_count()),
              simulated},
             {"max_height_m", "m", "largest height of the underside above the ground, vertical", simulated},
             {"mean_jump_height_m", "m", "mean over the jumps of their largest heights", simulated},
             {"jumps", "-", "jumps", simulated},
             {"min_jump_length_m", "m",
              "shortest jump, straight from launch to end; jumps below 1 mm do not count", simulated},
             {"mean_jump_length_m", "m", "mean of these lengths", simulated},
             {"max_jump_length_m", "m", "longest jump", simulated},
             {"ground_impacts", "-", "impacts on the ground", simulated}}};
}

TableLayout jumps_by_segment() {
    return {
        "jumps_by_segment.csv",
        "a segment of the slope",
        {{"from_m", "m", "slope length from the upper end of the profile to the begin of the segment",
          "profile.segment_m"},
         {"to_m", "m", "slope length to its end", "profile.segment_m"},
         {"from_distance_m", "m", "plan distance of its begin", "input terrain.profile"},
         {"to_distance_m", "m", "plan distance of its end", "input terrain.profile"},
         {"jumps", "-", "jumps that end in it", counted_rocks},
         {"min_length_m", "m", "shortest jump, straight from impact to impact", simulated},
         {"mean_length_m", "m", "mean length of the jumps", simulated},
         {"max_length_m", "m", "longest jump", simulated},
         {"mean_impact_speed_mps", "m/s", "mean speed before the impact that ends a jump", simulated},
         {"sd_length_m", "m", "standard deviation of the lengths", simulated},
         {"mean_height_m", "m", "mean of the jumps' largest heights above the ground, vertical", simulated},
         {"max_height_m", "m", "largest of these heights", simulated}}};
}

TableLayout run_out() {
    return {"run_out.csv",
            "a distance along the profile",
            {{"distance_m", "m", "plan distance along the profile", "input terrain.profile"},
             {"rocks_beyond", "-",
              "rocks whose fall ended beyond it; those that left over the lower end are beyond all",
              counted_rocks},
             {"beyond_percent", "%", "their share of all rocks", counted_rocks},
             {"beyond_low_percent", "%", "lower end of its 95 % interval", exact_interval},
             {"beyond_high_percent", "%", "upper end of its 95 % interval", exact_interval}}};
}

TableLayout stations() {
    const std::vector<Column> energies{
        {"station", "text", "name of the station", "input profile.stations"},
        {"distance_m", "m", "plan distance along the profile", "input profile.stations"},
        {"rocks", "-", "rocks that pass it at least once", counted_rocks},
        {"reached_percent", "%", "their share of all rocks", counted_rocks},
        {"reached_low_percent", "%", "lower end of its 95 % interval", exact_interval},
        {"reached_high_percent", "%", "upper end of its 95 % interval", exact_interval},
        {"energy_mean_kj", "kJ",
         joined("mean kinetic energy (", rockfall::what_energies_count(), ") at the first passage"),
         simulated},
        {"energy_sd_kj", "kJ", "its standard deviation", simulated},
        {"energy_50_kj", "kJ", "its median", from_bins},
        {"energy_90_kj", "kJ", "its 90th percentile (empty: fewer than 10 rocks)", from_bins},
        {"energy_95_kj", "kJ", "its 95th percentile (empty: fewer than 20 rocks)", from_bins},
        {"energy_99_kj", "kJ", "its 99th percentile (empty: fewer than 100 rocks)", from_bins},
        {"energy_max_kj", "kJ", "its largest value", simulated}};
    const std::vector<Column> rest{
        {"translational_mean_kj", "kJ", "mean of its translational part", simulated},
        {"speed_mean_mps", "m/s", "mean speed at the first passage", simulated},
        {"speed_95_mps", "m/s", "its 95th percentile (empty: fewer than 20 rocks)", from_bins},
        {"speed_max_mps", "m/s", "its largest value", simulated},
        {"height_mean_m", "m",
         "mean height of the underside above the ground, vertical, at the first passage", simulated},
        {"height_95_m", "m", "its 95th percentile (empty: fewer than 20 rocks)", from_bins},
        {"height_max_m", "m", "its largest value", simulated}};
    return {"stations.csv", "a station", together(energies, energy_rate_columns(), rest)};
}

TableLayout envelope() {
    return {
        "envelope.csv",
        "a stretch of the profile",
        {{"from_distance_m", "m", "plan distance of its begin", "input terrain.profile"},
         {"to_distance_m", "m", "plan distance of its end", "input terrain.profile"},
         {"rocks", "-", "rocks that passed it", counted_rocks},
         {"energy_mean_kj", "kJ", "mean of each rock's largest kinetic energy in it", simulated},
         {"energy_95_kj", "kJ", "its 95th percentile (empty: fewer than 20 rocks)", from_wide_bins},
         {"energy_max_kj", "kJ", "its largest value", simulated},
         {"height_mean_m", "m", "mean of each rock's largest height in it, normal to the slope", simulated},
         {"height_95_m", "m", "its 95th percentile (empty: fewer than 20 rocks)", from_wide_bins},
         {"height_max_m", "m", "its largest value", simulated},
         {"speed_mean_mps", "m/s", "mean of each rock's highest speed in it", simulated},
         {"speed_95_mps", "m/s", "its 95th percentile (empty: fewer than 20 rocks)", from_bins},
         {"speed_max_mps", "m/s", "its largest value", simulated}}};
}

TableLayout paths() {
    return {
        "paths.csv",
        "a corner of a sampled path",
        {{"rock", "-", "number of the rock", simulated},
         {"point", "-", "number of the corner along the path, from 0", simulated},
         {"distance_m", "m", "plan distance along the profile", simulated},
         {"height_m", "m", "height of the rock's underside above sea", simulated},
         {"energy_kj", "kJ", joined("kinetic energy, ", rockfall::what_energies_count()), simulated},
         {"height_above_ground_m", "m", "height of the underside above the ground, vertical", simulated}}};
}

}  // namespace

const std::vector<TableLayout>& profile_layouts() {
    static const std::vector<TableLayout> layouts{rocks(),    jumps_by_segment(), run_out(),
                                                  stations(), envelope(),         paths()};
    return layouts;
}

}  // namespace coupling::profile
