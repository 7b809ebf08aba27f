#include "rockfall/solids/ground_contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rockfall::solids {
namespace {

using Eigen::Vector3d;

/// Whether the foot of a point lies on the polygon. Requires corners counter-clockwise about the normal.
template <typename Corner>
bool foot_lies_on(std::size_t corners, const Corner& corner, const Vector3d& normal,
                  const Vector3d& point_m) {
    for (std::size_t k = 0; k < corners; ++k) {
        const Vector3d& a = corner(k);
        const Vector3d& b = corner((k + 1) % corners);
        if (normal.cross(b - a).dot(point_m - a) < 0.0) {
            return false;
        }
    }
    return true;
}

/// Whether a direction across an edge lies between two normals less than a straight angle apart, both across
/// the edge too.
bool lies_between(const Vector3d& direction, const Vector3d& one, const Vector3d& other) {
    const Vector3d axis = one.cross(other);
    return one.cross(direction).dot(axis) >= 0.0 && direction.cross(other).dot(axis) >= 0.0 &&
           direction.dot(one + other) > 0.0;
}

}  // namespace

std::vector<GroundContact> vertices_on(const GroundTriangle& triangle, const Hull& block, double reach_m) {
    std::vector<GroundContact> contacts;
    for (const Vector3d& vertex_m : block.vertices_m) {
        const double gap_m = triangle.normal.dot(vertex_m - triangle.corners_m[0]);
        if (std::abs(gap_m) <= reach_m &&
            foot_lies_on(
                3, [&](std::size_t k) -> const Vector3d& { return triangle.corners_m[k]; }, triangle.normal,
                vertex_m)) {
            contacts.push_back(
                {ContactKind::vertex_on_face, vertex_m - gap_m * triangle.normal, triangle.normal, gap_m});
        }
    }
    return contacts;
}

std::optional<GroundContact> face_on(const Vector3d& ground_vertex_m, const Hull& block, double reach_m) {
    // The face whose plane is highest above the point: the nearest one, inside and outside.
    const Face* nearest = nullptr;
    double gap_m = -std::numeric_limits<double>::infinity();
    for (const Face& face : block.faces) {
        const double height_m = face.normal.dot(ground_vertex_m) - face.offset_m;
        if (height_m > gap_m) {
            gap_m = height_m;
            nearest = &face;
        }
    }
    if (std::abs(gap_m) > reach_m || nearest->normal.z() >= 0.0 ||
        !foot_lies_on(
            nearest->corners.size(),
            [&](std::size_t k) -> const Vector3d& { return block.vertices_m[nearest->corners[k]]; },
            nearest->normal, ground_vertex_m)) {
        return std::nullopt;
    }
    return GroundContact{ContactKind::face_on_vertex, ground_vertex_m, -nearest->normal, gap_m};
}

std::vector<GroundContact> edges_across(const GroundEdge& ridge, const Hull& block, double reach_m) {
    std::vector<GroundContact> contacts;
    const Vector3d along_ridge = ridge.to_m - ridge.from_m;
    const Vector3d out_of_left = along_ridge.normalized().cross(ridge.left_normal);
    if (ridge.right_normal.dot(out_of_left) <= parallel_sine) {
        return contacts;
    }
    for (const Edge& edge : block.edges) {
        const Vector3d& start_m = block.vertices_m[edge.from];
        const Vector3d along_edge = block.vertices_m[edge.to] - start_m;
        const Vector3d across = along_ridge.cross(along_edge);
        const double size = across.norm();
        if (size <= parallel_sine * along_ridge.norm() * along_edge.norm()) {
            continue;
        }
        Vector3d normal = across / size;
        if (normal.dot(ridge.left_normal + ridge.right_normal) < 0.0) {
            normal = -normal;
        }
        const Vector3d between_m = start_m - ridge.from_m;
        const double gap_m = normal.dot(between_m);
        if (std::abs(gap_m) > reach_m || !lies_between(normal, ridge.left_normal, ridge.right_normal) ||
            !lies_between(-normal, block.faces[edge.left].normal, block.faces[edge.right].normal)) {
            continue;
        }
        const double on_ridge = between_m.cross(along_edge).dot(across) / (size * size);
        const double on_edge = between_m.cross(along_ridge).dot(across) / (size * size);
        if (on_ridge >= 0.0 && on_ridge <= 1.0 && on_edge >= 0.0 && on_edge <= 1.0) {
            contacts.push_back(
                {ContactKind::edge_on_edge, ridge.from_m + on_ridge * along_ridge, normal, gap_m});
        }
    }
    return contacts;
}

}  // namespace rockfall::solids
