#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/obstacles/nets/net.hpp"

namespace rockfall {

/// Where a straight path crosses the line of a net in plan.
struct NetLineCrossing {
    std::uint32_t net;
    double share;    ///< of the way from start to end of the path, [0, 1]
    double along_m;  ///< along the line of the net, from its first corner
};

/// All nets of a slope, found by place. They are few: a path looks at the box around each.
///
/// On which side of a line a point lies is one number, seen alike from both pieces of a path that meet there;
/// so a path made of pieces crosses each line exactly once where it changes sides, and nothing slips through
/// between two pieces or at a corner of the net.
class NetIndex {
public:
    NetIndex() = default;
    explicit NetIndex(std::span<const Net> nets);

    [[nodiscard]] bool empty() const { return nets_.empty(); }
    [[nodiscard]] std::size_t count() const { return nets_.size(); }
    [[nodiscard]] const Net& operator[](std::uint32_t net) const { return nets_[net].net; }

    /// All crossings of the straight path between two points, in its order.
    void find_crossings(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
                        std::vector<NetLineCrossing>& found) const;

private:
    struct Placed {
        Net net;
        std::vector<double> before_m;  ///< length of the line up to each corner
        Eigen::Vector2d low_m;         ///< box around it
        Eigen::Vector2d high_m;
    };
    std::vector<Placed> nets_;
};

}  // namespace rockfall
