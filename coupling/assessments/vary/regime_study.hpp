#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/vary/study/regime_outcomes.hpp"
#include "coupling/assessments/vary/vary.hpp"

namespace coupling::vary {

/// What the members of a run say, without ranks of the scenario.
RegimeRun outcome_of(const Combination& combination, const decades::Names& names, const Site& site,
                     std::span<const decades::MemberYears> members, const Scenario& scenario);

/// Marks where two regimes have exchanged their order of the first run.
void mark_rank_changes(std::vector<RegimeRun>& runs);

/// The study of a scenario with run.years above 0: how the paired difference of its regimes moves with the
/// settings, and whether their ranking changes. Writes vary.csv and report.html as vary_scenario does.
int vary_regimes(const VaryRequest& request, const std::vector<Factor>& factors,
                 const std::vector<Combination>& combinations, std::ostream& screen);

}  // namespace coupling::vary
