#pragma once

#include <string>

#include "coupling/assessments/decades/risk/risk_over_years.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::decades {

/// The section Risk of the page: what each regime costs at the exposed targets, a chart over the years, and
/// what it assumes. `curves_file`: as results name risk.curves. HTML; empty without a year after the start.
std::string risk_over_years_html(const Names& names, const Site& site, const RiskOverYears& risk,
                                 const std::string& curves_file);

}  // namespace coupling::decades
