#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace rockfall {

/// What rocks left in one cell, by groups of the strata among which an ensemble is shared: from how far the
/// groups lie apart follows how far what is not known moves the figures of the cell. Sums are whole
/// numbers: they add up the same in any order.
struct CellSpread {
    /// [choice] So many groups give a standard deviation within 18 % of itself, and strata have at least 16.
    static constexpr std::size_t groups = 16;

    std::array<std::uint32_t, groups> passages{};
    std::array<std::uint64_t, groups> energy_sum_j{};
    std::uint64_t energy_squares_hj2 = 0;  ///< in (100 J)^2, so that a rock of 100 J still counts

    void add(std::uint32_t stratum, float energy_j);
    void add(const CellSpread& other);
};

/// Standard deviation of the reach probability [0, 1] of a cell over the draws of what is not known, without
/// the chance of its rocks; 0 where chance alone explains the groups, NaN below `least_spread_passages`.
///
/// Requires that each source releases as many rocks as there are strata, or more: then groups share evenly
/// the rocks that feed a cell (stratum_of). A group holds strata / 16 draws, whose mean lies closer together
/// than single draws by the root of that number.
double reach_spread(const CellSpread& cell, std::uint64_t fed_rocks, std::uint32_t strata);

/// The same of the mean of the largest energy of each rock [J]: components of variance of unequal groups.
double energy_spread_j(const CellSpread& cell, std::uint32_t strata);

/// Fewer rocks say nothing of a spread [choice]: 16 to a group, whose chance can look like a relative spread
/// of 0.3 by itself.
inline constexpr std::uint32_t least_spread_passages = 16 * CellSpread::groups;

}  // namespace rockfall
