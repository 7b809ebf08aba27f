#pragma once

#include <span>
#include <string>

#include "coupling/assessments/decades/tables/comparison.hpp"

namespace coupling::decades {

/// Whether any year has a protection figure.
bool has_protection(std::span<const Series> all_series);

/// Whether the stand will go on protecting: protection by living trees alone beside all, slender stems,
/// regeneration, wood lost, carbon, at the start, half-way and at the end. HTML.
std::string indicator_table(const Names& names, const Site& site, std::span<const Series> all_series);

}  // namespace coupling::decades
