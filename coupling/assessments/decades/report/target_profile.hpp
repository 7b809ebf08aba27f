#pragma once

#include <optional>
#include <span>
#include <string>

#include "coupling/assessments/decades/tables/comparison.hpp"
#include "forest/protection/target_profile.hpp"

namespace coupling::decades {

/// Whether the stands are what rocks of this size ask for, at the start, half-way and at the end, in words
/// and as a table; and what ended the falls of the first and the last year with rocks. HTML. `mean_block_m`:
/// of the rocks' diameters.
std::string stands_against_rocks(const Names& names, std::span<const Series> series,
                                 const std::optional<forest::TargetProfile>& profile, double mean_block_m);

}  // namespace coupling::decades
