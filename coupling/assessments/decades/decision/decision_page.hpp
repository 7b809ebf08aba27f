#pragma once

#include <span>
#include <string>

#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/decision/decision_risk.hpp"

namespace coupling::decades {

/// Verdict, table of all regimes and climates, `charts` of their protection, and the risk of each course
/// where it is assessed, as HTML: the first part of the page.
std::string decision_html(const Names& names, const Decision& decision, const std::string& charts,
                          std::span<const CourseRisk> risks = {});

}  // namespace coupling::decades
