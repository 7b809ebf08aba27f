#include "coupling/results/tables/figure_columns.hpp"

#include <cmath>
#include <string>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::joined;
using config::percent;

constexpr const char* from_bins = "simulated; fine bins, at most 0.4 % from the value";
constexpr const char* exact_interval = "Clopper and Pearson 1934";

/// A quantity over rocks.
struct Quantity {
    std::string name;    ///< as columns begin
    std::string ending;  ///< of the columns: its unit
    std::string unit;
    std::string meaning;
};

Quantity arrival_energy() {
    return {"energy", "kj", "kJ",
            joined("kinetic energy (", rockfall::what_energies_count(), ") at the first arrival")};
}
const Quantity arrival_speed{"speed", "mps", "m/s", "speed at the first arrival"};
const Quantity arrival_height{"height", "m", "m",
                              "height of the underside above the ground, vertical, at the first arrival"};
const Quantity top_speed{"max_speed", "mps", "m/s", "each rock's highest speed"};
Quantity top_energy() {
    return {"max_energy", "kj", "kJ",
            joined("each rock's highest kinetic energy (", rockfall::what_energies_count(), ")")};
}
const Quantity arrival_top{
    "top_height", "m", "m",
    "height of the rock's highest point above the ground, vertical, at the first arrival"};
const Quantity top_height{"max_height", "m", "m", "each rock's largest height above the ground, vertical"};

/// energy_mean_kj, energy_50_kj, ...: the columns of a distribution.
ColumnsOf<Distribution> distribution_columns(const Quantity& quantity) {
    const auto figure = [&](const char* name, const char* words, const char* source, auto value) {
        return ColumnsOf<Distribution>{joined(quantity.name, "_", name, "_", quantity.ending),
                                       quantity.unit,
                                       3,
                                       joined(words, " of ", quantity.meaning),
                                       source,
                                       value};
    };
    const char* ranks = "order statistics by the binomial law; whole bins";
    return {
        figure("mean", "mean", from_simulation, &Distribution::mean),
        figure("50", "median", from_bins, &Distribution::p50),
        figure("90", "90th percentile (empty: fewer than 10 rocks)", from_bins, &Distribution::p90),
        figure("95", "95th percentile (empty: fewer than 20 rocks)", from_bins, &Distribution::p95),
        figure("95_low", "lower end (empty: fewer than 20 rocks) of the 95 % interval of the 95th percentile",
               ranks, [](const Distribution& d) { return std::isnan(d.p95) ? d.p95 : d.p95_interval.low; }),
        figure("95_high",
               "upper end (empty: fewer than 72 rocks) of the 95 % interval of the 95th percentile", ranks,
               [](const Distribution& d) { return d.p95_interval.high; }),
        figure("98", "98th percentile (empty: fewer than 50 rocks)", from_bins, &Distribution::p98),
        figure("99", "99th percentile (empty: fewer than 100 rocks)", from_bins, &Distribution::p99),
        figure("max", "largest value", from_simulation, &Distribution::max)};
}

}  // namespace

Column target_id_column() {
    return {"target_id", "text", "short name of the target", "input targets.file"};
}

ColumnsOf<TargetName> target_columns() {
    return {{target_id_column(), &TargetName::id},
            {"name", "name of the target", "input targets.file", &TargetName::name}};
}

Column cover_column() {
    return {"cover", "text",
            "forest: with trees and lying logs; bare: the same slope without them; nets stand on both",
            "definition"};
}

Column rock_column() {
    return {"rock", "-", "number of the rock; the same rock falls with forest and over the bare slope",
            from_simulation};
}

ColumnsOf<Eigen::Vector3d> place_columns(const std::string& infix, const std::string& of_what) {
    return {{joined("x", infix, "_m"), 2, joined("easting of ", of_what),
             [](const auto& place_m) { return place_m.x(); }},
            {joined("y", infix, "_m"), 2, joined("northing of ", of_what),
             [](const auto& place_m) { return place_m.y(); }},
            {joined("z", infix, "_m"), 2, joined("height above sea of ", of_what),
             [](const auto& place_m) { return place_m.z(); }}};
}

ColumnsOf<Share> share_columns(const std::string& name, const char* meaning) {
    return {{joined(name, "_percent"), 4, meaning, from_counting,
             [](const Share& share) { return percent * share.value; }},
            {joined(name, "_low_percent"), 4, "lower end of its 95 % interval", exact_interval,
             [](const Share& share) { return percent * share.interval.low; }},
            {joined(name, "_high_percent"), 4, "upper end of its 95 % interval", exact_interval,
             [](const Share& share) { return percent * share.interval.high; }}};
}

ColumnsOf<RocksAbove> energy_rate_columns() {
    ColumnsOf<RocksAbove> columns;
    for (std::size_t i = 0; i < rockfall::counted_energies_j.size(); ++i) {
        const std::string above = joined("above_", kj_text(i), "_kj_");
        const std::string words = joined("rocks with at least ", kj_text(i), " kJ at the first arrival");
        const ColumnsOf<Share> rate{
            {above + "rocks", words, "counted rock by rock, not from bins", &Share::part},
            {above + "per_1000", 4, words + ", per 1000 released", from_counting,
             [](const Share& share) { return 1000.0 * share.value; }},
            {above + "low_per_1000", 4, "lower end of its 95 % interval", exact_interval,
             [](const Share& share) { return 1000.0 * share.interval.low; }},
            {above + "high_per_1000", 4, "upper end of its 95 % interval", exact_interval,
             [](const Share& share) { return 1000.0 * share.interval.high; }}};
        columns += {rate, [i](const RocksAbove& all) -> const Share& { return all[i]; }};
    }
    return columns;
}

ColumnsOf<ArrivalFigures> arrival_columns() {
    const ColumnsOf<Share> shares{{"rocks", "rocks that fell", from_counting, &Share::whole},
                                  {"reached", "rocks that reached the target", from_counting, &Share::part},
                                  share_columns("share", "share of the rocks that reached the target")};
    return {{shares, &ArrivalFigures::share},
            {distribution_columns(arrival_energy()), &ArrivalFigures::energy_kj},
            {energy_rate_columns(), &ArrivalFigures::above},
            {distribution_columns(arrival_speed), &ArrivalFigures::speed_mps},
            {distribution_columns(arrival_height), &ArrivalFigures::height_m},
            {distribution_columns(arrival_top), &ArrivalFigures::top_height_m}};
}

ColumnsOf<rockfall::RockRecord> motion_columns() {
    using Record = rockfall::RockRecord;
    return {
        {"path_m", 2, "length of the path in space", &Record::path_m},
        {"time_s", 2, "time from release to end", &Record::time_s},
        {"max_speed_mps", 3, "highest speed", &Record::max_speed_mps},
        {"mean_speed_mps", 3, "path divided by time", &Record::mean_speed_mps},
        {"min_speed_mps", 3, "smallest speed on the way; 0 where it starts at rest or rolls to a stop",
         &Record::min_speed_mps},
        {"max_energy_kj", 3, joined("highest kinetic energy, ", rockfall::what_energies_count()),
         [](const Record& r) { return r.max_energy_j / config::j_per_kj; }},
        {"max_height_m", 3, "largest height of the underside above the ground, vertical",
         &Record::max_height_m},
        {"mean_jump_height_m", 3, "mean over the jumps of their largest heights",
         &Record::mean_jump_height_m},
        {"jumps", "jumps", &Record::jumps},
        {"min_jump_length_m", 3, "shortest jump, straight from launch to end; jumps below 1 mm do not count",
         &Record::min_jump_length_m},
        {"mean_jump_length_m", 3, "mean of these lengths", &Record::mean_jump_length_m},
        {"max_jump_length_m", 3, "longest jump", &Record::max_jump_length_m},
        {"ground_impacts", "impacts on the ground", &Record::ground_impacts}};
}

ColumnsOf<ProtectionEffect> protection_effect_columns() {
    constexpr const char* paired = "paired ratio by the delta method (coupling/results/README.md)";
    return {
        {"protection_percent", 3,
         "protection effect: share of the rocks arriving over the bare slope that the forest stops; "
         "empty where none arrives",
         "1 - reached_forest / reached_bare", [](const auto& e) { return percent * e.value; }},
        {"protection_low_percent", 3, "lower end of its 95 % interval; one-sided where no rock comes through",
         paired, [](const auto& e) { return percent * e.interval.low; }},
        {"protection_high_percent", 3, "upper end of its 95 % interval", paired,
         [](const auto& e) { return percent * e.interval.high; }}};
}

ColumnsOf<ProtectionFigures> protection_columns() {
    constexpr const char* named_after = "choice, named after Dupire et al. 2016";
    const ColumnsOf<RiskReduction> reduction{
        {"bari_percent", 3, "reduction of the number of arrivals", named_after, &RiskReduction::bari_percent},
        {"miri_percent", 3,
         "reduction of the 95th percentile of the energy; 100 where no rock comes through; empty where "
         "fewer than 20 rocks arrive on a slope: the percentile is not known",
         named_after, &RiskReduction::miri_percent},
        {"orpi_percent", 3, "both together: 1 - (1 - BARI) (1 - MIRI); empty where MIRI is", named_after,
         &RiskReduction::orpi_percent}};
    return {
        {"rocks", "rocks that fell", from_counting, &ProtectionFigures::rocks},
        {"reached_bare", "rocks that reach the target over the bare slope", from_counting,
         [](const auto& f) { return f.paired.bare(); }},
        {"reached_forest", "rocks that reach it with forest", from_counting,
         [](const auto& f) { return f.paired.forest(); }},
        {"reached_both", "rocks that reach it on both slopes", from_counting,
         [](const auto& f) { return f.paired.both; }},
        {protection_effect_columns(), &ProtectionFigures::effect},
        {"too_few_rocks",
         joined("yes: fewer than ", std::to_string(least_arrivals_for_protection),
                " rocks arrive over the bare slope, or the interval holds 0 and reaches beyond 100 %: too "
                "few for a protection figure"),
         "choice", [](const auto& f) { return too_few_for_protection(f.paired); }},
        {reduction, &ProtectionFigures::reduction}};
}

ColumnsOf<SlopeFigures> slope_columns() {
    constexpr const char* bins_10_m = "simulated; straight inside bins of 10 m";
    constexpr const char* distance =
        "of the run-out (plan distance from release to end) of the rocks that stopped on the terrain";
    constexpr const char* bound =
        "of the run-out of all rocks is at least this: one that left the terrain or was given up counts with "
        "the distance to where it was seen last";
    const auto stopped = [](rockfall::StopReason reason) {
        return [reason](const SlopeFigures& f) { return f.by_reason[static_cast<std::size_t>(reason)].part; };
    };
    using rockfall::StopReason;
    const ColumnsOf<SlopeFigures> stops{
        {"rocks", "rocks that fell", from_counting, &SlopeFigures::rocks},
        {"at_rest", "rocks whose energy was used up", from_counting, stopped(StopReason::at_rest)},
        {"caught", "rocks stopped by the roughness of the ground", from_counting,
         stopped(StopReason::caught)},
        {"stopped_by_tree", "rocks stopped by a tree", from_counting, stopped(StopReason::tree)},
        {"stopped_by_log", "rocks that rest upslope of a lying log", from_counting, stopped(StopReason::log)},
        {"stopped_by_net", "rocks held by a net", from_counting, stopped(StopReason::net)},
        {"left_terrain", "rocks that left the terrain; they do not count as stopped", from_counting,
         stopped(StopReason::left_terrain)},
        {"gave_up", "rocks that the simulation gave up; they do not count as stopped", from_counting,
         stopped(StopReason::gave_up)}};
    const ColumnsOf<Distribution> run_out{
        {"run_out_mean_m", 2, joined("mean ", distance), &Distribution::mean},
        {"run_out_50_m", 2, joined("median ", distance), bins_10_m, &Distribution::p50},
        {"run_out_90_m", 2, joined("90th percentile ", distance), bins_10_m, &Distribution::p90},
        {"run_out_95_m", 2, joined("95th percentile ", distance), bins_10_m, &Distribution::p95},
        {"run_out_98_m", 2, joined("98th percentile ", distance), bins_10_m, &Distribution::p98},
        {"run_out_99_m", 2, joined("99th percentile ", distance), bins_10_m, &Distribution::p99},
        {"run_out_max_m", 2, joined("largest value ", distance), &Distribution::max}};
    const ColumnsOf<Distribution> at_least{
        {"run_out_at_least_mean_m", 2, joined("the mean ", bound), &Distribution::mean},
        {"run_out_at_least_95_m", 2, joined("the 95th percentile ", bound), bins_10_m, &Distribution::p95}};
    const ColumnsOf<SlopeFigures> means{
        {"mean_speed_mps", 3, "mean over rocks of path divided by time", &SlopeFigures::mean_speed_mps},
        {"jump_height_mean_m", 3, "mean over all jumps of their largest heights",
         &SlopeFigures::jump_height_mean_m},
        {"jumps_per_rock", 3, "jumps, mean over rocks", &SlopeFigures::jumps_per_rock},
        {"ground_impacts_per_rock", 3, "impacts on the ground, mean over rocks",
         &SlopeFigures::ground_impacts_per_rock},
        {"tree_hits_per_rock", 4, "hits on trees, mean over rocks", &SlopeFigures::tree_hits_per_rock},
        {"trees_broken_per_rock", 4, "hits with more energy than the tree can take, mean over rocks",
         &SlopeFigures::trees_broken_per_rock},
        {"tree_energy_per_rock_kj", 3, "energy taken by trees, mean over rocks",
         &SlopeFigures::tree_energy_per_rock_kj},
        {"hit_a_tree_percent", 4, "share of the rocks that hit a tree", from_counting,
         [](const auto& f) { return percent * f.hit_a_tree.value; }},
        {"log_hits_per_rock", 4, "hits on lying logs, mean over rocks", &SlopeFigures::log_hits_per_rock},
        {"logs_broken_per_rock", 4, "hits that break a log, mean over rocks",
         &SlopeFigures::logs_broken_per_rock},
        {"log_energy_per_rock_kj", 3, "energy taken by logs, mean over rocks",
         &SlopeFigures::log_energy_per_rock_kj}};
    return {stops,
            {run_out, &SlopeFigures::run_out_m},
            {at_least, &SlopeFigures::run_out_at_least_m},
            {distribution_columns(top_speed), &SlopeFigures::max_speed_mps},
            {distribution_columns(top_energy()), &SlopeFigures::max_energy_kj},
            {distribution_columns(top_height), &SlopeFigures::max_height_m},
            means};
}

}  // namespace coupling
