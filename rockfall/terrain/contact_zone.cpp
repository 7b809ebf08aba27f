#include "rockfall/terrain/contact_zone.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"
#include "rockfall/terrain/local_plane.hpp"

namespace rockfall {
namespace {

/// Cleveland 1979: 1 at the centre, 0 from the radius on, smooth at both.
double tricube(double distance_m, double radius_m) {
    const double ratio = distance_m / radius_m;
    const double rest = 1.0 - ratio * ratio * ratio;
    return ratio < 1.0 ? rest * rest * rest : 0.0;
}

/// Faces that differ by more are those of a wall and what it stands on [choice; steeper than any talus].
const config::SinCos break_angle = config::sin_cos_of(config::Angle::from_degrees(35.0).in_radians());
const double cosine_of_break = break_angle.cos;
const double tangent_of_break = break_angle.sin / break_angle.cos;
/// A step between two even sides, by the radius of the zone.
constexpr double highest_step_share = 0.25;
/// Residual beside a single plane, by the radius, below which no such break can be there: the best plane
/// through a roof of twice 17.5 degrees leaves 0.2 at its border.
constexpr double least_residual_share = 0.12;
/// The zone shrinks by this factor until it lies on one face.
constexpr double narrower = 0.7;

/// A cell of the contact zone as seen from its centre.
struct Neighbour {
    int columns;           ///< to the east
    int rows;              ///< to the south
    std::ptrdiff_t index;  ///< difference of place in the raster
    double x_m;
    double y_m;
    double distance_m;
    double weight;
};

/// All cells but the centre within the radius.
std::vector<Neighbour> neighbours_within(const config::GridFrame& frame, double radius_m) {
    const int columns = static_cast<int>(std::min(radius_m / frame.cell_width_m, 1.0 * frame.columns));
    const int rows = static_cast<int>(std::min(radius_m / frame.cell_height_m, 1.0 * frame.rows));
    std::vector<Neighbour> neighbours;
    for (int row = -rows; row <= rows; ++row) {
        for (int column = -columns; column <= columns; ++column) {
            const double x_m = column * frame.cell_width_m;
            const double y_m = -row * frame.cell_height_m;
            const double distance_m = std::sqrt(x_m * x_m + y_m * y_m);
            if (distance_m < radius_m && (column != 0 || row != 0)) {
                const std::ptrdiff_t index = static_cast<std::ptrdiff_t>(row) * frame.columns + column;
                neighbours.push_back(
                    {column, row, index, x_m, y_m, distance_m, tricube(distance_m, radius_m)});
            }
        }
    }
    return neighbours;
}

/// A point as seen from the one whose contact zone it is in, and its distance in plan.
struct Apart {
    double x_m;
    double y_m;
    double z_m;
    double distance_m;
};

/// Whether the ground on the two sides of a line through the centre is that of two faces: planes fitted to
/// either side differ in their slope, or one lies above the other by a step. `if_few` where the points of a
/// side fix no plane.
bool is_broken_along(const Eigen::Vector2d& across, std::span<const Apart> around, double radius_m,
                     bool if_few) {
    LocalPlane ahead;
    LocalPlane behind;
    for (const Apart& one : around) {
        const double weight = tricube(one.distance_m, radius_m);
        const double side_m = across.x() * one.x_m + across.y() * one.y_m;
        if (weight > 0.0 && std::abs(side_m) > 1e-6 * radius_m) {
            (side_m > 0.0 ? ahead : behind).add(one.x_m, one.y_m, one.z_m, weight);
        }
    }
    const std::optional<Eigen::Vector3d> one = ahead.fit();
    const std::optional<Eigen::Vector3d> other = behind.fit();
    if (!one || !other) {
        return if_few;
    }
    const Eigen::Vector3d normal = Eigen::Vector3d{-one->x(), -one->y(), 1.0}.normalized();
    const Eigen::Vector3d other_normal = Eigen::Vector3d{-other->x(), -other->y(), 1.0}.normalized();
    return normal.dot(other_normal) < cosine_of_break ||
           std::abs(one->z() - other->z()) > highest_step_share * radius_m;
}

/// Whether a point lies on another face than the plane: off it by a step, and steeply so as seen from the
/// centre. Finds a wall that only reaches into the zone.
bool has_point_off(const Eigen::Vector3d& plane, std::span<const Apart> around, double radius_m) {
    return std::any_of(around.begin(), around.end(), [&](const Apart& one) {
        const double off_m = std::abs(one.z_m - plane.z() - plane.x() * one.x_m - plane.y() * one.y_m);
        return one.distance_m < radius_m &&
               off_m > std::max(tangent_of_break * one.distance_m, highest_step_share * radius_m);
    });
}

bool is_broken(const Eigen::Vector3d& plane, std::span<const Apart> around, double radius_m, bool if_few) {
    static constexpr double diagonal = std::numbers::sqrt2 / 2.0;
    static const std::array<Eigen::Vector2d, 4> lines{
        {{1.0, 0.0}, {0.0, 1.0}, {diagonal, diagonal}, {diagonal, -diagonal}}};
    return has_point_off(plane, around, radius_m) ||
           std::any_of(lines.begin(), lines.end(), [&](const Eigen::Vector2d& across) {
               return is_broken_along(across, around, radius_m, if_few);
           });
}

std::optional<Eigen::Vector3d> plane_within(std::span<const Apart> around, double radius_m) {
    LocalPlane plane;
    plane.add(0.0, 0.0, 0.0, 1.0);
    for (const Apart& one : around) {
        const double weight = tricube(one.distance_m, radius_m);
        if (weight > 0.0) {
            plane.add(one.x_m, one.y_m, one.z_m, weight);
        }
    }
    return plane.fit();
}

double largest_residual_m(std::span<const Apart> around, const Eigen::Vector3d& plane) {
    double largest_m = std::abs(plane.z());
    for (const Apart& one : around) {
        largest_m =
            std::max(largest_m, std::abs(one.z_m - plane.z() - plane.x() * one.x_m - plane.y() * one.y_m));
    }
    return largest_m;
}

/// Height of the fitted plane above the centre, within the widest zone that lies on one face.
double shift_on_one_face_m(std::span<const Apart> around, double radius_m) {
    std::optional<Eigen::Vector3d> plane = plane_within(around, radius_m);
    // Two faces that differ by the angle of a break leave at least this much beside a single plane.
    if (!plane || largest_residual_m(around, *plane) < least_residual_share * radius_m) {
        return plane ? plane->z() : 0.0;
    }
    // The first zone may hold few points because the cells are wide; a narrowed one that does lies at a
    // break.
    for (bool narrowed = false; plane && is_broken(*plane, around, radius_m, narrowed); narrowed = true) {
        radius_m *= narrower;
        plane = plane_within(around, radius_m);
    }
    return plane ? plane->z() : 0.0;
}

/// The points around a cell; those of missing heights left out.
void gather(const config::Raster<double>& heights, config::Cell centre, std::span<const Neighbour> neighbours,
            std::vector<Apart>& around) {
    around.clear();
    for (const Neighbour& neighbour : neighbours) {
        const config::Cell cell{centre.column + neighbour.columns, centre.row + neighbour.rows};
        if (heights.frame.contains(cell) && std::isfinite(heights.at(cell))) {
            around.push_back(
                {neighbour.x_m, neighbour.y_m, heights.at(cell) - heights.at(centre), neighbour.distance_m});
        }
    }
}

/// The zone of cells whose neighbours are all there: their places balance, so that the plane is three sums.
class WholeZone {
public:
    WholeZone(const config::GridFrame& frame, std::span<const Neighbour> neighbours, double radius_m)
        : frame_{frame}, neighbours_{neighbours}, least_residual_m_{least_residual_share * radius_m} {
        for (const Neighbour& one : neighbours) {
            reach_columns_ = std::max(reach_columns_, one.columns);
            reach_rows_ = std::max(reach_rows_, one.rows);
            weights_ += one.weight;
            xx_ += one.weight * one.x_m * one.x_m;
            yy_ += one.weight * one.y_m * one.y_m;
        }
    }

    /// Height of the plane above the centre where nothing hints at a break; nothing else, or with a gap.
    [[nodiscard]] std::optional<double> even_shift_m(const config::Raster<double>& heights,
                                                     std::size_t centre) const {
        const config::Cell cell = frame_.cell_of(centre);
        if (!frame_.contains({cell.column - reach_columns_, cell.row - reach_rows_}) ||
            !frame_.contains({cell.column + reach_columns_, cell.row + reach_rows_}) || xx_ <= 0.0 ||
            yy_ <= 0.0) {
            return std::nullopt;
        }
        const double* const here = &heights.values[centre];
        double z = 0.0;
        double xz = 0.0;
        double yz = 0.0;
        for (const Neighbour& one : neighbours_) {
            const double weighted_m = one.weight * (here[one.index] - *here);
            z += weighted_m;
            xz += weighted_m * one.x_m;
            yz += weighted_m * one.y_m;
        }
        const double shift_m = z / weights_;
        const double along_x = xz / xx_;
        const double along_y = yz / yy_;
        double largest_m = std::abs(shift_m);
        for (const Neighbour& one : neighbours_) {
            const double beside_m = here[one.index] - *here - shift_m - along_x * one.x_m - along_y * one.y_m;
            largest_m = std::max(largest_m, std::abs(beside_m));
        }
        // A missing height makes the shift NaN, which compares false.
        return largest_m < least_residual_m_ && std::isfinite(shift_m) ? std::optional{shift_m}
                                                                       : std::nullopt;
    }

private:
    const config::GridFrame& frame_;
    std::span<const Neighbour> neighbours_;
    double least_residual_m_;
    int reach_columns_ = 0;
    int reach_rows_ = 0;
    double weights_ = 1.0;  // of the centre
    double xx_ = 0.0;
    double yy_ = 0.0;
};

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
    const std::vector<Neighbour> neighbours = neighbours_within(heights.frame, support_radius_m);
    const WholeZone whole{heights.frame, neighbours, support_radius_m};
    std::vector<Apart> around;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        if (!std::isfinite(heights.values[i])) {
            continue;
        }
        std::optional<double> shift_m = whole.even_shift_m(heights, i);
        if (!shift_m) {
            gather(heights, heights.frame.cell_of(i), neighbours, around);
            shift_m = shift_on_one_face_m(around, support_radius_m);
        }
        felt.values[i] += std::clamp(*shift_m, -largest_shift_m, largest_shift_m);
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
    std::vector<Apart> around;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite()) {
            continue;
        }
        around.clear();
        buckets.for_each_around(points[i], [&](std::uint32_t other) {
            const Eigen::Vector3d apart_m = points[other] - points[i];
            const double distance_m = apart_m.head<2>().norm();
            if (other != i && distance_m < support_radius_m) {
                around.push_back({apart_m.x(), apart_m.y(), apart_m.z(), distance_m});
            }
        });
        felt[i].z() +=
            std::clamp(shift_on_one_face_m(around, support_radius_m), -largest_shift_m, largest_shift_m);
    }
    return felt;
}

}  // namespace rockfall
