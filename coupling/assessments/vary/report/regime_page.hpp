#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/vary/study/regime_outcomes.hpp"

namespace coupling::vary::report {

/// The page of a study of regimes: for each regime, climate and target a tornado chart of its paired
/// difference to the first regime, with what changes the ranking, and a table of all runs.
void write_regime_page(std::ostream& out, const std::string& scenario, const std::vector<Factor>& factors,
                       const std::vector<RegimeRun>& runs);

}  // namespace coupling::vary::report
