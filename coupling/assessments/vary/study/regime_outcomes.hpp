#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/assessments/vary/study/plan.hpp"

namespace coupling::vary {

/// A regime under one combination of settings, at a target in a climate.
struct RegimeOutcome {
    std::string regime;
    std::string climate;
    std::string target;
    double protection_percent = 0.0;     ///< mean over years with rocks after the start and over replicates
    std::vector<double> by_replicate{};  ///< the same of each replicate; NaN: no year is known
    std::size_t rank = 0;                ///< 1: the regime with the highest
    /// Protection minus that of the first regime, paired by replicate; nothing for the first regime.
    std::optional<decades::PairedDifference> difference{};
    /// Before a regime that it is behind in the scenario, or the other way round, both beyond chance.
    bool changes_rank = false;
};

/// A run over years under one combination.
struct RegimeRun {
    Combination combination;
    std::string cheapest;  ///< regime that keeps what [decision] asks for at the least cost; empty: none, or
                           ///< undecided
    std::vector<RegimeOutcome> regimes;  ///< climate by climate, target by target, in the order of the list
};

}  // namespace coupling::vary
