#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/decades/decision/course_law.hpp"
#include "coupling/assessments/decades/decision/worst_year.hpp"
#include "coupling/assessments/decades/tables/band.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/inputs/scenario/decision_settings.hpp"

namespace coupling::decades {

/// What the drawn courses of a replicate (course_law.hpp) say of a year with rocks after the start. Sums over
/// the years are those of the replicate, and their means over replicates those of the course.
struct ForestYear {
    std::int32_t year = 0;
    double stands_for_years = 0.0;  ///< those since the year with rocks before
    double beyond_years = 0.0;      ///< decision.years_beyond of the last year, else 0
    double protection_percent = 0.0;
    double p_below = 0.0;          ///< the probability that it is below what is asked for
    double missing_percent = 0.0;  ///< what is missing to that on average, 0 where nothing is
};

/// What one replicate of a course says of a target, without the noise of its rocks.
struct ProtectionRecord {
    std::vector<ForestYear> years{};
    double weight = 1.0;  ///< in the mean of a year over replicates (Series::weights)
    /// Each year with rocks stands for those since the one before.
    [[nodiscard]] double years_below() const;
    /// Sum over years of what is missing; the last one stands for decision.years_beyond more: who leaves an
    /// open slope behind has not kept it.
    [[nodiscard]] double percent_years_lost() const;
};

/// Protection of a course at a target without the noise of its rocks. All figures come from the same drawn
/// courses, so that none says otherwise than another.
struct DrawnProtection {
    std::vector<std::optional<ProtectionRecord>> records{};  ///< [replicate]; nothing where no year is known
    std::optional<WorstYear> worst{};  ///< that all years keep what is asked for; nothing without a record
    Band years_below{};                ///< means over replicates; NaN without a record
    Band percent_years_lost{};
    /// The year with the lowest mean over replicates, each counted by the rocks that arrive over the bare
    /// slope (Series::weights).
    std::optional<Extreme> lowest{};
};

/// `weights`: of each replicate in the mean of a year; empty: all count the same. `rock_years`: those with
/// rocks, rising.
DrawnProtection drawn_protection(const CourseYears& course, std::span<const double> weights,
                                 const DecisionSettings& settings, std::span<const std::int32_t> rock_years);

}  // namespace coupling::decades
