#pragma once

#include <span>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"

namespace coupling::decades {

/// What arrives at a target in a year of a course, summed over its replicates.
PairedCounts arrivals_of(const Names& names, std::span<const MemberYears> members, std::size_t course,
                         std::uint32_t target, std::int32_t year);

/// The rocks of a year at a target over the replicates of a course. Shares are those of all replicates
/// together, and so are the mean and the 95th percentile of energy; the interval of the percentile is that of
/// a single replicate, of several the range of their values.
struct YearAtTarget {
    std::int32_t year = 0;
    PairedCounts paired;
    ArrivalFigures forest;
    ArrivalFigures bare;
};
YearAtTarget at_target(const Names& names, std::span<const MemberYears> members, std::size_t course,
                       std::uint32_t target, std::int32_t year);

}  // namespace coupling::decades
