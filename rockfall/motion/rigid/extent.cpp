#include "rockfall/motion/rigid/extent.hpp"

#include "rockfall/motion/rigid/ground_patch.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Ericson (2005), Real-Time Collision Detection, 5.1.9.
double squared_distance_of_pieces(const Vector3d& p1, const Vector3d& q1, const Vector3d& p2,
                                  const Vector3d& q2) {
    const Vector3d d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
    const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
    const double denominator = a * e - b * b;
    double s = denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    double t = e > 0.0 ? (b * s + f) / e : 0.0;
    if (t < 0.0) {
        t = 0.0;
        s = a > 0.0 ? std::clamp(-c / a, 0.0, 1.0) : 0.0;
    } else if (t > 1.0) {
        t = 1.0;
        s = a > 0.0 ? std::clamp((b - c) / a, 0.0, 1.0) : 0.0;
    }
    return (p1 + s * d1 - p2 - t * d2).squaredNorm();
}

/// Squared distance of a point from a face seen straight on; infinity where its foot lies outside.
double squared_distance_of_face(const solids::Hull& hull, const solids::Face& face, const Vector3d& point_m) {
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const Vector3d& a = hull.vertices_m[face.corners[k]];
        const Vector3d& b = hull.vertices_m[face.corners[(k + 1) % face.corners.size()]];
        if (face.normal.cross(b - a).dot(point_m - a) < 0.0) {
            return std::numeric_limits<double>::infinity();
        }
    }
    const double height_m = face.normal.dot(point_m) - face.offset_m;
    return height_m * height_m;
}

/// Whether a piece runs through the inside of a hull (clipped by its planes).
bool runs_through(const solids::Hull& hull, const Vector3d& from_m, const Vector3d& to_m) {
    double begin = 0.0, end = 1.0;
    for (const solids::Face& face : hull.faces) {
        const double at_from = face.normal.dot(from_m) - face.offset_m;
        const double at_to = face.normal.dot(to_m) - face.offset_m;
        if (at_from > 0.0 && at_to > 0.0) {
            return false;
        }
        if (at_from > 0.0) {
            begin = std::max(begin, at_from / (at_from - at_to));
        } else if (at_to > 0.0) {
            end = std::min(end, at_from / (at_from - at_to));
        }
    }
    return begin <= end;
}

}  // namespace

double plan_distance_m(const solids::Solid& solid, const Body& body, const Vector2d& line_m) {
    if (solid.is_sphere()) {
        return std::max(0.0, (line_m - body.centre_m.head<2>()).norm() - solid.bounding_radius_m);
    }
    const Eigen::Matrix3d turn = body.rotation.attitude.toRotationMatrix();
    const Vector2d point_m = line_m - body.centre_m.head<2>();
    // A vertical line meets the block where one runs through it; else the edges bound its shadow.
    const Vector3d up = turn.transpose() * Vector3d{0.0, 0.0, 2.0 * solid.bounding_radius_m};
    const Vector3d base = turn.transpose() * Vector3d{point_m.x(), point_m.y(), 0.0};
    if (runs_through(solid.hull, base - up, base + up)) {
        return 0.0;
    }
    double squared = std::numeric_limits<double>::infinity();
    for (const solids::Edge& edge : solid.hull.edges) {
        const Vector3d from_m = turn * solid.hull.vertices_m[edge.from];
        const Vector3d to_m = turn * solid.hull.vertices_m[edge.to];
        squared = std::min(squared, squared_distance_m2(point_m, from_m.head<2>(), to_m.head<2>()));
    }
    return std::sqrt(squared);
}

double distance_from_piece_m(const solids::Solid& solid, const Body& body, const Vector3d& from_m,
                             const Vector3d& to_m) {
    const Eigen::Matrix3d back = body.rotation.attitude.toRotationMatrix().transpose();
    const Vector3d a = back * (from_m - body.centre_m), b = back * (to_m - body.centre_m);
    if (solid.is_sphere()) {
        const double distance_m =
            std::sqrt(squared_distance_of_pieces(Vector3d::Zero(), Vector3d::Zero(), a, b));
        return std::max(0.0, distance_m - solid.bounding_radius_m);
    }
    if (runs_through(solid.hull, a, b)) {
        return 0.0;
    }
    double squared = std::numeric_limits<double>::infinity();
    for (const solids::Edge& edge : solid.hull.edges) {
        squared = std::min(squared, squared_distance_of_pieces(solid.hull.vertices_m[edge.from],
                                                               solid.hull.vertices_m[edge.to], a, b));
    }
    for (const solids::Face& face : solid.hull.faces) {
        squared = std::min({squared, squared_distance_of_face(solid.hull, face, a),
                            squared_distance_of_face(solid.hull, face, b)});
    }
    return std::sqrt(squared);
}

}  // namespace rockfall::rigid
