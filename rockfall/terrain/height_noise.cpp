#include "rockfall/terrain/height_noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rockfall/terrain/point_buckets.hpp"

namespace rockfall {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// A patch is about so many points wide [choice]: the median of its values is within 8 % of the noise.
constexpr double patch_width_points = 24.0;
/// Fewer values give no median to rely on [choice].
constexpr std::size_t fewest_values = 30;
/// Median of the absolute value of a normal variate, by its standard deviation.
constexpr double median_of_normal = 0.6744897501960817;

/// The middle one of the values, in an order of its own; not a number of too few.
double median(std::vector<double>& values) {
    if (values.size() < fewest_values) {
        return unknown;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

int patches_over(double points) {
    return std::max(1, static_cast<int>(std::lround(points / patch_width_points)));
}

/// First and last of the patches of a point at this place, counted in patches: both where it lies between
/// two, so that a turned or mirrored terrain has the same patches.
std::array<int, 2> patches_at(double place, int count) {
    constexpr double beside = 1e-6;
    const auto within = [&](double at) { return std::clamp(static_cast<int>(std::floor(at)), 0, count - 1); };
    return {within(place - beside), within(place + beside)};
}

/// Patches without a value take the middle of all others; 0 where there is none.
void fill_unknown(std::vector<PointNoise>& patches, double PointNoise::*value) {
    std::vector<double> known;
    for (const PointNoise& patch : patches) {
        if (std::isfinite(patch.*value)) {
            known.push_back(patch.*value);
        }
    }
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::nth_element(known.begin(), middle, known.end());
    for (PointNoise& patch : patches) {
        if (!std::isfinite(patch.*value)) {
            patch.*value = known.empty() ? 0.0 : *middle;
        }
    }
}

/// Immerkaer's mask at an inner cell: 0 over any sum of a function of x and one of y, and over x y.
double cross_difference(const double* cell, std::ptrdiff_t columns) {
    const auto along = [](const double* at) { return at[-1] - 2.0 * at[0] + at[1]; };
    return along(cell - columns) - 2.0 * along(cell) + along(cell + columns);
}
constexpr double cross_difference_of_noise = 6.0;

/// A neighbour in units of the radius.
struct Near {
    double x;
    double y;
    double z_m;
};

/// How far the height 0 at the origin lies off the quadratic through the neighbours, by what noise of 1
/// leaves; not a number where they fix none.
double off_quadratic_m(std::span<const Near> around) {
    constexpr std::size_t fewest_neighbours = 9;
    if (around.size() < fewest_neighbours) {
        return unknown;
    }
    using Terms = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Terms right = Terms::Zero();
    for (const Near& one : around) {
        const Terms terms{1.0, one.x, one.y, one.x * one.x, one.x * one.y, one.y * one.y};
        normal += terms * terms.transpose();
        right += one.z_m * terms;
    }
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver{normal};
    // Points in one line, or in two, fix no quadratic.
    constexpr double least_pivot = 1e-4;
    if (!(solver.vectorD().minCoeff() > least_pivot)) {
        return unknown;
    }
    const Terms of_height = solver.solve(Terms::Unit(0));  // whose first is the variance of the fit
    return std::abs(of_height.dot(right)) / std::sqrt(1.0 + of_height.x());
}

struct Extent {
    Eigen::Vector2d low_m{0.0, 0.0};
    Eigen::Vector2d size_m{0.0, 0.0};
    std::size_t points = 0;
};

Extent extent_of(std::span<const Eigen::Vector3d> points) {
    Extent extent;
    Eigen::Vector2d high_m{0.0, 0.0};
    for (const Eigen::Vector3d& point : points) {
        if (point.allFinite()) {
            const Eigen::Vector2d place_m = point.head<2>();
            extent.low_m = extent.points == 0 ? place_m : Eigen::Vector2d{extent.low_m.cwiseMin(place_m)};
            high_m = extent.points == 0 ? place_m : Eigen::Vector2d{high_m.cwiseMax(place_m)};
            ++extent.points;
        }
    }
    extent.size_m = high_m - extent.low_m;
    return extent;
}

}  // namespace

HeightNoise::HeightNoise(const config::Raster<double>& heights) : frame_{heights.frame} {
    frame_.columns = patches_over(heights.frame.columns);
    frame_.rows = patches_over(heights.frame.rows);
    frame_.cell_width_m *= static_cast<double>(heights.frame.columns) / frame_.columns;
    frame_.cell_height_m *= static_cast<double>(heights.frame.rows) / frame_.rows;
    const double spacing_m = std::sqrt(heights.frame.cell_area_m2());
    patches_.assign(frame_.size(), {unknown, spacing_m});
    // The cells between two patches belong to both.
    const auto first_of = [](int patch, int patches, int cells) {
        return std::max(1, static_cast<int>(std::ceil(static_cast<double>(patch) * cells / patches - 0.5)));
    };
    const auto end_of = [](int patch, int patches, int cells) {
        return std::min(
            cells - 1,
            static_cast<int>(std::floor(static_cast<double>(patch + 1) * cells / patches - 0.5)) + 1);
    };
    std::vector<double> off_m;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const config::Cell patch = frame_.cell_of(i);
        const int end_row = end_of(patch.row, frame_.rows, heights.frame.rows);
        const int end_column = end_of(patch.column, frame_.columns, heights.frame.columns);
        off_m.clear();
        for (int row = first_of(patch.row, frame_.rows, heights.frame.rows); row < end_row; ++row) {
            for (int column = first_of(patch.column, frame_.columns, heights.frame.columns);
                 column < end_column; ++column) {
                const double off = std::abs(cross_difference(
                    &heights.values[heights.frame.index({column, row})], heights.frame.columns));
                if (std::isfinite(off)) {
                    off_m.push_back(off);
                }
            }
        }
        patches_[i].noise_m = median(off_m) / (cross_difference_of_noise * median_of_normal);
    }
    fill_unknown(patches_, &PointNoise::noise_m);
}

HeightNoise::HeightNoise(std::span<const Eigen::Vector3d> points) {
    const Extent extent = extent_of(points);
    if (!(extent.size_m.prod() > 0.0)) {
        return;
    }
    const double mean_spacing_m = std::sqrt(extent.size_m.prod() / static_cast<double>(extent.points));
    frame_.columns = patches_over(extent.size_m.x() / mean_spacing_m);
    frame_.rows = patches_over(extent.size_m.y() / mean_spacing_m);
    frame_.x_west_m = extent.low_m.x();
    frame_.y_south_m = extent.low_m.y();
    frame_.cell_width_m = extent.size_m.x() / frame_.columns;
    frame_.cell_height_m = extent.size_m.y() / frame_.rows;

    constexpr double radius_spacings = 2.3;  // some 15 neighbours
    const double radius_m = radius_spacings * mean_spacing_m;
    const PointBuckets buckets{points, radius_m};
    std::vector<std::vector<double>> off_m(frame_.size());
    std::vector<std::vector<double>> spacing_m(frame_.size());
    std::vector<Near> around;
    for (const Eigen::Vector3d& point : points) {
        if (!point.allFinite()) {
            continue;
        }
        around.clear();
        buckets.for_each_around(point, [&](std::uint32_t other) {
            const Eigen::Vector3d apart_m = points[other] - point;
            const double distance_m = apart_m.head<2>().norm();
            if (distance_m < radius_m && distance_m > 0.0) {
                around.push_back({apart_m.x() / radius_m, apart_m.y() / radius_m, apart_m.z()});
            }
        });
        const double off = off_quadratic_m(around);
        const auto columns = patches_at((point.x() - frame_.x_west_m) / frame_.cell_width_m, frame_.columns);
        const auto rows = patches_at((frame_.y_north_m() - point.y()) / frame_.cell_height_m, frame_.rows);
        for (int row = rows[0]; row <= rows[1]; ++row) {
            for (int column = columns[0]; column <= columns[1]; ++column) {
                const std::size_t patch = frame_.index({column, row});
                if (std::isfinite(off)) {
                    off_m[patch].push_back(off);
                    spacing_m[patch].push_back(
                        radius_m * std::sqrt(3.14159265358979 / (1.0 + static_cast<double>(around.size()))));
                }
            }
        }
    }
    for (std::size_t i = 0; i < off_m.size(); ++i) {
        patches_.push_back({median(off_m[i]) / median_of_normal, median(spacing_m[i])});
    }
    fill_unknown(patches_, &PointNoise::noise_m);
    fill_unknown(patches_, &PointNoise::spacing_m);
}

PointNoise HeightNoise::at(double x_m, double y_m) const {
    if (patches_.empty()) {
        return {};
    }
    const double column = std::clamp((x_m - frame_.x_west_m) / frame_.cell_width_m - 0.5, 0.0,
                                     static_cast<double>(frame_.columns - 1));
    const double row = std::clamp((frame_.y_north_m() - y_m) / frame_.cell_height_m - 0.5, 0.0,
                                  static_cast<double>(frame_.rows - 1));
    const config::Cell corner{static_cast<int>(column), static_cast<int>(row)};
    const config::Cell far{std::min(corner.column + 1, frame_.columns - 1),
                           std::min(corner.row + 1, frame_.rows - 1)};
    const double east = column - corner.column;
    const double south = row - corner.row;
    const auto between = [&](double PointNoise::*value) {
        const auto of = [&](int c, int r) { return patches_[frame_.index({c, r})].*value; };
        return (1.0 - south) *
                   ((1.0 - east) * of(corner.column, corner.row) + east * of(far.column, corner.row)) +
               south * ((1.0 - east) * of(corner.column, far.row) + east * of(far.column, far.row));
    };
    return {between(&PointNoise::noise_m), between(&PointNoise::spacing_m)};
}

}  // namespace rockfall
