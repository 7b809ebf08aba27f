#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupling/results/figures/drawn_figure.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling {

using rockfall::Cover;

/// Both slopes in the order in which results name them.
inline constexpr std::array<Cover, rockfall::covers> all_covers{Cover::forest, Cover::bare};
constexpr std::size_t index_of(Cover cover) {
    return static_cast<std::size_t>(cover);
}
/// "forest" or "bare": in file names and columns.
const char* name_of(Cover cover);

/// Over charts and maps: "with forest" or "bare slope", in the language of the page.
const std::string& title_of(Cover cover);
/// The slopes that were assessed: both, or the bare one alone.
std::vector<Cover> covers_of(const RunResults& results);

/// Stop reasons as tables name them: "at_rest", "caught", "tree", "log", "net", "left_terrain", "gave_up".
const char* name_of(rockfall::StopReason reason);

/// One quantity over rocks: NaN where there are none, percentiles also where fewer than one rock lies above.
struct Distribution {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double p50 = mean, p90 = mean, p95 = mean, p98 = mean, p99 = mean;
    double max = mean;
    Interval p95_interval{0.0, std::numeric_limits<double>::infinity()};
};

/// What arrives at a target on one slope.
struct ArrivalFigures {
    Share share;  ///< of all rocks that fell
    Distribution energy_kj;
    Distribution speed_mps;
    Distribution height_m;
    Distribution top_height_m;  ///< of the highest point
    /// Of all rocks that fell: from rockfall::counted_energies_j on where they first meet the target.
    std::array<Share, rockfall::counted_energies_j.size()> above;
};

/// A target on both slopes and what the forest does for it.
struct TargetFigures {
    std::string id;
    std::string name;
    bool is_area = false;
    std::array<ArrivalFigures, rockfall::covers> by_cover;
    PairedCounts paired;                         ///< without forest all counts are 0
    std::optional<ProtectionEffect> protection;  ///< nothing without forest or without arrivals
    std::optional<RiskReduction> reduction;

    [[nodiscard]] const ArrivalFigures& at(Cover cover) const { return by_cover[index_of(cover)]; }
};

/// All rocks on one slope.
struct SlopeFigures {
    std::uint64_t rocks = 0;
    std::array<Share, rockfall::stop_reasons> by_reason;
    Share stopped;           ///< of all rocks: came to rest on the terrain
    Distribution run_out_m;  ///< of those that stopped; percentiles straight inside bins of 10 m
    /// Lower bounds for all rocks: one that did not stop counts with the distance to where it was seen last.
    Distribution run_out_at_least_m;
    Distribution max_speed_mps;
    Distribution max_energy_kj;
    Distribution max_height_m;
    double mean_speed_mps = 0.0;      ///< mean over rocks of path / time
    double jump_height_mean_m = 0.0;  ///< mean over all jumps of their largest heights
    double jumps_per_rock = 0.0;
    double ground_impacts_per_rock = 0.0;
    double tree_hits_per_rock = 0.0;
    double trees_broken_per_rock = 0.0;
    double tree_energy_per_rock_kj = 0.0;
    Share hit_a_tree;
    double log_hits_per_rock = 0.0;
    double logs_broken_per_rock = 0.0;
    double log_energy_per_rock_kj = 0.0;
    double dissipated_per_rock_kj = 0.0;     ///< of models that keep a ledger of energy; 0: none is kept
    double ledger_residual = 0.0;            ///< what the ledgers miss by what was dissipated [-]
    double ledger_corrected = 0.0;           ///< work done where overlaps were taken out, likewise [-]
    std::uint64_t unsolved_percussions = 0;  ///< whose solver met its limit
};

/// All figures of a run, computed once for tables, summary and report.
struct Figures {
    std::vector<TargetFigures> targets;
    std::array<SlopeFigures, rockfall::covers> slopes;
    std::optional<DrawnFigures> drawn{};  ///< with what is not known; nothing where nothing was drawn

    [[nodiscard]] const SlopeFigures& at(Cover cover) const { return slopes[index_of(cover)]; }
};

Figures figures_of(const RunResults& results);
/// The same of single tallies. `rocks`: how many fell.
ArrivalFigures figures_of(const rockfall::ArrivalTally& tally, std::uint64_t rocks);
/// Rocks that reach the target on one slope, the other, or both. The tally's rocks on both slopes are counted
/// on each slope too.
PairedCounts paired_counts(const rockfall::TargetTally& tally);
SlopeFigures figures_of(const rockfall::RunTally& tally);

}  // namespace coupling
