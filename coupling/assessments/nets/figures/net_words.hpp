#pragma once

#include <string>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "rockfall/obstacles/nets/net.hpp"

namespace coupling {

/// "class 3 (1 000 kJ), 2.5 m high": a barrier to order. Text, not markup.
std::string in_words(const BarrierToOrder& barrier);

/// What the upper ends of what is not known ask for; empty where that is the same barrier or not known.
std::string upper_in_words(const BarrierDesign& design);

/// The same of the rocks that reach a net, or why that cannot be said.
std::string need_in_words(const NetFigures& figures, const DesignSettings& settings);

/// "Pass over": what becomes of rocks at a net.
const std::string& in_words(rockfall::NetOutcome outcome);

/// By what percentile, factors and freeboard barriers are designed: whole sentences.
std::string design_rule_in_words(const DesignSettings& settings);

/// Whether the forest asks for a stronger or a higher net than the bare slope.
bool asks_for_more(const BarrierDesign& with_forest, const BarrierDesign& bare);

/// A net on one slope in a line: rocks that reach it, the share that it holds, energies, heights, the design.
std::string in_words(const NetRecord& net, const NetFigures& figures, const DesignSettings& settings);

}  // namespace coupling
