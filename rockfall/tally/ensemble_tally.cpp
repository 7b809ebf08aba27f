#include "rockfall/tally/ensemble_tally.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall {
namespace {

std::uint64_t whole(double value) {
    return static_cast<std::uint64_t>(std::llround(value));
}
std::uint64_t thousandths(double value) {
    return whole(1000.0 * value);
}

void add_counts(std::vector<std::uint64_t>& mine, const std::vector<std::uint64_t>& other) {
    for (std::size_t i = 0; i < mine.size(); ++i) {
        mine[i] += other[i];
    }
}

template <std::size_t N>
void add_counts(std::array<std::uint64_t, N>& mine, const std::array<std::uint64_t, N>& other) {
    for (std::size_t i = 0; i < N; ++i) {
        mine[i] += other[i];
    }
}

}  // namespace

void ArrivalTally::add(const Arrival& arrival) {
    if (!arrival.reached) {
        return;
    }
    ++reached;
    energy.add(fine_energy_bins.bin_of(arrival.energy_j));
    speed.add(fine_speed_bins.bin_of(arrival.speed_mps));
    height.add(fine_height_bins.bin_of(arrival.height_m));
    top_height.add(fine_height_bins.bin_of(arrival.top_height_m));
    for (std::size_t i = 0; i < above.size(); ++i) {
        above[i] += arrival.energy_j >= counted_energies_j[i] ? 1U : 0U;
    }
    energy_max_j = std::max(energy_max_j, static_cast<double>(arrival.energy_j));
    speed_max_mps = std::max(speed_max_mps, static_cast<double>(arrival.speed_mps));
    height_max_m = std::max(height_max_m, static_cast<double>(arrival.height_m));
    top_height_max_m = std::max(top_height_max_m, static_cast<double>(arrival.top_height_m));
    energy_sum_j += whole(static_cast<double>(arrival.energy_j));
    speed_sum_mmps += thousandths(static_cast<double>(arrival.speed_mps));
    height_sum_mm += thousandths(static_cast<double>(arrival.height_m));
    top_height_sum_mm += thousandths(static_cast<double>(arrival.top_height_m));
}

void ArrivalTally::add(const ArrivalTally& other) {
    reached += other.reached;
    energy.add(other.energy);
    speed.add(other.speed);
    height.add(other.height);
    top_height.add(other.top_height);
    add_counts(above, other.above);
    energy_max_j = std::max(energy_max_j, other.energy_max_j);
    speed_max_mps = std::max(speed_max_mps, other.speed_max_mps);
    height_max_m = std::max(height_max_m, other.height_max_m);
    top_height_max_m = std::max(top_height_max_m, other.top_height_max_m);
    energy_sum_j += other.energy_sum_j;
    speed_sum_mmps += other.speed_sum_mmps;
    height_sum_mm += other.height_sum_mm;
    top_height_sum_mm += other.top_height_sum_mm;
}

void TargetTally::add(const TargetTally& other) {
    for (std::size_t c = 0; c < covers; ++c) {
        by_cover[c].add(other.by_cover[c]);
    }
    reached_both += other.reached_both;
}

RunTally::RunTally()
    : max_speed(fine_speed_bins.count()),
      max_energy(fine_energy_bins.count()),
      max_height(fine_height_bins.count()) {}

void RunTally::add(const RockRecord& record) {
    ++rocks;
    ++by_reason[static_cast<std::size_t>(record.reason)];
    add_run_out(record);
    ++tree_hits[std::min<std::size_t>(record.tree_hits, hit_bins - 1)];
    max_speed_sum_mmps += thousandths(record.max_speed_mps);
    mean_speed_sum_mmps += thousandths(record.mean_speed_mps());
    max_energy_sum_j += whole(record.max_energy_j);
    max_height_sum_mm += thousandths(record.max_height_m);
    jump_height_sum_mm += thousandths(record.jump_height_sum_m);
    jumps += record.jumps;
    ground_impacts += record.ground_impacts;
    hits += record.tree_hits;
    trees_broken += record.trees_broken;
    tree_energy_sum_j += whole(record.tree_energy_j);
    log_hits += record.log_hits;
    logs_broken += record.logs_broken;
    log_energy_sum_j += whole(record.log_energy_j);
    dissipated_sum_j += whole(std::max(0.0, record.dissipated_j));
    residual_sum_mj += thousandths(std::abs(record.residual_j));
    corrected_sum_mj += thousandths(std::abs(record.corrected_j));
    unsolved += record.unsolved;
    max_speed_mps = std::max(max_speed_mps, record.max_speed_mps);
    max_energy_j = std::max(max_energy_j, record.max_energy_j);
    max_height_m = std::max(max_height_m, record.max_height_m);
    ++max_speed[fine_speed_bins.bin_of(static_cast<float>(record.max_speed_mps))];
    ++max_energy[fine_energy_bins.bin_of(static_cast<float>(record.max_energy_j))];
    ++max_height[fine_height_bins.bin_of(static_cast<float>(record.max_height_m))];
}

void RunTally::add_run_out(const RockRecord& record) {
    const double run_out_m = record.run_out_m();
    const std::size_t bin = std::min(static_cast<std::size_t>(run_out_m / run_out_bin_m), run_out_bins - 1);
    if (came_to_rest(record.reason)) {
        ++run_out[bin];
        run_out_sum_mm += thousandths(run_out_m);
        max_run_out_m = std::max(max_run_out_m, run_out_m);
        return;
    }
    ++open_run_out[bin];
    open_run_out_sum_mm += thousandths(run_out_m);
    max_open_run_out_m = std::max(max_open_run_out_m, run_out_m);
    if (record.reason == StopReason::left_terrain) {
        ++left_over[record.left_over];
    }
}

std::uint64_t RunTally::stopped() const {
    std::uint64_t sum = 0;
    for (std::size_t reason = 0; reason < stop_reasons; ++reason) {
        sum += came_to_rest(static_cast<StopReason>(reason)) ? by_reason[reason] : 0;
    }
    return sum;
}

void RunTally::add(const RunTally& other) {
    rocks += other.rocks;
    add_counts(by_reason, other.by_reason);
    for (const auto& [part, count] : other.left_over) {
        left_over[part] += count;
    }
    add_counts(run_out, other.run_out);
    add_counts(open_run_out, other.open_run_out);
    add_counts(tree_hits, other.tree_hits);
    run_out_sum_mm += other.run_out_sum_mm;
    open_run_out_sum_mm += other.open_run_out_sum_mm;
    max_speed_sum_mmps += other.max_speed_sum_mmps;
    mean_speed_sum_mmps += other.mean_speed_sum_mmps;
    max_energy_sum_j += other.max_energy_sum_j;
    max_height_sum_mm += other.max_height_sum_mm;
    jump_height_sum_mm += other.jump_height_sum_mm;
    jumps += other.jumps;
    ground_impacts += other.ground_impacts;
    hits += other.hits;
    trees_broken += other.trees_broken;
    tree_energy_sum_j += other.tree_energy_sum_j;
    log_hits += other.log_hits;
    logs_broken += other.logs_broken;
    log_energy_sum_j += other.log_energy_sum_j;
    dissipated_sum_j += other.dissipated_sum_j;
    residual_sum_mj += other.residual_sum_mj;
    corrected_sum_mj += other.corrected_sum_mj;
    unsolved += other.unsolved;
    max_speed_mps = std::max(max_speed_mps, other.max_speed_mps);
    max_energy_j = std::max(max_energy_j, other.max_energy_j);
    max_height_m = std::max(max_height_m, other.max_height_m);
    max_run_out_m = std::max(max_run_out_m, other.max_run_out_m);
    max_open_run_out_m = std::max(max_open_run_out_m, other.max_open_run_out_m);
    add_counts(max_speed, other.max_speed);
    add_counts(max_energy, other.max_energy);
    add_counts(max_height, other.max_height);
}

void RunOutTally::add(const RockRecord& record) {
    ++rocks;
    if (came_to_rest(record.reason)) {
        const double run_out_m = record.run_out_m();
        ++stopped;
        sum_mm += thousandths(run_out_m);
        bins.add(std::min(static_cast<std::size_t>(run_out_m / RunTally::run_out_bin_m),
                          RunTally::run_out_bins - 1));
    }
}

void RunOutTally::add(const RunOutTally& other) {
    rocks += other.rocks;
    stopped += other.stopped;
    sum_mm += other.sum_mm;
    bins.add(other.bins);
}

void StratumTally::add(const StratumTally& other) {
    for (std::size_t c = 0; c < covers; ++c) {
        run_outs[c].add(other.run_outs[c]);
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        targets[i].add(other.targets[i]);
    }
}

EnsembleTally::EnsembleTally(const config::GridFrame& frame, std::size_t targets_in, std::size_t stems_in,
                             std::size_t logs_in)
    : cells{CellTally{stems_in + logs_in > 0 ? frame : config::GridFrame{}}, CellTally{frame}},
      targets(targets_in),
      stems(stems_in),
      logs(logs_in) {}

void EnsembleTally::add(const EnsembleTally& other) {
    for (std::size_t c = 0; c < covers; ++c) {
        cells[c].add(other.cells[c]);
        runs[c].add(other.runs[c]);
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        targets[i].add(other.targets[i]);
    }
    for (std::size_t i = 0; i < stems.size(); ++i) {
        stems[i].add(other.stems[i]);
    }
    for (std::size_t i = 0; i < logs.size(); ++i) {
        logs[i].add(other.logs[i]);
    }
    strata.resize(std::max(strata.size(), other.strata.size()), StratumTally{targets.size()});
    for (std::size_t i = 0; i < other.strata.size(); ++i) {
        strata[i].add(other.strata[i]);
    }
}

}  // namespace rockfall
