#pragma once

#include <optional>
#include <span>
#include <string>

#include "coupling/assessments/decades/tables/comparison.hpp"

namespace coupling::decades {

/// A sentence where the start holds no dead wood and logs of later years stop rocks: then part of the rise of
/// protection is that of the start. Nothing where the share of rocks stopped by logs rises by less than two
/// percent points in every course [choice].
std::optional<std::string> missing_dead_wood(const Names& names, std::span<const Series> series,
                                             std::span<const MemberYears> members);

}  // namespace coupling::decades
