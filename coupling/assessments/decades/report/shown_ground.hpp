#pragma once

#include <span>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/report/map/map_window.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::decades {

/// The part of the map that a page over years shows: where rocks pass in any year with maps, and the forest
/// in which regimes act. All maps of the page share it.
report::MapWindow shown_ground(const Site& site, const forest::PatchGrid& grid,
                               std::span<const MemberYears> members);

}  // namespace coupling::decades
