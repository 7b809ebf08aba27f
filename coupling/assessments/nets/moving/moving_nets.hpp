#pragma once

#include <span>
#include <string>

#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/results/report/map/map_sheet.hpp"

namespace coupling::moving {

/// The part of a page in which nets can be dragged: a map of each, the stored paths near them, and the
/// figures that these paths give; a sentence where they would make the page too large. The page has to carry
/// page_scripts::nets() and moving_nets.css, and the definitions of the sheet.
std::string moving_nets(NetPathsReader& paths, std::span<const NetRecord> nets,
                        const report::MapSheet& sheet);

}  // namespace coupling::moving
