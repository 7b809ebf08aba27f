#pragma once

#include <span>
#include <string>

#include "coupling/assessments/decades/tables/cuts_made.hpp"
#include "coupling/assessments/decades/tables/intervention_areas.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/report/map/map_window.hpp"

namespace coupling::decades {

/// Cuts to draw beside what was planned; without names there is no run yet.
struct DrawnCuts {
    const Names* names = nullptr;
    const forest::PatchGrid* grid = nullptr;
    std::span<const CutMade> cuts{};
};

/// A map for each regime with the ground of its interventions over the hillshade, each row with a colour,
/// pattern of line and entry of the legend; below, after a run, where trees were cut in the first replicate
/// in the first climate. HTML; empty without areas. `defines`: the page has no other map of this site before.
std::string area_maps(const Site& site, const Management& management, std::span<const InterventionArea> areas,
                      const report::MapWindow& window, const DrawnCuts& made, bool defines = true);

}  // namespace coupling::decades
