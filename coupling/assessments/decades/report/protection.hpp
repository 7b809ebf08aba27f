#pragma once

#include <span>
#include <string>

#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::decades {

/// Protection at each target over the years, a line for each regime with the band of its replicates. HTML.
std::string protection_charts(const Names& names, const Site& site, std::span<const Series> series);

/// The same as a table for each target: start, end, mean over the years, worst year; and a chart of the rocks
/// that arrive. HTML.
std::string protection_over_years(const Names& names, const Site& site, std::span<const Series> series,
                                  std::span<const MemberYears> members);

}  // namespace coupling::decades
