#include "rockfall/terrain/borders.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rockfall/terrain/plan.hpp"

namespace rockfall {
namespace {

/// The border side that follows after another one, turning around their common vertex.
TinSide next_border(const Tin& tin, const TinEdges& edges, TinSide side) {
    TinSide next{side.face, (side.side + 1) % 3};
    for (std::uint32_t across = edges.neighbours[next.face][next.side]; across != no_triangle;
         across = edges.neighbours[next.face][next.side]) {
        // The shared edge ends there at the common vertex, so the side that begins at it is the next one.
        const std::uint32_t vertex = tin.faces[next.face].corners[next.side];
        const auto& corners = tin.faces[across].corners;
        const auto begins =
            static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
        next = {across, begins};
    }
    return next;
}

/// Where a segment crosses another one inside both; the segments may share ends.
bool crosses(const PlanSegment& a, const PlanSegment& b, Eigen::Vector2d& place_m) {
    const Eigen::Vector2d along_a = a.to_m - a.from_m;
    const Eigen::Vector2d along_b = b.to_m - b.from_m;
    const double of_a1 = cross_in_plan(along_a, b.from_m - a.from_m);
    const double of_a2 = cross_in_plan(along_a, b.to_m - a.from_m);
    const double of_b1 = cross_in_plan(along_b, a.from_m - b.from_m);
    const double of_b2 = cross_in_plan(along_b, a.to_m - b.from_m);
    if (!(of_a1 * of_a2 < 0.0 && of_b1 * of_b2 < 0.0)) {
        return false;
    }
    place_m = a.from_m + of_b1 / (of_b1 - of_b2) * along_a;
    return true;
}

/// Whether a segment runs along another one in the same sense, over more than the tolerance, and the middle
/// of that stretch.
bool runs_along(const PlanSegment& a, const PlanSegment& b, double tolerance_m, Eigen::Vector2d& place_m) {
    const Eigen::Vector2d along = (a.to_m - a.from_m).normalized();
    const auto beside_m = [&](const Eigen::Vector2d& point) {
        return std::abs(cross_in_plan(along, point - a.from_m));
    };
    if (!((b.to_m - b.from_m).dot(along) > 0.0)) {
        return false;
    }
    const double begins_m = std::max(0.0, (b.from_m - a.from_m).dot(along));
    const double ends_m = std::min((a.to_m - a.from_m).norm(), (b.to_m - a.from_m).dot(along));
    place_m = a.from_m + 0.5 * (begins_m + ends_m) * along;
    return ends_m - begins_m > tolerance_m && beside_m(b.from_m) <= tolerance_m &&
           beside_m(b.to_m) <= tolerance_m;
}

/// A sweep over all pairs that come as near as `reach_m`: those that `meets(first, second, place)` holds for.
template <class Meets>
std::vector<PlanCrossing> meetings_of(std::span<const PlanSegment> segments, std::size_t most, double reach_m,
                                      const Meets& meets) {
    const auto west_m = [&](std::size_t i) { return std::min(segments[i].from_m.x(), segments[i].to_m.x()); };
    const auto east_m = [&](std::size_t i) { return std::max(segments[i].from_m.x(), segments[i].to_m.x()); };
    std::vector<std::size_t> order(segments.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return west_m(a) < west_m(b); });
    // A sweep from west to east: `open` are the segments that reach to where it stands.
    std::vector<std::size_t> open;
    std::vector<PlanCrossing> found;
    for (const std::size_t next : order) {
        std::erase_if(open, [&](std::size_t i) { return east_m(i) + reach_m < west_m(next); });
        const auto [south_m, north_m] = std::minmax(segments[next].from_m.y(), segments[next].to_m.y());
        for (const std::size_t other : open) {
            const PlanSegment& before = segments[other];
            Eigen::Vector2d place_m;
            if (std::max(before.from_m.y(), before.to_m.y()) + reach_m >= south_m &&
                std::min(before.from_m.y(), before.to_m.y()) <= north_m + reach_m &&
                meets(before, segments[next], place_m)) {
                found.push_back({std::min(other, next), std::max(other, next), place_m});
                if (found.size() == most) {
                    return found;
                }
            }
        }
        open.push_back(next);
    }
    return found;
}

}  // namespace

std::vector<BorderLoop> border_loops(const Tin& tin, const TinEdges& edges) {
    std::vector<std::array<bool, 3>> seen(tin.faces.size(), {false, false, false});
    std::vector<BorderLoop> loops;
    for (const TinSide& start : edges.borders) {
        if (seen[start.face][start.side]) {
            continue;
        }
        BorderLoop loop;
        double area2_m2 = 0.0;
        const Eigen::Vector3d origin_m = tin.vertices_m[tin.faces[start.face].corners[start.side]];
        for (TinSide side = start; !seen[side.face][side.side]; side = next_border(tin, edges, side)) {
            seen[side.face][side.side] = true;
            loop.sides.push_back(side);
            const auto& corners = tin.faces[side.face].corners;
            const Eigen::Vector3d from = tin.vertices_m[corners[side.side]] - origin_m;
            const Eigen::Vector3d to = tin.vertices_m[corners[(side.side + 1) % 3]] - origin_m;
            area2_m2 += from.x() * to.y() - from.y() * to.x();
        }
        loop.around_hole = area2_m2 < 0.0;
        loops.push_back(std::move(loop));
    }
    return loops;
}

std::vector<PlanCrossing> crossings_of(std::span<const PlanSegment> segments, std::size_t most) {
    return meetings_of(segments, most, 0.0, crosses);
}

std::vector<PlanCrossing> laid_over_each_other(std::span<const PlanSegment> segments, double tolerance_m,
                                               std::size_t most) {
    return meetings_of(segments, most, tolerance_m,
                       [&](const PlanSegment& a, const PlanSegment& b, Eigen::Vector2d& place_m) {
                           return runs_along(a, b, tolerance_m, place_m);
                       });
}

}  // namespace rockfall
