#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/judged_cuts.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"

namespace coupling::decades {

/// Years in which members of a regime cut by its plan and which are not judged, rising. Salvage and tending
/// are no cuts.
std::vector<std::int32_t> unjudged_cuts(const Names& names, std::span<const MemberYears> members,
                                        std::size_t regime, std::span<const std::int32_t> rock_years);

/// "2, 12, 22, …".
std::string years_in_words(const std::vector<std::int32_t>& years);

}  // namespace coupling::decades
