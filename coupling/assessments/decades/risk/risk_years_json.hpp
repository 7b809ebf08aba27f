#pragma once

#include "coupling/assessments/decades/risk/risk_over_years.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::decades {

/// `risk` of summary.json: means of the years after the start, under each regime and on the bare slope, and
/// the present value of the money.
Json risk_years_json(const Names& names, const RiskOverYears& risk, double discount_percent);

/// Present value of the money at a place over the replicates of a course.
Band present_value_band(const RiskAtPlace& place, Cover cover, std::size_t course, double discount_percent);

}  // namespace coupling::decades
