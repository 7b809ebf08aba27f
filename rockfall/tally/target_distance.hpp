#pragma once

#include <Eigen/Core>
#include <vector>

#include "rockfall/tally/target.hpp"

namespace rockfall {

/// Distance on the map between places and a target: from the nearest point of its lines or of the rim of its
/// area; 0 in an area.
///
/// Lines are kept in groups of neighbouring pieces with a box around each, so that a road of hundreds of
/// corners costs hardly more than a straight one.
class TargetDistance {
public:
    /// Requires at least one vertex. Refers to the target as long as it lives.
    explicit TargetDistance(const Target& target);

    [[nodiscard]] double from_m(const Eigen::Vector2d& place_m) const;

private:
    struct Piece {
        Eigen::Vector2d begin_m;
        Eigen::Vector2d along_m;
    };
    struct Group {
        Eigen::Vector2d low_m;
        Eigen::Vector2d high_m;
        std::size_t first;
        std::size_t last;  ///< one past
    };
    const Target& target_;
    std::vector<Piece> pieces_;
    std::vector<Group> groups_;
};

}  // namespace rockfall
