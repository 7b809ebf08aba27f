#include "rockfall/obstacles/nets/net_index.hpp"

#include <algorithm>
#include <tuple>

namespace rockfall {
namespace {

/// Twice the area of the triangle a, b, p: above 0 where p lies left of the line from a to b.
double side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

}  // namespace

NetIndex::NetIndex(std::span<const Net> nets) {
    nets_.reserve(nets.size());
    for (const Net& net : nets) {
        Placed placed{net, {0.0}, net.line_m.front(), net.line_m.front()};
        for (std::size_t i = 1; i < net.line_m.size(); ++i) {
            placed.before_m.push_back(placed.before_m.back() + (net.line_m[i] - net.line_m[i - 1]).norm());
            placed.low_m = placed.low_m.cwiseMin(net.line_m[i]);
            placed.high_m = placed.high_m.cwiseMax(net.line_m[i]);
        }
        nets_.push_back(std::move(placed));
    }
}

void NetIndex::find_crossings(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
                              std::vector<NetLineCrossing>& found) const {
    found.clear();
    const Eigen::Vector2d low_m = from_m.cwiseMin(to_m);
    const Eigen::Vector2d high_m = from_m.cwiseMax(to_m);
    for (std::uint32_t number = 0; number < nets_.size(); ++number) {
        const Placed& placed = nets_[number];
        if (high_m.x() < placed.low_m.x() || low_m.x() > placed.high_m.x() || high_m.y() < placed.low_m.y() ||
            low_m.y() > placed.high_m.y()) {
            continue;
        }
        const std::vector<Eigen::Vector2d>& line = placed.net.line_m;
        double aside = side_of(from_m, to_m, line.front());
        for (std::size_t i = 1; i < line.size(); ++i) {
            const double aside_before = aside;
            aside = side_of(from_m, to_m, line[i]);
            if ((aside_before < 0.0) == (aside < 0.0)) {
                continue;
            }
            const double start = side_of(line[i - 1], line[i], from_m);
            const double end = side_of(line[i - 1], line[i], to_m);
            if ((start < 0.0) == (end < 0.0)) {
                continue;
            }
            const double of_segment = aside_before / (aside_before - aside);
            found.push_back(
                {number, start / (start - end),
                 placed.before_m[i - 1] + of_segment * (placed.before_m[i] - placed.before_m[i - 1])});
        }
    }
    if (found.size() > 1) {
        std::sort(found.begin(), found.end(), [](const NetLineCrossing& a, const NetLineCrossing& b) {
            return std::tie(a.share, a.net, a.along_m) < std::tie(b.share, b.net, b.along_m);
        });
    }
}

}  // namespace rockfall
