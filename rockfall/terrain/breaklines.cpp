#include "rockfall/terrain/breaklines.hpp"

#include <vector>

#include "rockfall/terrain/borders.hpp"

namespace rockfall {

std::optional<Eigen::Vector2d> crossing_of(std::span<const Eigen::Vector3d> points,
                                           std::span<const PointPair> lines) {
    std::vector<PlanSegment> segments;
    segments.reserve(lines.size());
    for (const auto& [from, to] : lines) {
        segments.push_back({points[from].head<2>(), points[to].head<2>()});
    }
    const std::vector<PlanCrossing> crossings = crossings_of(segments, 1);
    return crossings.empty() ? std::nullopt : std::optional{crossings.front().place_m};
}

}  // namespace rockfall
