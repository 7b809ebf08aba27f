#pragma once

#include <span>

#include "coupling/inputs/reading.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/slope.hpp"

namespace coupling {

/// Warns of what the chosen motion model does badly on this slope (rockfall::doubts_of). Without sources
/// rocks may start at the highest point.
void warn_of_model_limits(const rockfall::Slope& slope, std::span<const rockfall::ReleaseSource> sources,
                          Reading& reading);

}  // namespace coupling
