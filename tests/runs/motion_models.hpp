#pragma once

#include <string>
#include <vector>

#include "rockfall/motion/models.hpp"

namespace coupling {

/// The names of all motion models, as rockfall.motion takes them.
inline std::vector<std::string> motion_model_names() {
    std::vector<std::string> names;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        names.emplace_back(rockfall::description_of(model).name);
    }
    return names;
}

}  // namespace coupling
