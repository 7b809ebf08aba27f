#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

/// A figure of a ground type: a column of its table, and a setting of [ground.NAME].
struct GroundFigure {
    std::string name;
    config::NumberRange range;
    std::string meaning;
    std::function<void(rockfall::SurfaceType&, double)> set;
};
/// All of them; the first are those of the ground of any rock, the others those of blocks with a shape.
const std::vector<GroundFigure>& ground_figures();

/// Stopping probability by rock diameter where only that of a rock of 0.95 m is known: scaled by
/// config/data/stopping_size.csv, at most 1.
rockfall::StopCurve stop_curve(double stop_probability);

}  // namespace coupling
