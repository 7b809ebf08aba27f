#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// Points sorted into square cells at least as wide as a radius, so that all neighbours within it lie in
/// 3 x 3 of them. Points that are not finite are left out. Refers to the points, which must outlive it.
class PointBuckets {
public:
    PointBuckets(std::span<const Eigen::Vector3d> points, double radius_m);

    /// Calls visit(index) for all finite points in the bucket of a finite point and the eight around it.
    template <class Visit>
    void for_each_around(const Eigen::Vector3d& point, Visit visit) const {
        const config::Cell home = frame_.cell_at(point.x(), point.y());
        const int west = std::max(home.column - 1, 0);
        const int east = std::min(home.column + 1, frame_.columns - 1);
        for (int row = std::max(home.row - 1, 0); row <= std::min(home.row + 1, frame_.rows - 1); ++row) {
            const std::uint32_t end = first_[frame_.index({east, row}) + 1];
            for (std::uint32_t member = first_[frame_.index({west, row})]; member < end; ++member) {
                visit(members_[member]);
            }
        }
    }

private:
    void place_frame(double radius_m);

    std::span<const Eigen::Vector3d> points_;
    config::GridFrame frame_;
    std::vector<std::uint32_t> first_;    ///< place of the first member of each bucket; one more at the end
    std::vector<std::uint32_t> members_;  ///< finite points, bucket after bucket
};

}  // namespace rockfall
