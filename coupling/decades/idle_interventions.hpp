#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/decades/decade_tables.hpp"
#include "coupling/decades/records.hpp"

namespace coupling::decades {

/// A sentence for each regime with rows that never came due in any of its members, and one for each with rows
/// that came due and never found anything to do.
std::vector<std::string> idle_interventions(const Names& names, std::span<const MemberYears> members);

}  // namespace coupling::decades
