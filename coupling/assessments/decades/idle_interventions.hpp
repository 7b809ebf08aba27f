#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"

namespace coupling::decades {

/// A sentence for each regime with rows that never came due in any of its members, and one for each with rows
/// that came due and never found anything to do.
std::vector<std::string> idle_interventions(const Names& names, std::span<const MemberYears> members);

/// A sentence for each recorded cut of which not all trees were felled that come to their turn within the
/// `years` of the run: they had died or were cut before.
std::vector<std::string> unfelled_trees(const Names& names, const Management& management,
                                        std::span<const MemberYears> members, std::int32_t years);

}  // namespace coupling::decades
