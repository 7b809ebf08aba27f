#include "coupling/results/figures/fall_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "rockfall/motion/fall.hpp"

namespace coupling {

rockfall::FallFigures fall_figures_of(const SlopeFigures& slope) {
    constexpr auto left = static_cast<std::size_t>(rockfall::StopReason::left_terrain);
    return {slope.max_speed_mps.max, slope.by_reason[left].value};
}

bool met_no_tree(const rockfall::RunTally& slope) {
    return slope.hits == 0 && slope.log_hits == 0;
}

std::optional<ProtectionEffect> protection_at(const rockfall::EnsembleTally& run, std::size_t target) {
    constexpr auto forest = static_cast<std::size_t>(rockfall::Cover::forest);
    const PairedCounts paired = paired_counts(run.targets.at(target));
    const bool is_one_slope =
        met_no_tree(run.runs[forest]) && paired.only_forest == 0 && paired.only_bare == 0;
    if (!is_one_slope || paired.bare() == 0) {
        return protection_effect(paired);
    }
    const auto rocks = static_cast<double>(run.runs[forest].rocks);
    const double most_that_meet_one = 1.0 - std::pow(0.025, 1.0 / rocks);
    const double most = std::min(1.0, most_that_meet_one * rocks / static_cast<double>(paired.bare()));
    return ProtectionEffect{0.0, {-most, most}, false};
}

void warn_of_falls(const rockfall::MotionLaws& laws, const rockfall::FallFigures& falls,
                   config::Warnings& warnings) {
    for (std::string& sentence : rockfall::doubts_of_falls(laws, falls)) {
        warnings.add(std::move(sentence), config::Effect::answer);
    }
}

}  // namespace coupling
