#pragma once

#include <string>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/inputs/nets/net_record.hpp"

namespace coupling {

/// "class 3 (1 000 kJ), 2.5 m high": what a net needs to hold a share of the rocks that reach it, or why that
/// cannot be said. Text, not markup.
std::string need_in_words(const NetFigures& figures, double wanted_share);

/// A net on one slope in a line: rocks that reach it, the share that it holds, energies, heights, the need.
std::string in_words(const NetRecord& net, const NetFigures& figures, double wanted_share);

}  // namespace coupling
