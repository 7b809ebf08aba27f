#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "coupling/assessments/decades/decision/worst_year.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"

namespace coupling::decades {

/// The years of a course at a target after the start, with those in which it may jump: years in which most
/// replicates are cut by plan, and of each replicate those in which it alone is cut or loses much of its wood
/// to an event. `variances`: of the rocks (rock_noise.hpp).
CourseYears course_years(const Series& protection, std::size_t course, const Names& names,
                         std::span<const MemberYears> members,
                         const std::map<std::int32_t, double>& variances);

}  // namespace coupling::decades
