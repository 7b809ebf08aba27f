#include "forest/light/ground.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace forest {
namespace {

/// Columns at the border whose mean rise goes on beyond it under mirrored trees.
constexpr int trend_columns = 5;

/// A place on one axis of the area: the place inside that stands for it and what the ground gains on the way.
struct Inside {
    int place;
    double laps;    ///< whole widths passed (torus)
    double beyond;  ///< columns beyond the border, negative on the low side
};

Inside inside(int place, int count, Edges edges) {
    const int clamped = std::clamp(place, 0, count - 1);
    const double beyond = place - clamped;
    if (edges == Edges::torus) {
        const int lap = static_cast<int>(std::floor(static_cast<double>(place) / count));
        return {place - lap * count, static_cast<double>(lap), beyond};
    }
    if (edges == Edges::mirror) {
        const int period = 2 * count;
        const int within = ((place % period) + period) % period;
        return {std::min(within, period - 1 - within), 0.0, beyond};
    }
    return {clamped, 0.0, beyond};
}

/// Rise per column of the ground across the border at one end of a line of cells, away from the area.
double outward_rise(const config::Raster<double>& heights_m, config::Cell at, int step_column, int step_row) {
    if (step_column == 0 && step_row == 0) {
        return 0.0;
    }
    const int count = step_column != 0 ? heights_m.frame.columns : heights_m.frame.rows;
    const int reach = std::min(trend_columns, count) - 1;
    if (reach < 1) {
        return 0.0;
    }
    const config::Cell back{at.column - step_column * reach, at.row - step_row * reach};
    return (heights_m.at(at) - heights_m.at(back)) / reach;
}

/// Height of the ground of a column that may lie outside.
double height_beyond(const LightGround& ground, const Inside& across, const Inside& down) {
    const config::Raster<double>& heights_m = ground.elevation_m;
    if (ground.edges == Edges::torus) {
        // Rows count downwards, y upwards.
        return heights_m.at({across.place, down.place}) + across.laps * ground.gain_x_m -
               down.laps * ground.gain_y_m;
    }
    const auto border = [](double beyond, const Inside& axis, int count) {
        return beyond > 0.0 ? count - 1 : beyond < 0.0 ? 0 : axis.place;
    };
    const config::Cell edge{border(across.beyond, across, heights_m.frame.columns),
                            border(down.beyond, down, heights_m.frame.rows)};
    // Open ground goes on for one column, so that the slope at the border is that of the ground inside, and
    // is level then.
    const double goes_on = ground.edges == Edges::open ? 1.0 : std::numeric_limits<double>::infinity();
    const auto side = [](double beyond) { return beyond > 0.0 ? 1 : -1; };
    return heights_m.at(edge) +
           std::min(std::abs(across.beyond), goes_on) *
               outward_rise(heights_m, edge, across.beyond == 0.0 ? 0 : side(across.beyond), 0) +
           std::min(std::abs(down.beyond), goes_on) *
               outward_rise(heights_m, edge, 0, down.beyond == 0.0 ? 0 : side(down.beyond));
}

}  // namespace

PaddedGround::PaddedGround(const LightGround& ground, int margin)
    : frame_{ground.elevation_m.frame},
      margin_{margin},
      stride_{static_cast<std::size_t>(frame_.columns + 2 * margin)},
      elevation_m_(stride_ * static_cast<std::size_t>(frame_.rows + 2 * margin)),
      source_(elevation_m_.size(), none) {
    assert(frame_.size() > 0 && margin >= 1 && frame_.cell_width_m == frame_.cell_height_m);
    const double lowest_m =
        *std::min_element(ground.elevation_m.values.begin(), ground.elevation_m.values.end());
    assert(std::isfinite(lowest_m));
    std::size_t at = 0;
    for (int row = -margin; row < frame_.rows + margin; ++row) {
        const Inside down = inside(row, frame_.rows, ground.edges);
        for (int column = -margin; column < frame_.columns + margin; ++column, ++at) {
            const Inside across = inside(column, frame_.columns, ground.edges);
            if (ground.edges != Edges::open || (across.beyond == 0.0 && down.beyond == 0.0)) {
                source_[at] = frame_.index({across.place, down.place});
            }
            elevation_m_[at] = static_cast<float>(height_beyond(ground, across, down) - lowest_m);
        }
    }
}

PaddedGround::Gradient PaddedGround::gradient(std::size_t column) const {
    const std::size_t at = padded(column);
    const auto rise = [&](std::size_t low, std::size_t high) {
        return (static_cast<double>(elevation_m_[high]) - static_cast<double>(elevation_m_[low])) /
               (2.0 * column_m());
    };
    return {rise(at - 1, at + 1), rise(at + stride_, at - stride_)};
}

Direction PaddedGround::normal(std::size_t column) const {
    const Gradient rise = gradient(column);
    return ground_normal_of_gradient(rise.x, rise.y);
}

}  // namespace forest
