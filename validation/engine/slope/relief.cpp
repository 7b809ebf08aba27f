#include "validation/engine/slope/relief.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coupling::validation {

namespace {

/// A cell and the share of the next one.
struct Between {
    int first = 0;
    int second = 0;
    double share = 0.0;
};

/// Where a place lies between cell centres, in cells from the first centre, with the grid mirrored at its
/// outer centres.
Between mirrored(double cells, int count) {
    if (count == 1) {
        return {};
    }
    const double period = 2.0 * (count - 1);
    double place = std::fmod(cells, period);
    place = place < 0.0 ? place + period : place;
    place = place > count - 1 ? period - place : place;
    const int first = std::min(static_cast<int>(place), count - 2);
    return {first, first + 1, place - first};
}

}  // namespace

Relief::Relief(std::shared_ptr<const config::Raster<double>> heights, double shift_along_m,
               double shift_across_m)
    : heights_{std::move(heights)}, shift_along_m_{shift_along_m}, shift_across_m_{shift_across_m} {}

double Relief::at(double along_m, double across_m) const {
    if (!heights_) {
        return 0.0;
    }
    const config::GridFrame& frame = heights_->frame;
    const Between x = mirrored((along_m - shift_along_m_) / frame.cell_width_m, frame.columns);
    const double middle = 0.5 * (frame.rows - 1);
    const Between y = mirrored(middle - (across_m - shift_across_m_) / frame.cell_height_m, frame.rows);
    const auto row = [&](int r) {
        return std::lerp(heights_->at({x.first, r}), heights_->at({x.second, r}), x.share);
    };
    return std::lerp(row(y.first), row(y.second), y.share);
}

std::vector<double> Relief::corners_m(double from_m, double to_m) const {
    std::vector<double> corners;
    if (!heights_) {
        return corners;
    }
    const double cell_m = heights_->frame.cell_width_m;
    const double first = std::floor((from_m - shift_along_m_) / cell_m) + 1.0;
    for (double i = first; shift_along_m_ + i * cell_m < to_m; i += 1.0) {
        corners.push_back(shift_along_m_ + i * cell_m);
    }
    return corners;
}

}  // namespace coupling::validation
