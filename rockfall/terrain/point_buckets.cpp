#include "rockfall/terrain/point_buckets.hpp"

#include <cmath>
#include <cstddef>

namespace rockfall {

PointBuckets::PointBuckets(std::span<const Eigen::Vector3d> points, double radius_m) : points_{points} {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (points[i].allFinite()) {
            members_.push_back(i);
        }
    }
    place_frame(radius_m);
    first_.assign(frame_.size() + 1, 0);
    std::vector<std::uint32_t> bucket(points.size());
    for (const std::uint32_t i : members_) {
        bucket[i] = static_cast<std::uint32_t>(frame_.index(frame_.cell_at(points[i].x(), points[i].y())));
        ++first_[bucket[i] + 1];
    }
    for (std::size_t i = 1; i < first_.size(); ++i) {
        first_[i] += first_[i - 1];
    }
    std::stable_sort(members_.begin(), members_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return bucket[a] < bucket[b]; });
}

void PointBuckets::place_frame(double radius_m) {
    if (members_.empty()) {
        return;
    }
    Eigen::Vector2d low_m = points_[members_.front()].head<2>();
    Eigen::Vector2d high_m = low_m;
    for (const std::uint32_t i : members_) {
        low_m = low_m.cwiseMin(points_[i].head<2>());
        high_m = high_m.cwiseMax(points_[i].head<2>());
    }
    const Eigen::Vector2d extent_m = high_m - low_m;
    // A small radius in a wide extent must not make more buckets than there are points, by side or by area.
    const double count = static_cast<double>(members_.size());
    const double width_m =
        std::max({radius_m, std::sqrt(extent_m.prod() / count), extent_m.maxCoeff() / count}) * (1.0 + 1e-9);
    frame_ = {.columns = static_cast<int>(extent_m.x() / width_m) + 2,
              .rows = static_cast<int>(extent_m.y() / width_m) + 2,
              .x_west_m = low_m.x() - 0.5 * width_m,
              .y_south_m = low_m.y() - 0.5 * width_m,
              .cell_width_m = width_m,
              .cell_height_m = width_m};
}

}  // namespace rockfall
