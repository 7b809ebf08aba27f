#pragma once

#include <filesystem>
#include <vector>

#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/decision/decision_risk.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

std::vector<TableLayout> decision_layouts();

/// Writes tables/decision.csv (a course at a target), decision_by_year.csv (the same in a year) and
/// decision_courses.csv (its replicates, too). Throws config::InputError (file). `risks`: by course; none
/// without risk.assess.
std::vector<WrittenFile> write_decision(const std::filesystem::path& folder, const Names& names,
                                        const Decision& decision, std::span<const Series> series,
                                        std::span<const CourseRisk> risks = {});

/// "yes", "no", "undecided".
const char* word_of(Keeps keeps);

/// What keeping one percent-year more costs against the reference: present value given up over percent-years
/// gained. Nothing where the gain is not known to differ from 0 (95 %).
std::optional<double> cost_of_a_percent_year(const CourseAtTarget& at, const CourseAtTarget& reference,
                                             const CourseMoney& money, const CourseMoney& reference_money);

}  // namespace coupling::decades
