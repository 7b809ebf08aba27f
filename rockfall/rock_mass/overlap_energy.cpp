// The energy of an overlap.

#include <algorithm>
#include <bit>
#include <cmath>

#include "rockfall/rock_mass/convex_cell.hpp"
#include "rockfall/rock_mass/overlap.hpp"
#include "rockfall/rock_mass/vertex_sides.hpp"

namespace rockfall::rock_mass {

namespace {

/// Whether a face of a body lies in a plane: there rounding could count it with both of its sides.
bool has_face_in(const PlacedBlock& body, const Plane3& plane) {
    return std::any_of(body.faces.begin(), body.faces.end(), [&](const Plane3& face) {
        return std::abs(face.normal.dot(plane.normal)) > 1.0 - 1e-9 &&
               std::abs(plane.height_m(face.normal * face.offset_m)) < 1e-7;
    });
}

/// `held_energy_m4` by volumes, whatever lies in one plane.
double held_energy_by_volume_m4(const PlacedBlock& foundation, std::uint64_t near, const ConvexCell& body) {
    double sum = 0.0;
    for (std::uint64_t bits = near; bits != 0; bits &= bits - 1) {
        const Plane3& face = foundation.faces[static_cast<std::size_t>(std::countr_zero(bits))];
        ConvexCell part = part_below(body, face);
        for (std::uint64_t others = near & ~(bits & -bits); others != 0 && !part.faces.empty();
             others &= others - 1) {
            const Plane3& other = foundation.faces[static_cast<std::size_t>(std::countr_zero(others))];
            part = part_below(part, {other.normal - face.normal, other.offset_m - face.offset_m});
        }
        if (!part.faces.empty()) {
            const VolumeAndCentre held = volume_and_centre(part);
            sum -= held.volume_m3 * face.height_m(held.centre_m);
        }
    }
    return sum;
}

/// Integral of the squared depth below face f over the part of a polygon where f is the nearest face [m4].
double depth_squared_m4(const PlacedBlock& foundation, std::uint64_t near, std::size_t f,
                        const FaceFrame& frame, CutPolygon& piece) {
    const Height2 height = frame.height_over(foundation.faces[f]);
    bool left = piece.cut(height);
    for (std::uint64_t bits = near & ~(std::uint64_t{1} << f); bits != 0 && left; bits &= bits - 1) {
        const auto other = static_cast<std::size_t>(std::countr_zero(bits));
        left = piece.cut(frame.height_over(foundation.faces[other]).minus(height));
    }
    FaceSums sums;
    if (left) {
        sums.add(piece.left(), height);
    }
    return sums.depth_squared_m4;
}

/// Integral of the depth below the nearest face of `foundation` over what it holds of `body`. Faces that are
/// nowhere the nearest in the body bound nothing: where another one is the nearest, they are farther.
///
/// By Gauss's theorem, as depth = div(-depth^2 n / 2): over the faces of the body, and over the planes on
/// which the nearest face changes from one to another.
double held_energy_m4(const PlacedBlock& foundation, const VertexSides& sides, const PlacedBlock& body) {
    double sum = 0.0;
    CutPolygon piece;
    for (std::uint64_t bits = sides.near; bits != 0; bits &= bits - 1) {
        const auto f = static_cast<std::size_t>(std::countr_zero(bits));
        const Plane3& face = foundation.faces[f];
        for (std::size_t g = 0; g < body.faces.size(); ++g) {
            const std::span<const std::uint16_t> corners = body.corners_of(g);
            if (std::all_of(corners.begin(), corners.end(),
                            [&](std::uint16_t corner) { return (sides.outside[corner] >> f & 1U) != 0; })) {
                continue;
            }
            const FaceFrame frame{body.vertices_m[corners[0]], body.faces[g].normal};
            Polygon2& start = piece.start();
            for (const std::uint16_t corner : corners) {
                start.add(frame.in_plane(body.vertices_m[corner]));
            }
            sum -= 0.5 * face.normal.dot(body.faces[g].normal) *
                   depth_squared_m4(foundation, sides.near, f, frame, piece);
        }
        for (std::uint64_t others = bits & (bits - 1); others != 0; others &= others - 1) {
            const Plane3& other = foundation.faces[static_cast<std::size_t>(std::countr_zero(others))];
            const double length = (other.normal - face.normal).norm();
            const Plane3 between{(other.normal - face.normal) / length,
                                 (other.offset_m - face.offset_m) / length};
            const double away_m = between.height_m(body.centre_m);
            if (std::abs(away_m) >= body.radius_m) {
                continue;
            }
            if (has_face_in(body, between)) {
                return held_energy_by_volume_m4(foundation, sides.near, cell_of(body));
            }
            const FaceFrame frame{body.centre_m - away_m * between.normal, between.normal};
            Polygon2& start = piece.start();
            for (const Eigen::Vector2d& corner : {Eigen::Vector2d{-1.0, -1.0}, Eigen::Vector2d{1.0, -1.0},
                                                  Eigen::Vector2d{1.0, 1.0}, Eigen::Vector2d{-1.0, 1.0}}) {
                start.add(body.radius_m * corner);
            }
            if (std::all_of(body.faces.begin(), body.faces.end(),
                            [&](const Plane3& of_body) { return piece.cut(frame.height_over(of_body)); })) {
                sum += 0.5 * length *
                       depth_squared_m4(foundation, sides.near & ~(others & -others), f, frame, piece);
            }
        }
    }
    return sum;
}

}  // namespace

double overlap_energy_m4(const PlacedBlock& first, const PlacedBlock& second) {
    VertexSides of_second, of_first;
    find_sides(first, second, of_second);
    find_sides(second, first, of_first);
    if (of_second.separation_m >= 0.0 || of_first.separation_m >= 0.0) {
        return 0.0;
    }
    return 0.5 * (held_energy_m4(first, of_second, second) + held_energy_m4(second, of_first, first));
}

}  // namespace rockfall::rock_mass
