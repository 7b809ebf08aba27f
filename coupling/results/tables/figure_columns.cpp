#include "coupling/results/tables/figure_columns.hpp"

#include <cmath>
#include <limits>
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

constexpr const char* simulated = "simulated";
constexpr const char* counted = "counted over the simulated rocks";
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
std::vector<Column> distribution_columns(const Quantity& quantity) {
    std::vector<Column> columns;
    const auto add = [&](const std::string& figure, const std::string& words, const char* source) {
        columns.push_back({joined(quantity.name, "_", figure, "_", quantity.ending), quantity.unit,
                           joined(words, " of ", quantity.meaning), source});
    };
    const char* ranks = "order statistics by the binomial law; whole bins";
    add("mean", "mean", simulated);
    add("50", "median", from_bins);
    add("90", "90th percentile (empty: fewer than 10 rocks)", from_bins);
    add("95", "95th percentile (empty: fewer than 20 rocks)", from_bins);
    add("95_low", "lower end (empty: fewer than 20 rocks) of the 95 % interval of the 95th percentile",
        ranks);
    add("95_high", "upper end (empty: fewer than 72 rocks) of the 95 % interval of the 95th percentile",
        ranks);
    add("98", "98th percentile (empty: fewer than 50 rocks)", from_bins);
    add("99", "99th percentile (empty: fewer than 100 rocks)", from_bins);
    add("max", "largest value", simulated);
    return columns;
}

void add_distribution(CsvRow& row, const Distribution& d) {
    const bool known = !std::isnan(d.p95);
    row.number<3>(d.mean).number<3>(d.p50).number<3>(d.p90).number<3>(d.p95);
    row.number<3>(known ? d.p95_interval.low : d.p95).number<3>(d.p95_interval.high);
    row.number<3>(d.p98).number<3>(d.p99).number<3>(d.max);
}

}  // namespace

std::vector<Column> target_columns() {
    return {{"target_id", "text", "short name of the target", "input targets.file"},
            {"name", "text", "name of the target", "input targets.file"}};
}

Column cover_column() {
    return {"cover", "text",
            "forest: with trees and lying logs; bare: the same slope without them; nets stand on both",
            "definition"};
}

std::vector<Column> energy_rate_columns() {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < rockfall::counted_energies_j.size(); ++i) {
        const std::string above = joined("above_", kj_text(i), "_kj_");
        const std::string words = joined("rocks with more than ", kj_text(i), " kJ at the first arrival");
        columns.push_back({above + "rocks", "-", words, "counted rock by rock, not from bins"});
        columns.push_back({above + "per_1000", "1/1000", words + ", per 1000 released", counted});
        columns.push_back(
            {above + "low_per_1000", "1/1000", "lower end of its 95 % interval", exact_interval});
        columns.push_back(
            {above + "high_per_1000", "1/1000", "upper end of its 95 % interval", exact_interval});
    }
    return columns;
}

void add_energy_rates(CsvRow& row, std::span<const Share> above) {
    constexpr double per_1000 = 1000.0;
    for (const Share& share : above) {
        row.whole(share.part).number<4>(per_1000 * share.value);
        row.number<4>(per_1000 * share.interval.low).number<4>(per_1000 * share.interval.high);
    }
}

std::vector<Column> arrival_columns() {
    const std::vector<Column> shares{
        {"rocks", "-", "rocks that fell", counted},
        {"reached", "-", "rocks that reached the target", counted},
        {"share_percent", "%", "share of the rocks that reached the target", counted},
        {"share_low_percent", "%", "lower end of its 95 % interval", exact_interval},
        {"share_high_percent", "%", "upper end of its 95 % interval", exact_interval}};
    return together(shares, distribution_columns(arrival_energy()), energy_rate_columns(),
                    distribution_columns(arrival_speed), distribution_columns(arrival_height),
                    distribution_columns(arrival_top));
}

void add_arrivals(CsvRow& row, const ArrivalFigures& arrivals) {
    row.whole(arrivals.share.whole).whole(arrivals.share.part).number<4>(percent * arrivals.share.value);
    row.number<4>(percent * arrivals.share.interval.low).number<4>(percent * arrivals.share.interval.high);
    add_distribution(row, arrivals.energy_kj);
    add_energy_rates(row, arrivals.above);
    add_distribution(row, arrivals.speed_mps);
    add_distribution(row, arrivals.height_m);
    add_distribution(row, arrivals.top_height_m);
}

std::vector<Column> protection_columns() {
    constexpr const char* paired = "paired ratio by the delta method (coupling/results/README.md)";
    constexpr const char* named_after = "choice, named after Dupire et al. 2016";
    return {
        {"rocks", "-", "rocks that fell", counted},
        {"reached_bare", "-", "rocks that reach the target over the bare slope", counted},
        {"reached_forest", "-", "rocks that reach it with forest", counted},
        {"reached_both", "-", "rocks that reach it on both slopes", counted},
        {"protection_percent", "%",
         "protection effect: share of the rocks arriving over the bare slope that the forest stops; "
         "empty where none arrives",
         "1 - reached_forest / reached_bare"},
        {"protection_low_percent", "%",
         "lower end of its 95 % interval; one-sided where no rock comes through", paired},
        {"protection_high_percent", "%", "upper end of its 95 % interval", paired},
        {"too_few_rocks", "text",
         joined("yes: fewer than ", std::to_string(least_arrivals_for_protection),
                " rocks arrive over the bare slope, too few for a protection figure"),
         "choice"},
        {"bari_percent", "%", "reduction of the number of arrivals", named_after},
        {"miri_percent", "%",
         "reduction of the 95th percentile of the energy; 100 where no rock comes through; empty where "
         "fewer than 20 rocks arrive on a slope: the percentile is not known",
         named_after},
        {"orpi_percent", "%", "both together: 1 - (1 - BARI) (1 - MIRI); empty where MIRI is", named_after}};
}

void add_protection(CsvRow& row, std::uint64_t rocks, const PairedCounts& paired,
                    const std::optional<ProtectionEffect>& effect,
                    const std::optional<RiskReduction>& reduction) {
    row.whole(rocks).whole(paired.bare()).whole(paired.forest()).whole(paired.both);
    if (effect) {
        row.number<3>(percent * effect->value);
        row.number<3>(percent * effect->interval.low).number<3>(percent * effect->interval.high);
    } else {
        row.empty().empty().empty();
    }
    row.text(too_few_for_protection(paired) ? "yes" : "no");
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const RiskReduction known = reduction.value_or(RiskReduction{unknown, unknown, unknown});
    row.number<3>(known.bari_percent).number<3>(known.miri_percent).number<3>(known.orpi_percent);
}

std::vector<Column> slope_columns() {
    constexpr const char* bins_10_m = "simulated; straight inside bins of 10 m";
    constexpr const char* distance =
        "of the run-out (plan distance from release to end) of the rocks that stopped on the terrain";
    constexpr const char* bound =
        "of the run-out of all rocks is at least this: one that left the terrain or was given up counts with "
        "the distance to where it was seen last";
    const std::vector<Column> stops{
        {"rocks", "-", "rocks that fell", counted},
        {"at_rest", "-", "rocks whose energy was used up", counted},
        {"caught", "-", "rocks stopped by the roughness of the ground", counted},
        {"stopped_by_tree", "-", "rocks stopped by a tree", counted},
        {"stopped_by_log", "-", "rocks that rest upslope of a lying log", counted},
        {"stopped_by_net", "-", "rocks held by a net", counted},
        {"left_terrain", "-", "rocks that left the terrain; they do not count as stopped", counted},
        {"gave_up", "-", "rocks that the simulation gave up; they do not count as stopped", counted}};
    const std::vector<Column> run_out{
        {"run_out_mean_m", "m", joined("mean ", distance), simulated},
        {"run_out_50_m", "m", joined("median ", distance), bins_10_m},
        {"run_out_90_m", "m", joined("90th percentile ", distance), bins_10_m},
        {"run_out_95_m", "m", joined("95th percentile ", distance), bins_10_m},
        {"run_out_98_m", "m", joined("98th percentile ", distance), bins_10_m},
        {"run_out_99_m", "m", joined("99th percentile ", distance), bins_10_m},
        {"run_out_max_m", "m", joined("largest value ", distance), simulated},
        {"run_out_at_least_mean_m", "m", joined("the mean ", bound), simulated},
        {"run_out_at_least_95_m", "m", joined("the 95th percentile ", bound), bins_10_m}};
    const std::vector<Column> means{
        {"mean_speed_mps", "m/s", "mean over rocks of path divided by time", simulated},
        {"jump_height_mean_m", "m", "mean over all jumps of their largest heights", simulated},
        {"jumps_per_rock", "-", "jumps, mean over rocks", simulated},
        {"ground_impacts_per_rock", "-", "impacts on the ground, mean over rocks", simulated},
        {"tree_hits_per_rock", "-", "hits on trees, mean over rocks", simulated},
        {"trees_broken_per_rock", "-", "hits with more energy than the tree can take, mean over rocks",
         simulated},
        {"tree_energy_per_rock_kj", "kJ", "energy taken by trees, mean over rocks", simulated},
        {"hit_a_tree_percent", "%", "share of the rocks that hit a tree", counted},
        {"log_hits_per_rock", "-", "hits on lying logs, mean over rocks", simulated},
        {"logs_broken_per_rock", "-", "hits that break a log, mean over rocks", simulated},
        {"log_energy_per_rock_kj", "kJ", "energy taken by logs, mean over rocks", simulated}};
    return together(stops, run_out, distribution_columns(top_speed), distribution_columns(top_energy()),
                    distribution_columns(top_height), means);
}

void add_slope(CsvRow& row, const SlopeFigures& slope) {
    row.whole(slope.rocks);
    for (const Share& share : slope.by_reason) {
        row.whole(share.part);
    }
    const Distribution& run_out = slope.run_out_m;
    row.number<2>(run_out.mean).number<2>(run_out.p50).number<2>(run_out.p90).number<2>(run_out.p95);
    row.number<2>(run_out.p98).number<2>(run_out.p99).number<2>(run_out.max);
    row.number<2>(slope.run_out_at_least_m.mean).number<2>(slope.run_out_at_least_m.p95);
    add_distribution(row, slope.max_speed_mps);
    add_distribution(row, slope.max_energy_kj);
    add_distribution(row, slope.max_height_m);
    row.number<3>(slope.mean_speed_mps).number<3>(slope.jump_height_mean_m).number<3>(slope.jumps_per_rock);
    row.number<3>(slope.ground_impacts_per_rock).number<4>(slope.tree_hits_per_rock);
    row.number<4>(slope.trees_broken_per_rock).number<3>(slope.tree_energy_per_rock_kj);
    row.number<4>(percent * slope.hit_a_tree.value);
    row.number<4>(slope.log_hits_per_rock).number<4>(slope.logs_broken_per_rock);
    row.number<3>(slope.log_energy_per_rock_kj);
}

}  // namespace coupling
