#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "coupling/assessments/decades/decision/course_law.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"

namespace coupling::decades {

/// The years of a course at a target after the start, with those in which it may jump: years in which most
/// replicates are cut by plan, and of each replicate those in which it alone is cut or loses much of its wood
/// to an event; and with the variance that the rocks leave: binomial, of the rocks that arrive over the bare
/// slope in the year and the share of them that the replicate lets pass in the years around it.
CourseYears course_years(const Series& protection, std::size_t course, std::uint32_t target,
                         const Names& names, std::span<const MemberYears> members);

}  // namespace coupling::decades
