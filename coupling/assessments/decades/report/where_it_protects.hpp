#pragma once

#include <span>
#include <string>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/report/map/map_window.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::decades {

/// A part of the page.
struct ProtectingPlaces {
    std::string html;       ///< empty where no rock comes through a forest
    bool has_maps = false;  ///< with what all maps of the page refer to
};

/// Where the forest protects: for each target what cutting would cost by distance from it (sentence,
/// table, chart; regimes side by side in the first climate), then maps by patch of the first regime.
ProtectingPlaces where_it_protects(const Names& names, const Site& site, const forest::PatchGrid& grid,
                                   std::span<const MemberYears> members, const report::MapWindow& window);

}  // namespace coupling::decades
