#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/vary/study/outcomes.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::vary::report {

/// The page of a study: for each target a tornado chart of the settings that were moved alone, and a table
/// of all combinations.
void write_page(std::ostream& out, const Scenario& scenario, const std::vector<Factor>& factors,
                const std::vector<Outcome>& outcomes);

/// The settings that a combination changes: rows of run_settings.html.
std::vector<coupling::report::PageFields> rows_of_settings(const std::vector<Factor>& factors,
                                                           const Combination& combination);

}  // namespace coupling::vary::report
