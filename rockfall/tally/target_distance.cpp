#include "rockfall/tally/target_distance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace rockfall {
namespace {

constexpr std::size_t pieces_in_a_group = 8;

double squared_from_box(const Eigen::Vector2d& place_m, const Eigen::Vector2d& low_m,
                        const Eigen::Vector2d& high_m) {
    return (place_m.cwiseMax(low_m).cwiseMin(high_m) - place_m).squaredNorm();
}

}  // namespace

TargetDistance::TargetDistance(const Target& target) : target_{target} {
    for (const auto& part : target.parts) {
        for (std::size_t i = 0; i < part.size(); ++i) {
            // A part of one vertex is a piece without length.
            if (i + 1 < part.size() || part.size() == 1) {
                pieces_.push_back({part[i], part[std::min(i + 1, part.size() - 1)] - part[i]});
            }
        }
    }
    assert(!pieces_.empty());
    for (std::size_t first = 0; first < pieces_.size(); first += pieces_in_a_group) {
        Group group{pieces_[first].begin_m, pieces_[first].begin_m, first,
                    std::min(first + pieces_in_a_group, pieces_.size())};
        for (std::size_t i = first; i < group.last; ++i) {
            for (const Eigen::Vector2d& end_m :
                 {pieces_[i].begin_m, Eigen::Vector2d{pieces_[i].begin_m + pieces_[i].along_m}}) {
                group.low_m = group.low_m.cwiseMin(end_m);
                group.high_m = group.high_m.cwiseMax(end_m);
            }
        }
        groups_.push_back(group);
    }
}

double TargetDistance::from_m(const Eigen::Vector2d& place_m) const {
    if (target_.is_area && is_inside(target_, place_m)) {
        return 0.0;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (const Group& group : groups_) {
        if (squared_from_box(place_m, group.low_m, group.high_m) >= nearest) {
            continue;
        }
        for (std::size_t i = group.first; i < group.last; ++i) {
            const Piece& piece = pieces_[i];
            const Eigen::Vector2d from_begin_m = place_m - piece.begin_m;
            const double length2 = piece.along_m.squaredNorm();
            const double share =
                length2 > 0.0 ? std::clamp(from_begin_m.dot(piece.along_m) / length2, 0.0, 1.0) : 0.0;
            nearest = std::min(nearest, (from_begin_m - share * piece.along_m).squaredNorm());
        }
    }
    return std::sqrt(nearest);
}

}  // namespace rockfall
