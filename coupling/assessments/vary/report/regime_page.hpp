#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/vary/report/tornado.hpp"
#include "coupling/assessments/vary/study/regime_outcomes.hpp"

namespace coupling::vary::report {

/// The page of a study of regimes: for each regime, climate and target a tornado chart of its paired
/// difference to the first regime, with what changes the ranking, and a table of all runs.
void write_regime_page(std::ostream& out, const std::string& scenario, const std::vector<Factor>& factors,
                       const std::vector<RegimeRun>& runs);

/// The settings that move the difference of a regime (place in RegimeRun::regimes), the widest first;
/// shares, as a tornado chart wants them.
std::vector<Sway> sways_of_regime(const std::vector<Factor>& factors, const std::vector<RegimeRun>& runs,
                                  std::size_t regime);

}  // namespace coupling::vary::report
