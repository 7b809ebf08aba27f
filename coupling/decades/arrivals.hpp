#pragma once

#include <span>

#include "coupling/decades/decade_tables.hpp"
#include "coupling/decades/records.hpp"

namespace coupling::decades {

/// What arrives at a target in a year of a course, summed over its replicates.
PairedCounts arrivals_of(const Names& names, std::span<const MemberYears> members, std::size_t course,
                         std::uint32_t target, std::int32_t year);

}  // namespace coupling::decades
