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
#include "rockfall/terrain/point_buckets.hpp"
#include "rockfall/terrain/zone_points.hpp"

namespace rockfall {
namespace {

/// Faces that differ by more are those of a wall and what it stands on [choice].
const config::SinCos break_angle = config::sin_cos_of(config::Angle::from_degrees(25.0).in_radians());
const double tangent_of_break = break_angle.sin / break_angle.cos;
/// A step between two even sides, by the radius of the zone.
constexpr double highest_step_share = 0.25;
/// Residual beside a single plane, by the radius, below which no such break can be there: the best plane
/// through a roof of twice 17.5 degrees leaves 0.2 at its border, 0.08 where it holds few points.
constexpr double least_residual_share = 0.05;
/// The zone shrinks by this factor until it lies on one face.
constexpr double narrower = 0.7;
/// What noise alone reaches once in a million cases is no break: so many standard deviations.
constexpr double surely = 5.0;
constexpr double likely = 3.5;
/// Noise of 1 at points 1 apart leaves this, in a zone of radius r, in the planes of two halves: in the
/// difference of their heights at the centre by r, of their slopes by r^2 (integrals over half a disc).
constexpr double step_of_noise = 2.84;
constexpr double bend_of_noise = 6.98;
/// Mean square residual by that of noise: a zone with less is of one face, without a closer look; half of a
/// zone, of fewer points, is with less than the other.
constexpr double even_mean_square = 1.1;
constexpr double half_mean_square = 1.6;

/// The zone of one point: its radius, and the noise of the heights in it.
struct Zone {
    double radius_m;
    PointNoise ground;

    /// A single point that lies off by so much is none of noise.
    [[nodiscard]] double least_off_m() const {
        return std::max(highest_step_share * radius_m, surely * ground.noise_m);
    }
    /// Off a face, a point has no weight in its plane.
    [[nodiscard]] double most_off_face_m() const {
        return std::max(least_residual_share * radius_m, likely * ground.noise_m);
    }
    [[nodiscard]] double least_step_m() const {
        return std::max(highest_step_share * radius_m,
                        likely * step_of_noise * ground.noise_m * ground.spacing_m / radius_m);
    }
    [[nodiscard]] double cosine_of_break() const {
        const double tangent = std::max(tangent_of_break, likely * bend_of_noise * ground.noise_m *
                                                              ground.spacing_m / (radius_m * radius_m));
        return 1.0 / std::sqrt(1.0 + tangent * tangent);
    }
    /// Whether residuals beside a plane, the largest and the mean square, rule out a break.
    [[nodiscard]] bool is_even(double largest_m, double mean_square_m2, double most_mean_square) const {
        return largest_m < least_residual_share * radius_m ||
               (largest_m < surely * ground.noise_m &&
                mean_square_m2 < most_mean_square * ground.noise_m * ground.noise_m);
    }
};

/// A cell of the contact zone as seen from its centre.
struct Neighbour {
    int columns;           ///< to the east
    int rows;              ///< to the south
    std::ptrdiff_t index;  ///< difference of place in the raster
    double x_m;
    double y_m;
    double distance_m;
};

/// All cells but the centre within the radius, the nearest first.
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
                neighbours.push_back({column, row, index, x_m, y_m, distance_m});
            }
        }
    }
    std::stable_sort(neighbours.begin(), neighbours.end(),
                     [](const Neighbour& a, const Neighbour& b) { return a.distance_m < b.distance_m; });
    return neighbours;
}

/// What a plane leaves of the points it was fitted to.
struct Residuals {
    double largest_m = 0.0;
    double squares_m2 = 0.0;
    std::size_t count = 0;

    void add(double off_m) {
        largest_m = std::max(largest_m, std::abs(off_m));
        squares_m2 += off_m * off_m;
        ++count;
    }
    [[nodiscard]] double mean_square_m2() const { return squares_m2 / static_cast<double>(count); }
};

double off_m(const Eigen::Vector3d& plane, const PointApart& point) {
    return point.z_m - plane.z() - plane.x() * point.x_m - plane.y() * point.y_m;
}

/// A part of a zone: all of it, or what lies on one side of a line through the centre, with the points on it.
struct Part {
    std::span<const PointApart> around;
    Eigen::Vector2d inwards{0.0, 0.0};  ///< all of it: zero

    template <class Visit>
    void for_each(double radius_m, Visit visit) const {
        for (const PointApart& one : around) {
            const double inside_m = inwards.x() * one.x_m + inwards.y() * one.y_m;
            if (one.distance_m < radius_m && inside_m > -1e-6 * radius_m) {
                visit(one);
            }
        }
    }
    [[nodiscard]] Residuals beside(const Eigen::Vector3d& plane, double radius_m) const {
        Residuals residuals;
        residuals.add(plane.z());
        for_each(radius_m, [&](const PointApart& one) { residuals.add(off_m(plane, one)); });
        return residuals;
    }
};

/// Whether two planes are those of two faces: their slopes differ, or one lies above the other by a step.
bool is_break(const Eigen::Vector3d& one, const Eigen::Vector3d& other, const Zone& zone) {
    const Eigen::Vector3d normal = Eigen::Vector3d{-one.x(), -one.y(), 1.0}.normalized();
    const Eigen::Vector3d other_normal = Eigen::Vector3d{-other.x(), -other.y(), 1.0}.normalized();
    return normal.dot(other_normal) < zone.cosine_of_break() ||
           std::abs(one.z() - other.z()) > zone.least_step_m();
}

/// Whether a point lies on another face than the plane: off it by a step, and steeply so as seen from the
/// centre. Finds a wall that only reaches into the zone.
bool has_point_off(const Eigen::Vector3d& plane, std::span<const PointApart> around, const Zone& zone) {
    const double least_off_m = zone.least_off_m();
    return std::any_of(around.begin(), around.end(), [&](const PointApart& one) {
        return one.distance_m < zone.radius_m &&
               std::abs(off_m(plane, one)) > std::max(tangent_of_break * one.distance_m, least_off_m);
    });
}

bool is_broken(const ZoneHalves& halves, const Zone& zone) {
    for (std::size_t i = 0; i < 8; ++i) {
        if (halves[i] && halves[i + 8] && is_break(*halves[i], *halves[i + 8], zone)) {
            return true;
        }
    }
    return false;
}

/// The plane of the half that lies on one face; nothing where none does.
std::optional<Eigen::Vector3d> half_on_one_face(const ZoneHalves& halves, std::span<const PointApart> around,
                                                const Zone& zone) {
    std::optional<Eigen::Vector3d> best;
    double least_m2 = 0.0;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        if (halves[i]) {
            const Residuals beside = Part{around, zone_directions()[i]}.beside(*halves[i], zone.radius_m);
            if (zone.is_even(beside.largest_m, beside.mean_square_m2(), half_mean_square) &&
                (!best || beside.mean_square_m2() < least_m2)) {
                best = halves[i];
                least_m2 = beside.mean_square_m2();
            }
        }
    }
    return best;
}

/// The plane through all points of a zone that lie on the face of a plane, which is that of a half. Halves of
/// neighbouring points may be others, their faces are the same.
std::optional<Eigen::Vector3d> plane_of_face(const Eigen::Vector3d& face, std::span<const PointApart> around,
                                             const Zone& zone) {
    const double most_m = zone.most_off_face_m();
    const auto share_on_face = [&](double off_m) {
        const double ratio = off_m / most_m;
        return std::abs(ratio) < 1.0 ? (1.0 - ratio * ratio) * (1.0 - ratio * ratio) : 0.0;
    };
    LocalPlane plane;
    const auto add = [&](const PointApart& one) {
        const double weight = tricube(one.distance_m, zone.radius_m) * share_on_face(off_m(face, one));
        if (weight > 0.0) {
            plane.add(one.x_m, one.y_m, one.z_m, weight);
        }
    };
    add({0.0, 0.0, 0.0, 0.0});
    std::for_each(around.begin(), around.end(), add);
    return plane.fit();
}

/// Height of the fitted plane above the centre, within the widest zone, or half of one, that lies on one
/// face.
double shift_on_one_face_m(std::span<const PointApart> around, Zone zone, WeighedPoints& weighed) {
    while (true) {
        weighed.weigh(around, zone.radius_m);
        const std::optional<Eigen::Vector3d> plane = weighed.plane();
        if (!plane) {
            return 0.0;
        }
        const Residuals beside = Part{around}.beside(*plane, zone.radius_m);
        if (zone.is_even(beside.largest_m, beside.mean_square_m2(), even_mean_square)) {
            return plane->z();
        }
        const ZoneHalves halves = weighed.halves();
        if (!is_broken(halves, zone) && !has_point_off(*plane, around, zone)) {
            return plane->z();
        }
        if (const auto half = half_on_one_face(halves, around, zone)) {
            return plane_of_face(*half, around, zone).value_or(*half).z();
        }
        zone.radius_m *= narrower;
    }
}

/// The points around a cell; those of missing heights left out.
void gather(const config::Raster<double>& heights, config::Cell centre, std::span<const Neighbour> neighbours,
            double radius_m, std::vector<PointApart>& around) {
    around.clear();
    for (const Neighbour& neighbour : neighbours) {
        if (neighbour.distance_m >= radius_m) {
            break;
        }
        const config::Cell cell{centre.column + neighbour.columns, centre.row + neighbour.rows};
        if (heights.frame.contains(cell) && std::isfinite(heights.at(cell))) {
            around.push_back(
                {neighbour.x_m, neighbour.y_m, heights.at(cell) - heights.at(centre), neighbour.distance_m});
        }
    }
}

/// Height of the plane above a cell whose neighbours are all there, where nothing hints at a break; nothing
/// else, or with a gap. The places balance, so that the plane is three sums.
std::optional<double> even_shift_m(const config::Raster<double>& heights, std::size_t centre,
                                   std::span<const Neighbour> neighbours, const Zone& zone) {
    const config::GridFrame& frame = heights.frame;
    const config::Cell cell = frame.cell_of(centre);
    const int columns = static_cast<int>(zone.radius_m / frame.cell_width_m);
    const int rows = static_cast<int>(zone.radius_m / frame.cell_height_m);
    if (!frame.contains({cell.column - columns, cell.row - rows}) ||
        !frame.contains({cell.column + columns, cell.row + rows})) {
        return std::nullopt;
    }
    const double* const here = &heights.values[centre];
    double weights = 1.0;  // of the centre
    double z = 0.0, xz = 0.0, yz = 0.0, xx = 0.0, yy = 0.0;
    std::size_t count = 0;
    for (; count < neighbours.size() && neighbours[count].distance_m < zone.radius_m; ++count) {
        const Neighbour& one = neighbours[count];
        const double weight = tricube(one.distance_m, zone.radius_m);
        const double weighted_m = weight * (here[one.index] - *here);
        weights += weight;
        z += weighted_m;
        xz += weighted_m * one.x_m;
        yz += weighted_m * one.y_m;
        xx += weight * one.x_m * one.x_m;
        yy += weight * one.y_m * one.y_m;
    }
    if (!(xx > 0.0 && yy > 0.0)) {
        return std::nullopt;
    }
    const double shift_m = z / weights;
    const double along_x = xz / xx;
    const double along_y = yz / yy;
    Residuals beside;
    beside.add(shift_m);
    for (const Neighbour& one : neighbours.first(count)) {
        beside.add(here[one.index] - *here - shift_m - along_x * one.x_m - along_y * one.y_m);
    }
    // A missing height makes the shift NaN.
    return std::isfinite(shift_m) && zone.is_even(beside.largest_m, beside.mean_square_m2(), even_mean_square)
               ? std::optional{shift_m}
               : std::nullopt;
}

double largest_radius_m(const ContactLaw& law, const HeightNoise& noise) {
    double largest_m = law.radius_m({});
    for (const PointNoise& patch : noise.patches()) {
        largest_m = std::max(largest_m, law.radius_m(patch));
    }
    return largest_m;
}

/// Between neighbouring patches the root of the mean product may be larger than both.
constexpr double between_patches = 1.2;

}  // namespace

double ContactLaw::radius_m(const PointNoise& ground) const {
    if (given_radius_m) {
        return *given_radius_m;
    }
    // Wider only where heights are hardly those of any ground; it bounds the time.
    constexpr double most_spacings = 10.0;
    const double for_noise_m = std::sqrt(slope_of_noise * ground.noise_m * ground.spacing_m / slope_error);
    return std::max(least_radius_m, std::min(for_noise_m, most_spacings * ground.spacing_m));
}

config::Raster<double> contact_zone(const config::Raster<double>& heights, const ContactLaw& law,
                                    const HeightNoise& noise) {
    config::Raster<double> felt = heights;
    if (law.moves_nothing()) {
        return felt;
    }
    const std::vector<Neighbour> neighbours =
        neighbours_within(heights.frame, between_patches * largest_radius_m(law, noise));
    std::vector<PointApart> around;
    WeighedPoints weighed;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        if (!std::isfinite(heights.values[i])) {
            continue;
        }
        const config::Cell cell = heights.frame.cell_of(i);
        const PointNoise ground =
            noise.at(heights.frame.x_centre_m(cell.column), heights.frame.y_centre_m(cell.row));
        const Zone zone{law.radius_m(ground), ground};
        std::optional<double> shift_m = even_shift_m(heights, i, neighbours, zone);
        if (!shift_m) {
            gather(heights, cell, neighbours, zone.radius_m, around);
            shift_m = shift_on_one_face_m(around, zone, weighed);
        }
        felt.values[i] += law.cut(*shift_m, ground);
    }
    return felt;
}

std::vector<Eigen::Vector3d> contact_zone(std::span<const Eigen::Vector3d> points, const ContactLaw& law,
                                          const HeightNoise& noise) {
    std::vector<Eigen::Vector3d> felt{points.begin(), points.end()};
    if (law.moves_nothing()) {
        return felt;
    }
    const PointBuckets buckets{points, between_patches * largest_radius_m(law, noise)};
    std::vector<PointApart> around;
    WeighedPoints weighed;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite()) {
            continue;
        }
        const PointNoise ground = noise.at(points[i].x(), points[i].y());
        const Zone zone{law.radius_m(ground), ground};
        around.clear();
        buckets.for_each_around(points[i], [&](std::uint32_t other) {
            const Eigen::Vector3d apart_m = points[other] - points[i];
            const double distance_m = apart_m.head<2>().norm();
            if (other != i && distance_m < zone.radius_m) {
                around.push_back({apart_m.x(), apart_m.y(), apart_m.z(), distance_m});
            }
        });
        felt[i].z() += law.cut(shift_on_one_face_m(around, zone, weighed), ground);
    }
    return felt;
}

}  // namespace rockfall
