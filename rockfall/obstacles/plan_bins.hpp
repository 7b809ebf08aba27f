#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// A box in plan, in coordinates of the terrain.
struct PlanBox {
    double west_m;
    double south_m;
    double east_m;
    double north_m;

    [[nodiscard]] bool has(double x_m, double y_m) const {
        return x_m > west_m && x_m < east_m && y_m > south_m && y_m < north_m;
    }
    /// The same, larger by so much on each side.
    [[nodiscard]] PlanBox widened(double by_m) const {
        return {west_m - by_m, south_m - by_m, east_m + by_m, north_m + by_m};
    }
};

/// A straight path in plan.
struct PlanLine {
    double x_m, y_m;                  ///< start
    double direction_x, direction_y;  ///< unit vector
    double length_m;
};

/// Things found by place: each is entered, by its number, in every bin that its box touches.
///
/// A box widened by the largest rock's radius lets a query look only into the bins under the path of the
/// rock's centre and still see whatever the rock's edge can touch, however much lies in a bin.
class PlanBins {
public:
    PlanBins() = default;
    /// A box whose west lies east of its east is nowhere: its thing is entered in no bin.
    explicit PlanBins(std::span<const PlanBox> boxes);

    /// Calls look_into(numbers) for the bins under a path in their order. It returns how far along the path
    /// the first thing found so far is met [m], infinity for none; bins beyond that are left out.
    template <class LookInto>
    void walk(const PlanLine& path, LookInto look_into) const {
        constexpr double never = std::numeric_limits<double>::infinity();
        constexpr double bins_per_m = 1.0 / bin_size_m;
        // Place in units of bins, from the north-western corner: columns to the east, rows to the south.
        const double column = (path.x_m - frame_.x_west_m) * bins_per_m;
        const double row = (frame_.y_north_m() - path.y_m) * bins_per_m;
        config::Cell cell{static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row))};
        const int step_column = path.direction_x >= 0.0 ? 1 : -1;
        const int step_row = path.direction_y >= 0.0 ? -1 : 1;
        // Distance along the path from one bin border to the next, and to the first one.
        const double per_column_m = path.direction_x != 0.0 ? bin_size_m / std::abs(path.direction_x) : never;
        const double per_row_m = path.direction_y != 0.0 ? bin_size_m / std::abs(path.direction_y) : never;
        const double into_column = step_column > 0 ? cell.column + 1 - column : column - cell.column;
        const double into_row = step_row > 0 ? cell.row + 1 - row : row - cell.row;
        double to_column_m = path.direction_x != 0.0 ? into_column * per_column_m : never;
        double to_row_m = path.direction_y != 0.0 ? into_row * per_row_m : never;
        double met_m = never;
        while (true) {
            if (frame_.contains(cell)) {
                const std::size_t bin = frame_.index(cell);
                met_m = look_into(std::span<const std::uint32_t>{numbers_.data() + bin_start_[bin],
                                                                 numbers_.data() + bin_start_[bin + 1]});
            }
            const double next_border_m = std::min(to_column_m, to_row_m);
            // What is met before the border of this bin cannot be undercut by things of a later one.
            if (next_border_m >= path.length_m || met_m <= next_border_m) {
                return;
            }
            if (to_column_m <= to_row_m) {
                cell.column += step_column;
                to_column_m += per_column_m;
            } else {
                cell.row += step_row;
                to_row_m += per_row_m;
            }
        }
    }

    /// A bin but for its border, where rounding may lead into the next one, and what a path in it may meet.
    struct Bin {
        PlanBox inside;
        std::span<const std::uint32_t> numbers;
    };
    /// The bin under a place; nothing beside all.
    [[nodiscard]] std::optional<Bin> bin_at(double x_m, double y_m) const {
        constexpr double bins_per_m = 1.0 / bin_size_m;
        const double column = std::floor((x_m - frame_.x_west_m) * bins_per_m);
        const double row = std::floor((frame_.y_north_m() - y_m) * bins_per_m);
        if (!(column >= 0.0 && column < frame_.columns && row >= 0.0 && row < frame_.rows)) {
            return std::nullopt;
        }
        const std::size_t bin = frame_.index({static_cast<int>(column), static_cast<int>(row)});
        constexpr double border_m = 1e-6 * bin_size_m;
        const double west_m = frame_.x_west_m + column * bin_size_m;
        const double north_m = frame_.y_north_m() - row * bin_size_m;
        return Bin{PlanBox{west_m, north_m - bin_size_m, west_m + bin_size_m, north_m}.widened(-border_m),
                   std::span{numbers_}.subspan(bin_start_[bin], bin_start_[bin + 1] - bin_start_[bin])};
    }

private:
    static constexpr double bin_size_m = 5.0;

    config::GridFrame frame_;
    std::vector<std::uint32_t> bin_start_;
    std::vector<std::uint32_t> numbers_;
};

}  // namespace rockfall
