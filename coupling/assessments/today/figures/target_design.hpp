#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "coupling/assessments/nets/figures/barrier_design.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// The barrier that the rocks that arrive at a target ask for on one slope, right where they meet it.
struct TargetDesign {
    std::size_t target;
    rockfall::Cover cover;
    std::uint64_t reached = 0;
    std::optional<BarrierDesign> design;  ///< nothing: too few rocks; what it would hold is not counted
};

/// Of all targets on all slopes where design.rule asks for a design; none otherwise.
///
/// Energies are those of the tables of targets, heights those of the highest point of each rock above the
/// ground. Both percentiles come from fine bins, at most 0.4 % from the value.
std::vector<TargetDesign> target_designs(const RunResults& results);

/// target_design.csv; nothing without designs.
void write_target_designs(const RunResults& results, const std::filesystem::path& folder,
                          std::vector<WrittenFile>& written);
TableLayout target_design_layout();

}  // namespace coupling
