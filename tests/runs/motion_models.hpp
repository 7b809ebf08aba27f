#pragma once

#include <algorithm>
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

/// Fewer rocks for a model whose rocks have a shape: each takes hundreds of times as long.
inline std::string rocks_for(const std::string& model, int rocks) {
    constexpr int fewer = 400;
    return "--set release.rocks=" + std::to_string(model == "rigid" ? std::max(rocks / fewer, 6) : rocks) +
           " ";
}

/// What chooses a motion model in a call; its rocks are blocks where it gives them a shape.
inline std::string motion_settings(const std::string& model) {
    for (const rockfall::MotionModel one : rockfall::all_models()) {
        const rockfall::ModelDescription& description = rockfall::description_of(one);
        if (description.name == model && description.has_shape) {
            return "--set rockfall.motion=" + model + " --set release.shape=cube,plate,sphere ";
        }
    }
    return "--set rockfall.motion=" + model + " ";
}

}  // namespace coupling
