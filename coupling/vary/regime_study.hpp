#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/decades/comparison.hpp"
#include "coupling/vary/vary.hpp"

namespace coupling::vary {

/// A regime under one combination of settings, at a target in a climate.
struct RegimeOutcome {
    std::string regime;
    std::string climate;
    std::string target;
    double protection_percent = 0.0;  ///< mean over years with rocks after the start and over replicates
    std::size_t rank = 0;             ///< 1: the regime with the highest
    /// Protection minus that of the first regime, paired by replicate; nothing for the first regime.
    std::optional<decades::PairedDifference> difference{};
    bool changes_rank = false;  ///< before a regime that it is behind in the scenario, or the other way round
};

/// A run over years under one combination.
struct RegimeRun {
    Combination combination;
    std::string cheapest;  ///< regime that keeps what [decision] asks for at the least cost; empty: none, or
                           ///< undecided
    std::vector<RegimeOutcome> regimes;  ///< climate by climate, target by target, in the order of the list
};

/// What the members of a run say, without ranks of the scenario.
RegimeRun outcome_of(const Combination& combination, const decades::Names& names, const Site& site,
                     std::span<const decades::MemberYears> members, const Scenario& scenario);

/// Marks where two regimes have exchanged their order of the first run.
void mark_rank_changes(std::vector<RegimeRun>& runs);

/// The study of a scenario with run.years above 0: how the paired difference of its regimes moves with the
/// settings, and whether their ranking changes. Writes vary.csv and report.html as vary_scenario does.
int vary_regimes(const VaryRequest& request, const std::vector<Factor>& factors,
                 const std::vector<Combination>& combinations, std::ostream& screen);

/// The table of such a study.
void write_regime_table(std::ostream& out, const std::vector<Factor>& factors,
                        const std::vector<RegimeRun>& runs);

}  // namespace coupling::vary
