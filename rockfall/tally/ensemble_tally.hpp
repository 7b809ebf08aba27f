#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/tally/bin_counts.hpp"
#include "rockfall/tally/cell_tally.hpp"
#include "rockfall/tally/footprint.hpp"
#include "rockfall/tally/log_bins.hpp"
#include "rockfall/tally/target.hpp"
#include "rockfall/terrain/rim.hpp"

namespace rockfall {

/// The two slopes on which every rock falls: with its forest, lying logs included, and without either.
enum class Cover : std::uint8_t { forest, bare };
inline constexpr std::size_t covers = 2;

/// What arrived at a target on one slope.
struct ArrivalTally {
    std::uint64_t reached = 0;
    BinCounts energy{fine_energy_bins.count()};      ///< in fine_energy_bins
    BinCounts speed{fine_speed_bins.count()};        ///< in fine_speed_bins
    BinCounts height{fine_height_bins.count()};      ///< in fine_height_bins
    BinCounts top_height{fine_height_bins.count()};  ///< of the highest point, in fine_height_bins
    std::array<std::uint64_t, counted_energies_j.size()> above{};  ///< from counted_energies_j on
    double energy_max_j = 0.0;
    double speed_max_mps = 0.0;
    double height_max_m = 0.0;
    double top_height_max_m = 0.0;
    std::uint64_t energy_sum_j = 0;
    std::uint64_t speed_sum_mmps = 0;
    std::uint64_t height_sum_mm = 0;
    std::uint64_t top_height_sum_mm = 0;

    void add(const Arrival& arrival);
    void add(const ArrivalTally& other);
};

/// Arrivals at one target, counted on the same rocks with and without forest.
struct TargetTally {
    std::array<ArrivalTally, covers> by_cover;
    std::uint64_t reached_both = 0;

    void add(const TargetTally& other);
};

/// The rocks of an ensemble on one slope. Sums are whole numbers.
///
/// A run-out is known of rocks that came to rest. Of those that left the terrain or were given up it is known
/// that it is at least the distance to where they were seen last: they are counted apart, as open run-outs.
struct RunTally {
    static constexpr double run_out_bin_m = 10.0;
    static constexpr std::size_t run_out_bins = 500;  ///< the last takes everything further
    static constexpr std::size_t hit_bins = 41;       ///< 0, 1, ... 39, 40 and more tree hits

    std::uint64_t rocks = 0;
    std::array<std::uint64_t, stop_reasons> by_reason{};
    std::map<RimPart, std::uint64_t> left_over{};       ///< rocks that left the terrain, by part of its rim
    std::array<std::uint64_t, run_out_bins> run_out{};  ///< plan distance from release to where it rests
    std::array<std::uint64_t, run_out_bins>
        open_run_out{};  ///< to where a rock that did not stop was seen last
    std::array<std::uint64_t, hit_bins> tree_hits{};
    std::uint64_t run_out_sum_mm = 0;
    std::uint64_t open_run_out_sum_mm = 0;
    std::uint64_t max_speed_sum_mmps = 0;
    std::uint64_t mean_speed_sum_mmps = 0;
    std::uint64_t max_energy_sum_j = 0;
    std::uint64_t max_height_sum_mm = 0;
    std::uint64_t jump_height_sum_mm = 0;  ///< over all jumps of all rocks
    std::uint64_t jumps = 0;
    std::uint64_t ground_impacts = 0;
    std::uint64_t hits = 0;
    std::uint64_t trees_broken = 0;
    std::uint64_t tree_energy_sum_j = 0;
    std::uint64_t log_hits = 0;
    std::uint64_t logs_broken = 0;
    std::uint64_t log_energy_sum_j = 0;
    std::uint64_t dissipated_sum_j = 0;  ///< of models that keep a ledger of energy
    std::uint64_t residual_sum_mj = 0;   ///< sum of |what the ledger of a rock misses|, in thousandths of J
    std::uint64_t corrected_sum_mj = 0;  ///< sum of |work done where overlaps were taken out|
    std::uint64_t unsolved = 0;          ///< percussions whose solver met its limit
    double max_speed_mps = 0.0;
    double max_energy_j = 0.0;
    double max_height_m = 0.0;
    double max_run_out_m = 0.0;
    double max_open_run_out_m = 0.0;
    std::vector<std::uint64_t> max_speed;   ///< per-rock maxima in fine_speed_bins
    std::vector<std::uint64_t> max_energy;  ///< per-rock maxima in fine_energy_bins
    std::vector<std::uint64_t> max_height;  ///< per-rock maxima in fine_height_bins

    RunTally();
    void add(const RockRecord& record);
    void add(const RunTally& other);
    /// Rocks that came to rest.
    [[nodiscard]] std::uint64_t stopped() const;

private:
    void add_run_out(const RockRecord& record);
};

/// What one stem took.
struct StemTally {
    std::uint32_t hits = 0;
    std::uint32_t broken = 0;  ///< hits that would break it
    std::uint64_t energy_j = 0;

    void add(const StemTally& other) {
        hits += other.hits;
        broken += other.broken;
        energy_j += other.energy_j;
    }
};

/// What one log took.
struct LogTally {
    std::uint32_t hits = 0;
    std::uint32_t broken = 0;   ///< hits that would break it
    std::uint32_t resting = 0;  ///< rocks that rest upslope of it
    std::uint64_t energy_j = 0;

    void add(const LogTally& other) {
        hits += other.hits;
        broken += other.broken;
        resting += other.resting;
        energy_j += other.energy_j;
    }
};

/// Run-outs of the rocks of a stratum on one slope.
struct RunOutTally {
    std::uint64_t rocks = 0;
    std::uint64_t stopped = 0;
    std::uint64_t sum_mm = 0;                ///< of those that came to rest
    BinCounts bins{RunTally::run_out_bins};  ///< of those, in bins of RunTally::run_out_bin_m

    void add(const RockRecord& record);
    void add(const RunOutTally& other);
};

/// What is counted of the rocks of a stratum, which share one draw of what is not known.
struct StratumTally {
    std::array<RunOutTally, covers> run_outs;
    std::vector<TargetTally> targets;

    explicit StratumTally(std::size_t targets_in) : targets(targets_in) {}
    void add(const StratumTally& other);
};

/// Everything counted over an ensemble, in an order that does not matter.
struct EnsembleTally {
    std::array<CellTally, covers> cells;
    std::array<RunTally, covers> runs;
    std::vector<TargetTally> targets;
    std::vector<StemTally> stems;
    std::vector<LogTally> logs;
    std::vector<StratumTally> strata;  ///< where rocks are drawn by strata

    /// Without stems and logs there is no forest to count in: its grid stays empty.
    EnsembleTally(const config::GridFrame& frame, std::size_t targets_in, std::size_t stems_in,
                  std::size_t logs_in = 0);
    void add(const EnsembleTally& other);
};

}  // namespace rockfall
