#include "tests/rockfall/motion/rigid/fcl_oracle.hpp"

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <algorithm>
#include <memory>

namespace rockfall::testing {
namespace {

fcl::Convex<double> convex_of(const solids::Hull& hull) {
    auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const Eigen::Vector3d& vertex_m : hull.vertices_m) {
        vertices->push_back(vertex_m);
    }
    auto faces = std::make_shared<std::vector<int>>();
    for (const solids::Face& face : hull.faces) {
        faces->push_back(static_cast<int>(face.corners.size()));
        for (const std::uint32_t corner : face.corners) {
            faces->push_back(static_cast<int>(corner));
        }
    }
    return {vertices, static_cast<int>(hull.faces.size()), faces};
}

fcl::detail::GJKSolver_libccd<double> fine_solver() {
    fcl::detail::GJKSolver_libccd<double> solver;
    solver.max_collision_iterations = 1000;
    solver.max_distance_iterations = 1000;
    solver.collision_tolerance = 1e-9;
    solver.distance_tolerance = 1e-10;
    return solver;
}

}  // namespace

std::optional<double> fcl_distance_m(const solids::Hull& hull, const solids::GroundTriangle& triangle) {
    double distance_m = 0.0;
    fine_solver().shapeTriangleDistance(convex_of(hull), fcl::Transform3d::Identity(), triangle.corners_m[0],
                                        triangle.corners_m[1], triangle.corners_m[2], &distance_m);
    return distance_m;
}

std::optional<double> fcl_depth_m(const solids::Hull& one, const solids::Hull& other) {
    std::vector<fcl::ContactPoint<double>> contacts;
    double depth_m = 0.0;
    if (fine_solver().shapeIntersect(convex_of(one), fcl::Transform3d::Identity(), convex_of(other),
                                     fcl::Transform3d::Identity(), &contacts)) {
        for (const auto& contact : contacts) {
            depth_m = std::max(depth_m, contact.penetration_depth);
        }
    }
    return depth_m;
}

}  // namespace rockfall::testing
