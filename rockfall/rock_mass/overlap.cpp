#include "rockfall/rock_mass/overlap.hpp"

#include <algorithm>
#include <bitset>
#include <limits>

#include "rockfall/rock_mass/convex_cell.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

double lowest_over(const Plane3& face, std::span<const Vector3d> vertices_m) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vector3d& vertex_m : vertices_m) {
        lowest = std::min(lowest, face.normal.dot(vertex_m));
    }
    return lowest - face.offset_m;
}

/// The first face of `block` that has all of `other` outside.
std::uint16_t separating_face(const PlacedBlock& block, const PlacedBlock& other) {
    for (std::size_t f = 0; f < block.faces.size(); ++f) {
        // The sphere says most of it.
        if (block.faces[f].height_m(other.centre_m) > -other.radius_m &&
            lowest_over(block.faces[f], other.vertices_m) >= 0.0) {
            return static_cast<std::uint16_t>(f);
        }
    }
    return SeparatingFace::none;
}

/// Which faces of `block` cut off something of a polygon, and whether one cuts off all of it.
enum class Side { inside, cut, outside };
Side side_of(const Plane3& face, const Polygon& polygon) {
    bool any_in = false, any_out = false;
    for (std::size_t i = 0; i < polygon.size; ++i) {
        (face.height_m(polygon.corners_m[i]) > 0.0 ? any_out : any_in) = true;
    }
    return !any_out ? Side::inside : any_in ? Side::cut : Side::outside;
}

/// The nearest face at all corners of a polygon inside the block, if it is one and the same.
std::uint16_t nearest_face(const PlacedBlock& block, const Polygon& polygon) {
    Vector3d middle = Vector3d::Zero();
    for (std::size_t i = 0; i < polygon.size; ++i) {
        middle += polygon.corners_m[i];
    }
    middle /= static_cast<double>(polygon.size);
    std::size_t nearest = 0;
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < block.faces.size(); ++f) {
        if (const double height = block.faces[f].height_m(middle); height > highest) {
            highest = height;
            nearest = f;
        }
    }
    // Heights are linear: nowhere does another face come nearer if it does at no corner.
    const double rounding_m = 1e-12 * block.radius_m;
    for (std::size_t i = 0; i < polygon.size; ++i) {
        const double here = block.faces[nearest].height_m(polygon.corners_m[i]) + rounding_m;
        for (std::size_t f = 0; f < block.faces.size(); ++f) {
            if (block.faces[f].height_m(polygon.corners_m[i]) > here) {
                return SeparatingFace::none;
            }
        }
    }
    return static_cast<std::uint16_t>(nearest);
}

/// Divides a polygon inside the block where its nearest face changes.
void add_divided(const PlacedBlock& block, const Polygon& polygon, const Vector3d& m, const Vector3d& about_m,
                 Overlap& sum) {
    Polygon parts[2];
    for (std::size_t f = 0; f < block.faces.size(); ++f) {
        const Plane3& face = block.faces[f];
        parts[0] = polygon;
        std::size_t now = 0;
        for (std::size_t other = 0; other < block.faces.size() && parts[now].size > 0; ++other) {
            if (other == f) {
                continue;
            }
            const Plane3 further{block.faces[other].normal - face.normal,
                                 block.faces[other].offset_m - face.offset_m};
            if (side_of(further, parts[now]) != Side::inside) {
                clip(
                    parts[now], [&](const Vector3d& x) { return further.height_m(x); }, parts[1 - now]);
                now = 1 - now;
            }
        }
        if (parts[now].size > 0) {
            add_piece(parts[now], m, face, about_m, sum);
        }
    }
}

/// The surface of `body` inside `foundation`.
Overlap surface_inside(const PlacedBlock& foundation, const PlacedBlock& body, const Vector3d& about_m) {
    Overlap sum;
    Polygon parts[2];
    for (std::size_t g = 0; g < body.faces.size(); ++g) {
        // A face whose plane has all of the foundation behind it is the only way in, one that has it all in
        // front lies beyond; neither is rare, and both are found by the sphere.
        const double height = body.faces[g].height_m(foundation.centre_m);
        if (height > foundation.radius_m || height < -foundation.radius_m) {
            continue;
        }
        std::size_t now = 0;
        parts[0].size = 0;
        for (const std::uint16_t corner : body.corners_of(g)) {
            parts[0].add(body.vertices_m[corner]);
        }
        for (const Plane3& face : foundation.faces) {
            const Side side = side_of(face, parts[now]);
            if (side == Side::outside) {
                parts[now].size = 0;
                break;
            }
            if (side == Side::cut) {
                clip(
                    parts[now], [&](const Vector3d& x) { return face.height_m(x); }, parts[1 - now]);
                now = 1 - now;
            }
        }
        if (parts[now].size == 0) {
            continue;
        }
        const std::uint16_t nearest = nearest_face(foundation, parts[now]);
        if (nearest != SeparatingFace::none) {
            add_piece(parts[now], body.faces[g].normal, foundation.faces[nearest], about_m, sum);
        } else {
            add_divided(foundation, parts[now], body.faces[g].normal, about_m, sum);
        }
    }
    return sum;
}

/// Integral of the depth below the nearest face of `foundation` over what it holds of `body`.
double held_energy_m4(const PlacedBlock& foundation, const ConvexCell& body) {
    double sum = 0.0;
    for (std::size_t f = 0; f < foundation.faces.size(); ++f) {
        const Plane3& face = foundation.faces[f];
        ConvexCell part = part_below(body, face);
        for (std::size_t other = 0; other < foundation.faces.size() && !part.faces.empty(); ++other) {
            if (other != f) {
                part = part_below(part, {foundation.faces[other].normal - face.normal,
                                         foundation.faces[other].offset_m - face.offset_m});
            }
        }
        if (!part.faces.empty()) {
            const VolumeAndCentre held = volume_and_centre(part);
            sum -= held.volume_m3 * face.height_m(held.centre_m);
        }
    }
    return sum;
}

}  // namespace

bool separates(const SeparatingFace& known, const PlacedBlock& first, const PlacedBlock& second) {
    if (known.face == SeparatingFace::none) {
        return false;
    }
    return known.of_second ? lowest_over(second.faces[known.face], first.vertices_m) >= 0.0
                           : lowest_over(first.faces[known.face], second.vertices_m) >= 0.0;
}

void add_piece(const Polygon& piece, const Vector3d& m, const Plane3& depth_below, const Vector3d& about_m,
               Overlap& sum) {
    const Vector3d a = piece.corners_m[0] - about_m;
    const double offset_m = depth_below.offset_m - depth_below.normal.dot(about_m);
    const double depth_a = offset_m - depth_below.normal.dot(a);
    Vector3d b = piece.corners_m[1] - about_m;
    double depth_b = offset_m - depth_below.normal.dot(b);
    double total_area = 0.0;
    Vector3d total_place = Vector3d::Zero();
    double total_force = 0.0;
    Vector3d total_first = Vector3d::Zero();
    for (std::size_t k = 2; k < piece.size; ++k) {
        const Vector3d c = piece.corners_m[k] - about_m;
        const double depth_c = offset_m - depth_below.normal.dot(c);
        const double area = 0.5 * (b - a).cross(c - a).dot(m);
        const double depths = depth_a + depth_b + depth_c;
        total_area += area;
        total_place += area / 3.0 * (a + b + c);
        total_force += area / 3.0 * depths;
        total_first += area / 12.0 * (depths * (a + b + c) + depth_a * a + depth_b * b + depth_c * c);
        b = c;
        depth_b = depth_c;
    }
    sum.area_m2 -= total_area * m;
    sum.surface_m2 += total_area;
    sum.surface_m3 += total_place;
    sum.force_m3 -= total_force * m;
    sum.moments_m4 -= total_first * m.transpose();
}

Overlap overlap_of(const PlacedBlock& first, const PlacedBlock& second, const Vector3d& about_m,
                   SeparatingFace& known) {
    known = {separating_face(first, second), false};
    if (known.face == SeparatingFace::none) {
        known = {separating_face(second, first), true};
    }
    if (known.face != SeparatingFace::none) {
        return {};
    }
    Overlap sum = surface_inside(first, second, about_m);
    const Overlap other = surface_inside(second, first, about_m);
    sum.force_m3 = 0.5 * (sum.force_m3 - other.force_m3);
    sum.moments_m4 = 0.5 * (sum.moments_m4 - other.moments_m4);
    sum.area_m2 = 0.5 * (sum.area_m2 - other.area_m2);
    sum.surface_m2 += other.surface_m2;
    sum.surface_m3 += other.surface_m3;
    return sum;
}

double overlap_energy_m4(const PlacedBlock& first, const PlacedBlock& second) {
    if (separating_face(first, second) != SeparatingFace::none ||
        separating_face(second, first) != SeparatingFace::none) {
        return 0.0;
    }
    return 0.5 * (held_energy_m4(first, cell_of(second)) + held_energy_m4(second, cell_of(first)));
}

}  // namespace rockfall::rock_mass
