#pragma once

#include <string>
#include <vector>

#include "rockfall/motion/classical/law.hpp"
#include "rockfall/motion/seam/fall_figures.hpp"

namespace rockfall::classical {

std::vector<std::string> doubts_after(const FallFigures& falls, const Law& law);

}  // namespace rockfall::classical
