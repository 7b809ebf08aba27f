#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// Standard deviation of what heights have from one point to the next, and how far these lie apart.
struct PointNoise {
    double noise_m = 0.0;
    double spacing_m = 0.0;  ///< side of the square that one point stands for
};

/// The noise of heights, by square patches of some hundred points: what a point lies off the smooth surface
/// through those around it. Slopes, curvature and straight walls along rows or columns are none, and what
/// fills less than about a third of a patch (crooked walls, edges, single wrong cells) hardly counts, as the
/// median is taken.
///
/// - Grid: the second difference across of the second differences along (Immerkaer 1996), by its median
///   absolute value. It has the standard deviation 6 times the noise where that is independent from cell to
///   cell.
/// - Points: what is left beside the quadratic through the neighbours, without the point itself, in units of
///   what the noise of all of them leaves.
///
/// Noise that neighbours share, as after resampling to finer cells, is seen in part only. A patch with few
/// known points takes the middle of all patches. The same for heights that are turned by 90 degrees or
/// mirrored.
class HeightNoise {
public:
    HeightNoise() = default;  ///< of heights without noise
    explicit HeightNoise(const config::Raster<double>& heights);
    explicit HeightNoise(std::span<const Eigen::Vector3d> points);

    /// Straight between the middles of the patches around.
    [[nodiscard]] PointNoise at(double x_m, double y_m) const;
    [[nodiscard]] std::span<const PointNoise> patches() const { return patches_; }

private:
    config::GridFrame frame_;  ///< a cell a patch
    std::vector<PointNoise> patches_;
};

}  // namespace rockfall
