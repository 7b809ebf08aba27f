#include "coupling/results/figure_columns.hpp"

#include <cmath>
#include <limits>

namespace coupling {
namespace {

constexpr double percent = 100.0;

/// ",energy_mean_kj,energy_50_kj,...": the columns of a distribution.
std::string distribution_columns(const std::string& quantity, const std::string& unit) {
    std::string columns;
    for (const char* figure : {"mean", "50", "90", "95", "95_low", "95_high", "98", "99", "max"}) {
        columns += "," + quantity + "_" + figure + "_" + unit;
    }
    return columns;
}

void add_distribution(CsvRow& row, const Distribution& d) {
    const bool known = !std::isnan(d.mean);
    row.number<3>(d.mean).number<3>(d.p50).number<3>(d.p90).number<3>(d.p95);
    row.number<3>(known ? d.p95_interval.low : d.mean).number<3>(d.p95_interval.high);
    row.number<3>(d.p98).number<3>(d.p99).number<3>(d.max);
}

}  // namespace

std::string arrival_columns() {
    return ",rocks,reached,share_percent,share_low_percent,share_high_percent" +
           distribution_columns("energy", "kj") + distribution_columns("speed", "mps") +
           distribution_columns("height", "m");
}

void add_arrivals(CsvRow& row, const ArrivalFigures& arrivals) {
    row.whole(arrivals.share.whole).whole(arrivals.share.part).number<4>(percent * arrivals.share.value);
    row.number<4>(percent * arrivals.share.interval.low).number<4>(percent * arrivals.share.interval.high);
    add_distribution(row, arrivals.energy_kj);
    add_distribution(row, arrivals.speed_mps);
    add_distribution(row, arrivals.height_m);
}

std::string protection_columns() {
    return ",rocks,reached_bare,reached_forest,reached_both,protection_percent,protection_low_percent,"
           "protection_high_percent,bari_percent,miri_percent,orpi_percent";
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
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const RiskReduction known = reduction.value_or(RiskReduction{unknown, unknown, unknown});
    row.number<3>(known.bari_percent).number<3>(known.miri_percent).number<3>(known.orpi_percent);
}

std::string slope_columns() {
    return ",rocks,at_rest,caught,stopped_by_tree,stopped_by_log,left_terrain,gave_up,run_out_mean_m,run_out_"
           "50_m,run_out_"
           "90_m,"
           "run_out_95_m,run_out_98_m,run_out_99_m,run_out_max_m" +
           distribution_columns("max_speed", "mps") + distribution_columns("max_energy", "kj") +
           distribution_columns("max_height", "m") +
           ",mean_speed_mps,jump_height_mean_m,jumps_per_rock,ground_impacts_per_rock,tree_hits_per_rock,"
           "trees_broken_per_rock,tree_energy_per_rock_kj,hit_a_tree_percent,log_hits_per_rock,logs_broken_"
           "per_rock,"
           "log_energy_per_rock_kj";
}

void add_slope(CsvRow& row, const SlopeFigures& slope) {
    row.whole(slope.rocks);
    for (const Share& share : slope.by_reason) {
        row.whole(share.part);
    }
    const Distribution& run_out = slope.run_out_m;
    row.number<2>(run_out.mean).number<2>(run_out.p50).number<2>(run_out.p90).number<2>(run_out.p95);
    row.number<2>(run_out.p98).number<2>(run_out.p99).number<2>(run_out.max);
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
