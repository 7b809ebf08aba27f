#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/risk/risk_over_years.hpp"
#include "coupling/results/tables/table_of.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::decades {

/// What a course costs at all exposed targets, beside what its work and stock bring. Present values are per
/// hectare of forest, of the years after the start, discounted as those of the work.
struct CourseRisk {
    std::size_t course = 0;
    std::string currency{};
    Band money_a_year{};  ///< mean of the years after the start, of the whole slope
    Band present_value_pha{};
    std::optional<PairedDifference> difference_pha{};  ///< from the first regime; below 0: spared by this one
    /// Present value of work and stock less that of the risk; nothing in another currency than theirs.
    std::optional<Band> value_less_risk_eur_pha{};
    std::optional<PairedDifference> value_less_risk_difference_eur_pha{};
};

/// By course. Requires an area above 0.
std::vector<CourseRisk> risks_of_courses(const Names& names, const Decision& decision,
                                         const RiskOverYears& risk, double area_ha);

/// Columns of decision.csv; empty where there is no risk.
ColumnsOf<CourseRisk> course_risk_columns();

/// Fields of decision_risk.html.
report::PageFields course_risk_fields(const Names& names, const Decision& decision,
                                      std::span<const CourseRisk> risks);

}  // namespace coupling::decades
