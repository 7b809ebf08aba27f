#pragma once

#include <cstdint>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"

namespace coupling::decades {

/// Adds the figures of a year's rocks to what a member keeps.
void record_falls(const exchange::YearFalls& falls, std::int32_t year, MemberYears& kept);
/// Adds what they left in the cells of the map.
void record_cells(const exchange::YearFalls& falls, std::int32_t year, MemberYears& kept);
/// Adds the paths that were kept.
void record_paths(const exchange::YearFalls& falls, std::int32_t year, MemberYears& kept);

}  // namespace coupling::decades
