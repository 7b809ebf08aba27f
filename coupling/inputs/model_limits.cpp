#include "coupling/inputs/model_limits.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include "rockfall/parameters.hpp"

namespace coupling {
namespace {

/// From the highest source to the lowest ground.
double drop_m_of(const rockfall::Slope& slope, std::span<const rockfall::ReleaseSource> sources) {
    double low_m = std::numeric_limits<double>::infinity();
    double highest_m = -low_m;
    for (const rockfall::Vertex& vertex : slope.terrain.vertices()) {
        low_m = std::min(low_m, vertex.z_m);
        highest_m = std::max(highest_m, vertex.z_m);
    }
    double start_m = -std::numeric_limits<double>::infinity();
    for (const rockfall::ReleaseSource& source : sources) {
        const Eigen::Vector2d middle_m = 0.5 * (source.first_m + source.last_m);
        start_m = std::max(start_m, slope.terrain.height_m(middle_m.x(), middle_m.y()).value_or(start_m));
    }
    return (sources.empty() ? highest_m : start_m) - low_m;
}

}  // namespace

void warn_of_model_limits(const rockfall::Slope& slope, std::span<const rockfall::ReleaseSource> sources,
                          Reading& reading) {
    const rockfall::MotionLaws& motion = reading.rockfall().fall.motion;
    if (const std::string_view caution = rockfall::description_of(motion.model).caution; !caution.empty()) {
        reading.warn(std::string{caution}, config::Effect::answer);
    }
    for (std::string& sentence : rockfall::doubts_of(motion, slope, drop_m_of(slope, sources))) {
        reading.warn(std::move(sentence));
    }
}

}  // namespace coupling
