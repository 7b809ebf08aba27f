#pragma once

#include <memory>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling::validation {

/// Heights that a real slope has above and below its own smooth surface, to be laid on a rebuilt one.
///
/// Column 0 of the grid is the upper end of the slope, rows run across it. Beyond the grid its mirror image
/// goes on, so that a small piece covers any slope without a step.
class Relief {
public:
    /// None: 0 everywhere.
    Relief() = default;
    /// Moved by `shift_along_m` down the slope and `shift_across_m` to the left. Requires a grid without
    /// missing values.
    Relief(std::shared_ptr<const config::Raster<double>> heights, double shift_along_m,
           double shift_across_m);

    /// Height [m] at a distance along the profile and beside its axis, bilinear between cell centres.
    [[nodiscard]] double at(double along_m, double across_m) const;
    /// The distances between two ends at which a strip needs corners to show the relief; none without.
    [[nodiscard]] std::vector<double> corners_m(double from_m, double to_m) const;

private:
    std::shared_ptr<const config::Raster<double>> heights_;
    double shift_along_m_ = 0.0;
    double shift_across_m_ = 0.0;
};

}  // namespace coupling::validation
