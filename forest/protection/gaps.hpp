#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "forest/stand/patch.hpp"
#include "forest/stand/tree.hpp"

namespace forest {

/// A patch without a living stem of this diameter is open to rocks [choice]: where foresters begin to count
/// stems against rockfall (NaiS).
inline constexpr double closing_dbh_cm = 12.0;

/// A line of open patches down the fall line.
struct Gap {
    std::vector<PatchId> patches;  ///< from above to below
    double length_m = 0.0;         ///< along the ground
};

/// Whether each patch is open: no living stem of `closing_dbh_cm` stands on it.
std::vector<char> open_patches(const PatchGrid& grid, std::span<const Tree> trees);

/// Gaps along the fall line, one for each open patch that no open patch above leads into.
///
/// From a patch the way goes to the lowest by slope of its eight neighbours, as long as that is lower; where
/// the ground faces out of the forest, the way ends. The length is that of the way over the open patches,
/// half a step beyond the first and the last centre: one open patch on a slope of 45 degrees is 14 m long.
/// Two gaps that run together share their lower part. So gaps are measured in whole patches; between stems
/// they are up to a patch longer.
///
/// Requires a mark for each patch.
std::vector<Gap> gaps_along_fall_line(const PatchGrid& grid, std::span<const char> open);

/// Gaps of a forest or a part of it.
struct GapFigures {
    std::uint32_t gaps = 0;
    std::uint32_t patches = 0;
    std::uint32_t open_patches = 0;
    double mean_m = 0.0;  ///< over gaps; 0 without gaps
    double p95_m = 0.0;   ///< of gaps, straight between them
    double max_m = 0.0;
};

/// Of the gaps that touch any of the patches that count, each with its whole length.
GapFigures figures_of(const PatchGrid& grid, std::span<const char> open, std::span<const Gap> gaps,
                      const std::function<bool(const Patch&)>& counts);

}  // namespace forest
