#pragma once

#include <ostream>
#include <vector>

#include "coupling/assessments/vary/study/outcomes.hpp"
#include "coupling/assessments/vary/study/regime_outcomes.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::vary {

/// vary.csv: a row a combination and target; a column a factor, empty where it is as in the scenario.
void write_table(std::ostream& out, const std::vector<Factor>& factors, const std::vector<Outcome>& outcomes);
/// The same of a study over years: a row a combination, climate, target and regime.
void write_regime_table(std::ostream& out, const std::vector<Factor>& factors,
                        const std::vector<RegimeRun>& runs);

/// What these write; both without the columns of factors.
std::vector<TableLayout> target_layouts(const std::vector<Factor>& factors);
std::vector<TableLayout> regime_layouts(const std::vector<Factor>& factors);
const std::vector<TableLayout>& vary_layouts();

}  // namespace coupling::vary
