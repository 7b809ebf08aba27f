#include "rockfall/terrain/contact_zone.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "rockfall/terrain/local_plane.hpp"

namespace rockfall {
namespace {

/// Cleveland 1979: 1 at the centre, 0 from the radius on, smooth at both.
double tricube(double distance_m, double radius_m) {
    const double ratio = distance_m / radius_m;
    const double rest = 1.0 - ratio * ratio * ratio;
    return ratio < 1.0 ? rest * rest * rest : 0.0;
}

/// A cell of the contact zone as seen from its centre.
struct Neighbour {
    int columns;           ///< to the east
    int rows;              ///< to the south
    std::ptrdiff_t index;  ///< difference of place in the raster
    double x_m;
    double y_m;
    double weight;
};

/// All cells but the centre with a weight.
std::vector<Neighbour> neighbours_within(const config::GridFrame& frame, double radius_m) {
    const int columns = static_cast<int>(std::min(radius_m / frame.cell_width_m, 1.0 * frame.columns));
    const int rows = static_cast<int>(std::min(radius_m / frame.cell_height_m, 1.0 * frame.rows));
    std::vector<Neighbour> neighbours;
    for (int row = -rows; row <= rows; ++row) {
        for (int column = -columns; column <= columns; ++column) {
            const double x_m = column * frame.cell_width_m;
            const double y_m = -row * frame.cell_height_m;
            const double weight = tricube(std::sqrt(x_m * x_m + y_m * y_m), radius_m);
            if (weight > 0.0 && (column != 0 || row != 0)) {
                const std::ptrdiff_t index = static_cast<std::ptrdiff_t>(row) * frame.columns + column;
                neighbours.push_back({column, row, index, x_m, y_m, weight});
            }
        }
    }
    return neighbours;
}

/// Shift with all neighbours known: their places balance, so the plane's height at the centre is the weighted
/// mean. NaN if one is missing after all.
double balanced_shift_m(const double* centre, std::span<const Neighbour> neighbours) {
    double weights = 1.0;
    double sum_m = 0.0;
    for (const Neighbour& neighbour : neighbours) {
        weights += neighbour.weight;
        sum_m += neighbour.weight * (centre[neighbour.index] - *centre);
    }
    return sum_m / weights;
}

double shift_beside_gap_m(const config::Raster<double>& heights, config::Cell centre,
                          std::span<const Neighbour> neighbours) {
    LocalPlane plane;
    plane.add(0.0, 0.0, 0.0, 1.0);
    for (const Neighbour& neighbour : neighbours) {
        const config::Cell cell{centre.column + neighbour.columns, centre.row + neighbour.rows};
        if (heights.frame.contains(cell) && std::isfinite(heights.at(cell))) {
            plane.add(neighbour.x_m, neighbour.y_m, heights.at(cell) - heights.at(centre), neighbour.weight);
        }
    }
    return plane.height_at_centre_m().value_or(0.0);
}

/// Points sorted into square cells at least as wide as the contact zone, so that it lies within 3 x 3 of
/// them.
class Buckets {
public:
    Buckets(std::span<const Eigen::Vector3d> points, double radius_m) : points_{points} {
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            if (points[i].allFinite()) {
                members_.push_back(i);
            }
        }
        place_frame(radius_m);
        first_.assign(frame_.size() + 1, 0);
        std::vector<std::uint32_t> bucket(points.size());
        for (const std::uint32_t i : members_) {
            bucket[i] =
                static_cast<std::uint32_t>(frame_.index(frame_.cell_at(points[i].x(), points[i].y())));
            ++first_[bucket[i] + 1];
        }
        for (std::size_t i = 1; i < first_.size(); ++i) {
            first_[i] += first_[i - 1];
        }
        std::stable_sort(members_.begin(), members_.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return bucket[a] < bucket[b]; });
    }

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
    void place_frame(double radius_m) {
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
        // A small radius in a wide extent must not make more buckets than there are points, by side or by
        // area.
        const double count = static_cast<double>(members_.size());
        const double width_m =
            std::max({radius_m, std::sqrt(extent_m.prod() / count), extent_m.maxCoeff() / count}) *
            (1.0 + 1e-9);
        frame_ = {.columns = static_cast<int>(extent_m.x() / width_m) + 2,
                  .rows = static_cast<int>(extent_m.y() / width_m) + 2,
                  .x_west_m = low_m.x() - 0.5 * width_m,
                  .y_south_m = low_m.y() - 0.5 * width_m,
                  .cell_width_m = width_m,
                  .cell_height_m = width_m};
    }

    std::span<const Eigen::Vector3d> points_;
    config::GridFrame frame_;
    std::vector<std::uint32_t> first_;    ///< place of the first member of each bucket; one more at the end
    std::vector<std::uint32_t> members_;  ///< finite points, bucket after bucket
};

bool moves_nothing(double support_radius_m, double largest_shift_m) {
    return !(support_radius_m > 0.0) || !(largest_shift_m > 0.0);
}

}  // namespace

config::Raster<double> contact_zone(const config::Raster<double>& heights, double support_radius_m,
                                    double largest_shift_m) {
    config::Raster<double> felt = heights;
    if (moves_nothing(support_radius_m, largest_shift_m)) {
        return felt;
    }
    const config::GridFrame& frame = heights.frame;
    const std::vector<Neighbour> neighbours = neighbours_within(frame, support_radius_m);
    int reach_columns = 0;
    int reach_rows = 0;
    for (const Neighbour& neighbour : neighbours) {
        reach_columns = std::max(reach_columns, neighbour.columns);
        reach_rows = std::max(reach_rows, neighbour.rows);
    }
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        if (!std::isfinite(heights.values[i])) {
            continue;
        }
        const config::Cell cell = frame.cell_of(i);
        const bool is_inside = frame.contains({cell.column - reach_columns, cell.row - reach_rows}) &&
                               frame.contains({cell.column + reach_columns, cell.row + reach_rows});
        double shift_m = is_inside ? balanced_shift_m(&heights.values[i], neighbours) : std::nan("");
        if (!std::isfinite(shift_m)) {
            shift_m = shift_beside_gap_m(heights, cell, neighbours);
        }
        felt.values[i] += std::clamp(shift_m, -largest_shift_m, largest_shift_m);
    }
    return felt;
}

std::vector<Eigen::Vector3d> contact_zone(std::span<const Eigen::Vector3d> points, double support_radius_m,
                                          double largest_shift_m) {
    std::vector<Eigen::Vector3d> felt{points.begin(), points.end()};
    if (moves_nothing(support_radius_m, largest_shift_m)) {
        return felt;
    }
    const Buckets buckets{points, support_radius_m};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite()) {
            continue;
        }
        LocalPlane plane;
        buckets.for_each_around(points[i], [&](std::uint32_t other) {
            const Eigen::Vector3d apart_m = points[other] - points[i];
            const double weight = tricube(apart_m.head<2>().norm(), support_radius_m);
            if (weight > 0.0) {
                plane.add(apart_m.x(), apart_m.y(), apart_m.z(), weight);
            }
        });
        const double shift_m = plane.height_at_centre_m().value_or(0.0);
        felt[i].z() += std::clamp(shift_m, -largest_shift_m, largest_shift_m);
    }
    return felt;
}

}  // namespace rockfall
