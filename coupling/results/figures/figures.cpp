#include "coupling/results/figures/figures.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>

#include "config/units/constants.hpp"
#include "coupling/results/figures/drawn_figures.hpp"
#include "coupling/results/figures/fall_doubts.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {
namespace {

using config::j_per_kj;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

double mean_of(std::uint64_t sum, std::uint64_t count, double unit) {
    return count == 0 ? no_number : static_cast<double>(sum) / static_cast<double>(count) / unit;
}

Interval in_unit(const Interval& interval, double unit) {
    return {interval.low / unit, interval.high / unit};
}

/// `unit`: how many of the counted units make one of the reported ones.
Distribution distribution(const rockfall::LogBins& bins,
                          const std::vector<rockfall::BinCounts::Filled>& filled, double mean, double largest,
                          double unit) {
    Distribution found;
    const QuantileEstimate p95 = quantile_estimate(bins, filled, 0.95, largest);
    if (std::isnan(p95.value)) {
        return found;
    }
    const std::uint64_t total = sum_of(filled);
    const auto quantile = [&](std::uint64_t percentile) {
        return percentile_is_known(total, percentile)
                   ? std::min(quantile_of(bins, filled, static_cast<double>(percentile) / 100.0), largest) /
                         unit
                   : no_number;
    };
    found.mean = mean;
    found.p50 = quantile(50);
    found.p90 = quantile(90);
    found.p98 = quantile(98);
    found.p99 = quantile(99);
    found.max = largest / unit;
    if (percentile_is_known(total, 95)) {
        found.p95 = p95.value / unit;
        found.p95_interval = in_unit(p95.interval, unit);
    }
    return found;
}

constexpr double per_milli = 1000.0;

TargetFigures target_figures(const RunResults& results, std::size_t number) {
    const rockfall::Target& target = results.site.targets[number];
    const rockfall::TargetTally& tally = results.tally.targets[number];
    TargetFigures figures;
    figures.id = target.id;
    figures.name = target.name;
    figures.is_area = target.is_area;
    for (const Cover cover : covers_of(results)) {
        figures.by_cover[index_of(cover)] =
            coupling::figures_of(tally.by_cover[index_of(cover)], results.tally.runs[index_of(cover)].rocks);
    }
    if (results.with_forest) {
        figures.paired = paired_counts(tally);
        figures.protection = protection_at(results.tally, number);
        figures.reduction = risk_reduction(figures.paired, figures.at(Cover::forest).energy_kj.p95,
                                           figures.at(Cover::bare).energy_kj.p95);
    }
    return figures;
}

/// Rocks by run-out in bins of 10 m.
struct RunOuts {
    std::array<std::uint64_t, rockfall::RunTally::run_out_bins> bins{};
    std::uint64_t sum_mm = 0;
    double max_m = 0.0;
};

/// Quantile of the run-out, straight inside its bin of 10 m.
double run_out_quantile(const RunOuts& of, std::uint64_t rocks, double share) {
    constexpr double bin_m = rockfall::RunTally::run_out_bin_m;
    const double wanted = share * static_cast<double>(rocks);
    double below = 0.0;
    for (std::size_t bin = 0; bin < of.bins.size(); ++bin) {
        const auto here = static_cast<double>(of.bins[bin]);
        if (here > 0.0 && below + here >= wanted) {
            return std::min((static_cast<double>(bin) + (wanted - below) / here) * bin_m, of.max_m);
        }
        below += here;
    }
    return no_number;
}

Distribution distribution_of(const RunOuts& of) {
    Distribution found;
    const std::uint64_t rocks = std::accumulate(of.bins.begin(), of.bins.end(), std::uint64_t{0});
    if (rocks == 0) {
        return found;
    }
    found.mean = mean_of(of.sum_mm, rocks, per_milli);
    const auto quantile = [&](std::uint64_t percentile) {
        return percentile_is_known(rocks, percentile)
                   ? run_out_quantile(of, rocks, static_cast<double>(percentile) / 100.0)
                   : no_number;
    };
    found.p50 = quantile(50);
    found.p90 = quantile(90);
    found.p95 = quantile(95);
    found.p98 = quantile(98);
    found.p99 = quantile(99);
    found.max = of.max_m;
    return found;
}

/// Of the rocks that came to rest.
Distribution run_out(const rockfall::RunTally& tally) {
    return distribution_of({tally.run_out, tally.run_out_sum_mm, tally.max_run_out_m});
}

/// Of all rocks: the run-out of one that did not come to rest is at least the distance to where it was seen.
Distribution run_out_at_least(const rockfall::RunTally& tally) {
    RunOuts all{tally.run_out, tally.run_out_sum_mm + tally.open_run_out_sum_mm,
                std::max(tally.max_run_out_m, tally.max_open_run_out_m)};
    for (std::size_t bin = 0; bin < all.bins.size(); ++bin) {
        all.bins[bin] += tally.open_run_out[bin];
    }
    return distribution_of(all);
}

}  // namespace

const char* name_of(Cover cover) {
    return cover == Cover::forest ? "forest" : "bare";
}

std::vector<Cover> covers_of(const RunResults& results) {
    return results.with_forest ? std::vector<Cover>{Cover::forest, Cover::bare}
                               : std::vector<Cover>{Cover::bare};
}

const std::string& title_of(Cover cover) {
    return report::page_text(cover == Cover::forest ? "with forest" : "bare slope");
}

const char* name_of(rockfall::StopReason reason) {
    switch (reason) {
        case rockfall::StopReason::at_rest:
            return "at_rest";
        case rockfall::StopReason::caught:
            return "caught";
        case rockfall::StopReason::tree:
            return "tree";
        case rockfall::StopReason::log:
            return "log";
        case rockfall::StopReason::net:
            return "net";
        case rockfall::StopReason::left_terrain:
            return "left_terrain";
        case rockfall::StopReason::gave_up:
            break;
    }
    return "gave_up";
}

PairedCounts paired_counts(const rockfall::TargetTally& tally) {
    const std::uint64_t forest = tally.by_cover[index_of(Cover::forest)].reached;
    const std::uint64_t bare = tally.by_cover[index_of(Cover::bare)].reached;
    assert(tally.reached_both <= forest && tally.reached_both <= bare);
    return {tally.reached_both, forest - tally.reached_both, bare - tally.reached_both};
}

ArrivalFigures figures_of(const rockfall::ArrivalTally& tally, std::uint64_t rocks) {
    ArrivalFigures figures;
    figures.share = share_of(tally.reached, rocks);
    figures.energy_kj =
        distribution(rockfall::fine_energy_bins, tally.energy.filled(),
                     mean_of(tally.energy_sum_j, tally.reached, j_per_kj), tally.energy_max_j, j_per_kj);
    figures.speed_mps =
        distribution(rockfall::fine_speed_bins, tally.speed.filled(),
                     mean_of(tally.speed_sum_mmps, tally.reached, per_milli), tally.speed_max_mps, 1.0);
    figures.height_m =
        distribution(rockfall::fine_height_bins, tally.height.filled(),
                     mean_of(tally.height_sum_mm, tally.reached, per_milli), tally.height_max_m, 1.0);
    figures.top_height_m =
        distribution(rockfall::fine_height_bins, tally.top_height.filled(),
                     mean_of(tally.top_height_sum_mm, tally.reached, per_milli), tally.top_height_max_m, 1.0);
    for (std::size_t i = 0; i < figures.above.size(); ++i) {
        figures.above[i] = share_of(tally.above[i], rocks);
    }
    return figures;
}

SlopeFigures figures_of(const rockfall::RunTally& tally) {
    SlopeFigures figures;
    const std::uint64_t rocks = tally.rocks;
    figures.rocks = rocks;
    for (std::size_t reason = 0; reason < rockfall::stop_reasons; ++reason) {
        figures.by_reason[reason] = share_of(tally.by_reason[reason], rocks);
    }
    figures.stopped = share_of(tally.stopped(), rocks);
    figures.run_out_m = run_out(tally);
    figures.run_out_at_least_m = run_out_at_least(tally);
    figures.max_speed_mps =
        distribution(rockfall::fine_speed_bins, filled_bins(tally.max_speed),
                     mean_of(tally.max_speed_sum_mmps, rocks, per_milli), tally.max_speed_mps, 1.0);
    figures.max_energy_kj =
        distribution(rockfall::fine_energy_bins, filled_bins(tally.max_energy),
                     mean_of(tally.max_energy_sum_j, rocks, j_per_kj), tally.max_energy_j, j_per_kj);
    figures.max_height_m =
        distribution(rockfall::fine_height_bins, filled_bins(tally.max_height),
                     mean_of(tally.max_height_sum_mm, rocks, per_milli), tally.max_height_m, 1.0);
    figures.mean_speed_mps = mean_of(tally.mean_speed_sum_mmps, rocks, per_milli);
    figures.jump_height_mean_m = mean_of(tally.jump_height_sum_mm, tally.jumps, per_milli);
    figures.jumps_per_rock = mean_of(tally.jumps, rocks, 1.0);
    figures.ground_impacts_per_rock = mean_of(tally.ground_impacts, rocks, 1.0);
    figures.tree_hits_per_rock = mean_of(tally.hits, rocks, 1.0);
    figures.trees_broken_per_rock = mean_of(tally.trees_broken, rocks, 1.0);
    figures.tree_energy_per_rock_kj = mean_of(tally.tree_energy_sum_j, rocks, j_per_kj);
    figures.hit_a_tree = share_of(rocks - std::min(rocks, tally.tree_hits[0]), rocks);
    figures.log_hits_per_rock = mean_of(tally.log_hits, rocks, 1.0);
    figures.logs_broken_per_rock = mean_of(tally.logs_broken, rocks, 1.0);
    figures.log_energy_per_rock_kj = mean_of(tally.log_energy_sum_j, rocks, j_per_kj);
    if (tally.dissipated_sum_j > 0) {
        constexpr double mj_per_j = 1000.0;
        figures.dissipated_per_rock_kj = mean_of(tally.dissipated_sum_j, rocks, j_per_kj);
        figures.ledger_residual = static_cast<double>(tally.residual_sum_mj) / mj_per_j /
                                  static_cast<double>(tally.dissipated_sum_j);
        figures.ledger_corrected = static_cast<double>(tally.corrected_sum_mj) / mj_per_j /
                                   static_cast<double>(tally.dissipated_sum_j);
        figures.unsolved_percussions = tally.unsolved;
    }
    return figures;
}

Figures figures_of(const RunResults& results) {
    Figures figures;
    for (std::size_t target = 0; target < results.site.targets.size(); ++target) {
        figures.targets.push_back(target_figures(results, target));
    }
    for (const Cover cover : covers_of(results)) {
        figures.slopes[index_of(cover)] = figures_of(results.tally.runs[index_of(cover)]);
    }
    figures.drawn = drawn_figures(results, figures);
    return figures;
}

}  // namespace coupling
