#pragma once

#include <cstddef>
#include <string>

#include "coupling/assessments/consequences/risk_plan.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::consequences {

/// A rate as people in the field write it: "0.0187", and below a thousandth "1.2 · 10⁻⁵", whose first number
/// is from 1.0 to 9.9. Requires a rate of 0 or more.
std::string rate_text(double rate);

/// "12 300 CHF".
std::string amount_of(double amount, const RiskSettings& settings);

/// "the 3 exposed targets".
std::string targets_in_words(std::size_t targets);

/// "With forest" or "Bare slope".
const std::string& slope_in_words(Cover cover);

/// What targets.file says of a target.
std::string exposure_in_words(const TargetExposure& of, const RiskSettings& settings);

/// Fields of risk_curves_choice.html, risk_assumptions.html and risk_curves.html. `curves_file`: as results
/// name risk.curves.
report::PageFields assumption_fields(const RiskPlan& plan, const std::string& curves_file);

}  // namespace coupling::consequences
