#pragma once

#include <cstdint>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::plausible {

/// Fewer rocks than this in all say little about anything. [choice]
inline constexpr std::uint64_t least_rocks = 100;

/// Diameters that are seldom meant: below, stones; above, a volume of 100 m3, from which on one speaks of
/// rock masses that break up and no more of single blocks. [choice], after Swiss recommendations on mass
/// movements of 1997 [mem: not read at the source].
inline constexpr double smallest_usual_m = 0.05;
inline constexpr double largest_usual_m = 5.76;

/// Rocks that all falls of a run release together: of all years and replicates where a forest grows.
std::uint64_t rocks_in_all(const Scenario& scenario, const Site& site);

/// Warns of a run that releases too few rocks to mean anything, with the uncertainty of a share that is
/// estimated from them.
void warn_of_few_rocks(std::uint64_t rocks, config::Warnings& warnings);

/// Warns of rocks whose size looks like another unit.
void warn_of_odd_sizes(const rockfall::DiameterRange& diameters, config::Warnings& warnings);

/// Both, for the rocks of a site.
void warn_of_rocks(const Scenario& scenario, const Site& site, config::Warnings& warnings);

}  // namespace coupling::plausible
