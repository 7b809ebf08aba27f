#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::decades {

/// The lowest year of a course at a target, by its id; nothing where none is known.
using LowestYears = std::function<std::optional<Extreme>(std::size_t course, const std::string& target)>;

/// Protection at each target over the years, a line for each regime with the band of its replicates. HTML.
std::string protection_charts(const Names& names, const Site& site, std::span<const Series> series);

/// The same as a table for each target: start, end, mean over the years, the lowest year of a course at a
/// target as the decision has it;
/// and a chart of the rocks that arrive. HTML.
std::string protection_over_years(const Names& names, const Site& site, std::span<const Series> series,
                                  std::span<const MemberYears> members, const LowestYears& lowest);

}  // namespace coupling::decades
