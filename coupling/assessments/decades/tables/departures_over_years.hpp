#pragma once

#include <span>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/figures/fall_doubts.hpp"

namespace coupling::decades {

/// Rocks that left the terrain on one slope in all years of all members together.
Departures departures_over_years(std::span<const MemberYears> members, Cover cover,
                                 const rockfall::Terrain& terrain);

/// Over the bare slope in all years of all members together.
rockfall::FallFigures fall_figures_over_years(std::span<const MemberYears> members,
                                              const rockfall::Terrain& terrain);

/// Of targets that no rock reached in any year of any member.
void warn_of_unreached_targets(const Site& site, std::span<const MemberYears> members, const Departures& bare,
                               config::Warnings& warnings);

}  // namespace coupling::decades
