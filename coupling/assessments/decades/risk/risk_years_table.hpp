#pragma once

#include <filesystem>

#include "coupling/assessments/decades/risk/risk_over_years.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

TableLayout risk_by_year_layout();

/// Writes tables/risk_by_year.csv: each exposed target and all together, in each year with rocks, with forest
/// and on the bare slope. Throws config::InputError (file).
WrittenFile write_risk_by_year(const std::filesystem::path& folder, const Names& names,
                               const RiskOverYears& risk);

}  // namespace coupling::decades
