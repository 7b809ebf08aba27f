#pragma once

#include "coupling/assessments/collapse/collapse_results.hpp"

namespace coupling::collapse {

/// The mass from the side at the times of the pictures, coloured by speed and by displacement, with scales,
/// the names of the targets and legends: what the page needs of them.
report::PageFields side_views(const CollapseResults& results);

/// Chosen blocks and the mean one over time, as charts (HTML); nothing where no block moved.
std::optional<report::PageFields> block_charts(const CollapseResults& results);

}  // namespace coupling::collapse
