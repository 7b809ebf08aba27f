#pragma once

#include <string>
#include <vector>

#include "rockfall/motion/pir3d/law.hpp"
#include "rockfall/motion/seam/fall_figures.hpp"

namespace rockfall::pir3d {

std::vector<std::string> doubts_after(const FallFigures& falls, const Law& law);

}  // namespace rockfall::pir3d
