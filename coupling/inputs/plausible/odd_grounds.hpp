#pragma once

#include <span>
#include <string>

#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling::plausible {

/// Rocks keep less of their speed normal to the ground than along it: of all published pairs r_n is the
/// smaller one. A table in which every row has the larger r_n has the two columns exchanged: an error. Single
/// rows are warned of.
void judge_restitutions(std::span<const rockfall::SurfaceType> types, const std::string& file,
                        Reading& reading);

}  // namespace coupling::plausible
