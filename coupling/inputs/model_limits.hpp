#pragma once

#include <span>

#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

/// Warns of results for which the chosen motion model is not confirmed (`caution` of its description) and of
/// what it does badly on this slope (rockfall::doubts_of). Without sources rocks may start at the highest
/// point.
void warn_of_model_limits(const rockfall::Slope& slope, std::span<const rockfall::ReleaseSource> sources,
                          Reading& reading);

}  // namespace coupling
