#pragma once

#include <ostream>
#include <vector>

#include "coupling/assessments/vary/study/outcomes.hpp"

namespace coupling::vary {

/// vary.csv: a row a combination and target; a column a factor, empty where it is as in the scenario.
void write_table(std::ostream& out, const std::vector<Factor>& factors, const std::vector<Outcome>& outcomes);

}  // namespace coupling::vary
