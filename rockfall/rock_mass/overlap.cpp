#include "rockfall/rock_mass/overlap.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "rockfall/rock_mass/vertex_sides.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

Eigen::Matrix3d cross_matrix(const Vector3d& v) {
    Eigen::Matrix3d matrix;
    matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return matrix;
}

double lowest_over(const Plane3& face, std::span<const Vector3d> vertices_m) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vector3d& vertex_m : vertices_m) {
        lowest = std::min(lowest, face.normal.dot(vertex_m));
    }
    return lowest - face.offset_m;
}

/// How far two blocks are apart midway between the normals of two faces of the first one.
double apart_across_edge_m(const PlacedBlock& owner, const PlacedBlock& other, std::size_t face,
                           std::size_t other_face) {
    Plane3 plane{owner.faces[face].normal + owner.faces[other_face].normal,
                 -std::numeric_limits<double>::infinity()};
    const double length = plane.normal.norm();
    if (length < 1e-3) {
        return -std::numeric_limits<double>::infinity();
    }
    plane.normal /= length;
    for (const Vector3d& vertex_m : owner.vertices_m) {
        plane.offset_m = std::max(plane.offset_m, plane.normal.dot(vertex_m));
    }
    return lowest_over(plane, other.vertices_m);
}

/// Looks for an edge that keeps two blocks apart, where no face does: they pass each other at it. Where
/// faces lie on each other the next face is far off, and nothing is looked for [choice].
bool find_separating_edge(const PlacedBlock& first, const PlacedBlock& second, const VertexSides& of_second,
                          const VertexSides& of_first, SeparatingFace& known, double& gap_m) {
    const double near_m = -0.1 * std::min(first.radius_m, second.radius_m);
    for (const bool by_second : {false, true}) {
        const VertexSides& sides = by_second ? of_first : of_second;
        if (sides.second_separation_m > near_m) {
            gap_m = apart_across_edge_m(by_second ? second : first, by_second ? first : second,
                                        sides.highest_face, sides.second_face);
            if (gap_m >= 0.0) {
                known = {sides.highest_face, sides.second_face, by_second, Vector3d::Zero()};
                return true;
            }
        }
    }
    return false;
}

/// Area of a polygon, and integrals of its places in its own plane.
struct PlaneMoments {
    double area = 0.0;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    double xx = 0.0, yy = 0.0, xy = 0.0;
};

PlaneMoments moments_of(const Polygon2& polygon) {
    PlaneMoments sums;
    const Eigen::Vector2d& a = polygon.corners_m[0];
    for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
        const Eigen::Vector2d &b = polygon.corners_m[k], &c = polygon.corners_m[k + 1];
        const double area = 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
        const Eigen::Vector2d sum = a + b + c;
        const double twelfth = area / 12.0;
        sums.area += area;
        sums.first += area / 3.0 * sum;
        sums.xx += twelfth * (sum.x() * sum.x() + a.x() * a.x() + b.x() * b.x() + c.x() * c.x());
        sums.yy += twelfth * (sum.y() * sum.y() + a.y() * a.y() + b.y() * b.y() + c.y() * c.y());
        sums.xy += twelfth * (sum.x() * sum.y() + a.x() * a.y() + b.x() * b.y() + c.x() * c.y());
    }
    return sums;
}

/// Faces of a foundation that may be the nearest somewhere, by their height along a face of the body.
struct NearHeights {
    std::array<Height2, most_faces> heights;
    std::array<std::uint16_t, most_faces> faces;
    std::size_t size = 0;

    void add(const Height2& height, std::uint16_t face) {
        heights[size] = height;
        faces[size++] = face;
    }
};

/// What the slope of an overlap needs beside the polygons.
struct SlopeOfFace {
    OverlapSlope* slope;
    const PlacedBlock& foundation;
    const FaceFrame& frame;
    const Vector3d& m;
    const Vector3d& about_m;
};

/// Adds a polygon inside the foundation. The depth is that below the first height, and less by what another
/// one is higher where it is the highest: in thin overlaps a narrow rim.
void add_by_nearest(const Polygon2& polygon, const NearHeights& near, const SlopeOfFace& of, CutPolygon& work,
                    FaceSums& sums) {
    const Height2& base = near.heights[0];
    const Vector3d& base_normal = of.foundation.faces[near.faces[0]].normal;
    sums.add(polygon, base);
    sums.find_spread(polygon, base);
    const double without_rims_m3 = sums.depth_m3;
    if (of.slope != nullptr) {
        of.slope->add(polygon, of.frame, of.m, base_normal, of.about_m);
    }
    FaceSums rims;
    for (std::size_t k = 1; k < near.size; ++k) {
        const Height2& height = near.heights[k];
        work.start(polygon);
        bool any = work.cut(base.minus(height));
        for (std::size_t other = 1; other < near.size && any; ++other) {
            any = other == k || work.cut(near.heights[other].minus(height));
        }
        if (any) {
            rims.add(work.left(), height.minus(base));
            if (of.slope != nullptr) {
                of.slope->add(work.left(), of.frame, of.m,
                              of.foundation.faces[near.faces[k]].normal - base_normal, of.about_m);
            }
        }
    }
    sums.depth_m3 += rims.depth_m3;
    sums.place_by_depth_m4 += rims.place_by_depth_m4;
    if (without_rims_m3 > 0.0) {
        sums.spread_m5 *= sums.depth_m3 / without_rims_m3;
    }
}

/// Whether a face has no corner that is inside; in `cuts` the planes that cut it, as bits (Cohen &
/// Sutherland's codes).
bool is_outside(const PlacedBlock& body, std::size_t face, const VertexSides& sides, std::uint64_t& cuts) {
    std::uint64_t all = ~std::uint64_t{0};
    cuts = 0;
    for (const std::uint16_t corner : body.corners_of(face)) {
        all &= sides.outside[corner];
        cuts |= sides.outside[corner];
    }
    return all != 0;
}

/// The surface of `body` inside `foundation`.
void add_surface_inside(const PlacedBlock& foundation, const PlacedBlock& body, const VertexSides& sides,
                        const Vector3d& about_m, OverlapSums& sum, OverlapSlope* slope) {
    CutPolygon piece, work;
    NearHeights near;
    std::uint64_t cuts = 0;
    for (std::size_t g = 0; g < body.faces.size(); ++g) {
        if (is_outside(body, g, sides, cuts)) {
            continue;
        }
        const std::span<const std::uint16_t> corners = body.corners_of(g);
        const FaceFrame frame{body.vertices_m[corners[0]], body.faces[g].normal};
        Polygon2& start = piece.start();
        start.add(Eigen::Vector2d::Zero());
        for (const std::uint16_t corner : corners.subspan(1)) {
            start.add(frame.in_plane(body.vertices_m[corner]));
        }
        const std::uint64_t first = std::uint64_t{1} << sides.highest_face;
        near.size = 0;
        near.add(frame.height_over(foundation.faces[sides.highest_face]), sides.highest_face);
        bool left = (cuts & first) == 0 || piece.cut(near.heights[0]);
        for (std::uint64_t bits = (sides.near | cuts) & ~first; bits != 0 && left; bits &= bits - 1) {
            const int f = std::countr_zero(bits);
            const Height2 height = frame.height_over(foundation.faces[static_cast<std::size_t>(f)]);
            left = (cuts >> f & 1U) == 0 || piece.cut(height);
            if ((sides.near >> f & 1U) != 0) {
                near.add(height, static_cast<std::uint16_t>(f));
            }
        }
        if (left) {
            FaceSums sums;
            add_by_nearest(piece.left(), near, {slope, foundation, frame, body.faces[g].normal, about_m},
                           work, sums);
            add_face(frame, body.faces[g].normal, sums, about_m, sum);
        }
    }
}

/// The surface of the second body goes and turns with it, and with it the force on it; that of the first one
/// stays, so that the second body's centre moves away from its force. Each foundation counts by half.
void finish_slope(const Overlap& of_second, const Overlap& of_first, OverlapSlope& slope) {
    slope.turn_with(of_second);
    slope.moment_by_shift -= cross_matrix(of_first.force_m3);
    for (Eigen::Matrix3d* part :
         {&slope.force_by_shift, &slope.force_by_turn, &slope.moment_by_shift, &slope.moment_by_turn}) {
        *part *= 0.5;
    }
}

/// Mean distance of the points of a rectangle from its middle, by half its sides.
double mean_radius_m(double longer_m, double shorter_m) {
    if (shorter_m <= 1e-6 * longer_m) {
        return 0.5 * longer_m;
    }
    const double ratio = shorter_m / longer_m;
    return longer_m / 6.0 *
           (2.0 * std::hypot(1.0, ratio) + std::asinh(ratio) / ratio +
            ratio * ratio * std::asinh(1.0 / ratio));
}

}  // namespace

double separation_m(const SeparatingFace& known, const PlacedBlock& first, const PlacedBlock& second) {
    if (known.has_axis()) {
        return apart_along_m(known.axis, first, second);
    }
    if (known.face == SeparatingFace::none) {
        return -std::numeric_limits<double>::infinity();
    }
    const PlacedBlock& owner = known.of_second ? second : first;
    const PlacedBlock& other = known.of_second ? first : second;
    return known.is_edge() ? apart_across_edge_m(owner, other, known.face, known.other_face)
                           : lowest_over(owner.faces[known.face], other.vertices_m);
}

double way_into_edge_m(const SeparatingFace& known, const PlacedBlock& first, const PlacedBlock& second,
                       double slack_m3) {
    const double size_m = 2.0 * std::min(first.radius_m, second.radius_m);
    const double over_all_m = slack_m3 / (size_m * size_m);
    if (!known.is_edge()) {
        return over_all_m;
    }
    Vector3d axis = known.axis;
    if (!known.has_axis()) {
        const PlacedBlock& owner = known.of_second ? second : first;
        axis = (owner.faces[known.face].normal + owner.faces[known.other_face].normal).normalized();
    }
    double cosine = 0.0;  // of the flattest face
    for (const PlacedBlock* block : {&first, &second}) {
        for (const Plane3& face : block->faces) {
            cosine = std::max(cosine, std::abs(face.normal.dot(axis)));
        }
    }
    // Twice the cotangent of its angle: a wedge with two such faces.
    const double width_by_depth = 2.0 * cosine / std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return std::max(over_all_m, std::sqrt(slack_m3 / (size_m * width_by_depth)));
}

void FaceSums::add(const Polygon2& piece, const Height2& height) {
    const Eigen::Vector2d& a = piece.corners_m[0];
    Eigen::Vector2d b = piece.corners_m[1];
    const double depth_a = -height.at(a);
    double depth_b = -height.at(b);
    for (std::size_t k = 2; k < piece.size; ++k) {
        const Eigen::Vector2d& c = piece.corners_m[k];
        const double depth_c = -height.at(c);
        const double area = 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
        const double depths = depth_a + depth_b + depth_c;
        const Eigen::Vector2d places = a + b + c;
        area_m2 += area;
        place_m3 += area / 3.0 * places;
        depth_squared_m4 +=
            area / 12.0 * (depths * depths + depth_a * depth_a + depth_b * depth_b + depth_c * depth_c);
        depth_m3 += area / 3.0 * depths;
        place_by_depth_m4 += area / 12.0 * (depths * places + depth_a * a + depth_b * b + depth_c * c);
        b = c;
        depth_b = depth_c;
    }
}

void FaceSums::find_spread(const Polygon2& piece, const Height2& height) {
    if (depth_m3 <= 0.0) {
        return;
    }
    const Eigen::Vector2d centre_m = place_by_depth_m4 / depth_m3;
    const Eigen::Vector2d a = piece.corners_m[0] - centre_m;
    Eigen::Vector2d b = piece.corners_m[1] - centre_m;
    const double depth_a = -height.at(piece.corners_m[0]);
    double depth_b = -height.at(piece.corners_m[1]);
    for (std::size_t k = 2; k < piece.size; ++k) {
        const Eigen::Vector2d c = piece.corners_m[k] - centre_m;
        const double depth_c = -height.at(piece.corners_m[k]);
        const double area = 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
        const double depths = depth_a + depth_b + depth_c;
        const double of_a = depths + 2.0 * depth_a, of_b = depths + 2.0 * depth_b;
        const double of_c = depths + 2.0 * depth_c;
        const Eigen::Vector2d places = a + b + c;
        const Eigen::Vector2d weighted = depth_a * a + depth_b * b + depth_c * c + 0.5 * depths * places;
        const double share = area / 60.0;
        spread_m5 +=
            share * Eigen::Vector3d{2.0 * places.x() * weighted.x() + of_a * a.x() * a.x() +
                                        of_b * b.x() * b.x() + of_c * c.x() * c.x(),
                                    2.0 * places.y() * weighted.y() + of_a * a.y() * a.y() +
                                        of_b * b.y() * b.y() + of_c * c.y() * c.y(),
                                    places.x() * weighted.y() + places.y() * weighted.x() +
                                        of_a * a.x() * a.y() + of_b * b.x() * b.y() + of_c * c.x() * c.y()};
        b = c;
        depth_b = depth_c;
    }
}

void OverlapSlope::add(const Polygon2& piece, const FaceFrame& frame, const Vector3d& m, const Vector3d& n,
                       const Vector3d& about_m) {
    const PlaneMoments plane = moments_of(piece);
    const Vector3d o = frame.origin_m - about_m;
    const Vector3d in_plane = plane.first.x() * frame.along + plane.first.y() * frame.across;
    const Vector3d place_m3 = plane.area * o + in_plane;
    force_by_shift += plane.area * m * n.transpose();
    force_by_turn += m * place_m3.cross(n).transpose();
    moment_by_shift += place_m3.cross(m) * n.transpose();
    // Of the second moments M of the piece about `about_m`: [m] M [n], with [m] along = across.
    moment_by_turn -= m.cross(o) * place_m3.cross(n).transpose() + m.cross(in_plane) * o.cross(n).transpose();
    const Vector3d by_along = plane.xx * frame.along + plane.xy * frame.across;
    const Vector3d by_across = plane.xy * frame.along + plane.yy * frame.across;
    moment_by_turn -= frame.across * by_along.cross(n).transpose();
    moment_by_turn += frame.along * by_across.cross(n).transpose();
}

void OverlapSlope::turn_with(const Overlap& of_surface) {
    force_by_turn -= cross_matrix(of_surface.force_m3);
    moment_by_turn -= cross_matrix(of_surface.moment_m4);
}

Overlap OverlapSums::finished() const {
    const Overlap& sums = *this;
    Overlap overlap = sums;
    if (is_none()) {
        return overlap;
    }
    const Vector3d middle_m = pressure_centre_m();
    const Vector3d u = force_m3.unitOrthogonal(), w = force_m3.normalized().cross(u);
    const auto spread_m2 = [&](const Vector3d& a, const Vector3d& b) {
        return a.dot(squares_m5 * b) / depth_m3 - a.dot(middle_m) * b.dot(middle_m);
    };
    const double uu = spread_m2(u, u), ww = spread_m2(w, w), uw = spread_m2(u, w);
    const double mean = 0.5 * (uu + ww), half_range = std::hypot(0.5 * (uu - ww), uw);
    const double turn = 0.5 * std::atan2(uw, 0.5 * (uu - ww)), cosine = std::cos(turn), sine = std::sin(turn);
    overlap.arms_m = {std::sqrt(std::max(0.0, mean + half_range)) * (cosine * u + sine * w),
                      std::sqrt(std::max(0.0, mean - half_range)) * (cosine * w - sine * u)};
    overlap.friction_radius_m = mean_radius_m(std::sqrt(std::max(0.0, 3.0 * (mean + half_range))),
                                              std::sqrt(std::max(0.0, 3.0 * (mean - half_range))));
    return overlap;
}

void add_face(const FaceFrame& frame, const Vector3d& m, const FaceSums& sums, const Vector3d& about_m,
              OverlapSums& sum) {
    const Vector3d origin_m = frame.origin_m - about_m;
    const auto in_space = [&](double by_origin, const Eigen::Vector2d& by_place) {
        return Vector3d{by_origin * origin_m + by_place.x() * frame.along + by_place.y() * frame.across};
    };
    sum.area_m2 -= sums.area_m2 * m;
    sum.surface_m2 += sums.area_m2;
    sum.surface_m3 += in_space(sums.area_m2, sums.place_m3);
    const Vector3d depth_m4 = in_space(sums.depth_m3, sums.place_by_depth_m4);
    sum.depth_m3 += sums.depth_m3;
    sum.depth_squared_m4 += sums.depth_squared_m4;
    sum.depth_m4 += depth_m4;
    if (sums.depth_m3 > 0.0) {
        const Vector3d& spread = sums.spread_m5;
        sum.squares_m5 += depth_m4 * (depth_m4 / sums.depth_m3).transpose() +
                          (spread[0] * frame.along + spread[2] * frame.across) * frame.along.transpose() +
                          (spread[2] * frame.along + spread[1] * frame.across) * frame.across.transpose();
    }
    sum.force_m3 -= sums.depth_m3 * m;
    sum.moment_m4 -= depth_m4.cross(m);
}

Overlap overlap_of(const PlacedBlock& first, const PlacedBlock& second, const Vector3d& about_m,
                   SeparatingFace& known, OverlapSlope* slope, bool were_apart) {
    VertexSides of_second, of_first;
    find_sides(first, second, of_second);
    if (of_second.separation_m < 0.0) {
        find_sides(second, first, of_first);
    }
    for (const VertexSides* sides : {&of_second, &of_first}) {
        if (sides->separation_m >= 0.0) {
            known = {sides->highest_face, SeparatingFace::none, sides == &of_first, Vector3d::Zero()};
            Overlap none;
            none.gap_m = sides->separation_m;
            return none;
        }
    }
    const Vector3d last_axis = known.axis;
    known = {};
    if (double gap_m = 0.0; find_separating_edge(first, second, of_second, of_first, known, gap_m)) {
        Overlap none;
        none.gap_m = gap_m;
        return none;
    }
    if (were_apart) {
        const bool by_second = of_first.separation_m > of_second.separation_m;
        const Vector3d of_face = by_second ? Vector3d{-second.faces[of_first.highest_face].normal}
                                           : first.faces[of_second.highest_face].normal;
        const auto found = find_separating_axis(last_axis.isZero(0.0) ? of_face : last_axis, first, second);
        if (found) {
            known.axis = found->axis;
            Overlap none;
            none.gap_m = found->gap_m;
            return none;
        }
    }
    OverlapSums sum, other;
    add_surface_inside(first, second, of_second, about_m, sum, slope);
    add_surface_inside(second, first, of_first, about_m, other, slope);
    if (slope != nullptr) {
        finish_slope(sum, other, *slope);
    }
    sum.force_m3 = 0.5 * (sum.force_m3 - other.force_m3);
    sum.moment_m4 = 0.5 * (sum.moment_m4 - other.moment_m4);
    sum.depth_m3 += other.depth_m3;
    sum.depth_squared_m4 += other.depth_squared_m4;
    sum.depth_m4 += other.depth_m4;
    sum.squares_m5 += other.squares_m5;
    sum.area_m2 = 0.5 * (sum.area_m2 - other.area_m2);
    sum.surface_m2 += other.surface_m2;
    sum.surface_m3 += other.surface_m3;
    return sum.finished();
}

}  // namespace rockfall::rock_mass
