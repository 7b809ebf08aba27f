#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/vary/study/outcomes.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::vary::report {

/// The page of a study: for each target a tornado chart of the settings that were moved alone, and a table
/// of all combinations.
void write_page(std::ostream& out, const Scenario& scenario, const std::vector<Factor>& factors,
                const std::vector<Outcome>& outcomes);

}  // namespace coupling::vary::report
