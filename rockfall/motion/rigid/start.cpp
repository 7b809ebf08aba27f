#include "rockfall/motion/rigid/start.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rockfall::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

double area_of(const solids::Hull& hull, const solids::Face& face) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) {
        const Vector3d& a = hull.vertices_m[face.corners[0]];
        sum += (hull.vertices_m[face.corners[k]] - a).cross(hull.vertices_m[face.corners[k + 1]] - a);
    }
    return 0.5 * sum.norm();
}

/// The largest or smallest face; of equal ones (to 1e-9) the first.
const solids::Face& face_to_lie_on(const solids::Hull& hull, bool largest) {
    const solids::Face* chosen = &hull.faces.front();
    double best = area_of(hull, *chosen);
    for (const solids::Face& face : hull.faces) {
        const double area_m2 = area_of(hull, face);
        if (largest ? area_m2 > best * (1.0 + 1e-9) : area_m2 < best * (1.0 - 1e-9)) {
            chosen = &face;
            best = area_m2;
        }
    }
    return *chosen;
}

/// The rotation that takes the orthonormal pair (a, b) to (c, d).
Quaterniond rotation_of(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    Matrix3d from, to;
    from << a, b, a.cross(b);
    to << c, d, c.cross(d);
    return Quaterniond{Matrix3d{to * from.transpose()}}.normalized();
}

/// Moves the block along the vertical until it just touches the ground. Requires a place above the ground.
void lower_to_ground(const SlopeView& slope, const Law& law, const solids::Solid& solid, BlockStart& start,
                     BlockScratch& scratch, const Bumps& bumps) {
    const double radius_m = solid.bounding_radius_m;
    const auto gap_m = [&](double shift_m) {
        Body body = start.body;
        body.centre_m.z() += shift_m;
        return Block{slope, law, solid, body, start.triangle, scratch, bumps}.gap_m(radius_m);
    };
    // On the steepest ground the ball around the block is clear of it after a few radii.
    double high_m = 0.0, low_m = 0.0;
    while (gap_m(high_m) <= 0.0 && high_m < 1000.0 * radius_m) {
        high_m += radius_m;
    }
    low_m = high_m - radius_m;
    while (gap_m(low_m) > 0.0 && low_m > -1000.0 * radius_m) {
        low_m -= radius_m;
    }
    constexpr int bisections = 60;
    for (int i = 0; i < bisections; ++i) {
        const double middle_m = 0.5 * (low_m + high_m);
        (gap_m(middle_m) > 0.0 ? high_m : low_m) = middle_m;
    }
    start.body.centre_m.z() += high_m;
}

double lowest_m(const solids::Solid& solid, const Quaterniond& attitude) {
    if (solid.is_sphere()) {
        return -solid.bounding_radius_m;
    }
    double lowest = 0.0;
    for (const Vector3d& vertex_m : solid.hull.vertices_m) {
        lowest = std::min(lowest, (attitude * vertex_m).z());
    }
    return lowest;
}

Quaterniond lying(const solids::Solid& solid, const Vector3d& normal, const Vector3d& downhill,
                  const Quaterniond& by_chance) {
    const solids::Face& face = face_to_lie_on(solid.hull, true);
    const Vector3d along =
        (solid.hull.vertices_m[face.corners[1]] - solid.hull.vertices_m[face.corners[0]]).normalized();
    // The heading of a drawn attitude turns the block on its face.
    Vector3d way = by_chance * Vector3d::UnitX();
    way -= way.dot(normal) * normal;
    if (way.norm() < 1e-6) {
        way = downhill;
    }
    return rotation_of(face.normal, along, -normal, way.normalized());
}

/// Turned about the lower edge of its standing face until the weight line has passed that edge.
void topple(const Law& law, const solids::Solid& solid, const Vector3d& heading, Body& body) {
    const Vector3d up = Vector3d::UnitZ();
    const Vector3d axis = up.cross(heading).normalized();
    Vector3d from_pivot_m = solid.bounding_radius_m * up;
    if (!solid.is_sphere()) {
        const solids::Face& face = face_to_lie_on(solid.hull, false);
        const Vector3d& a = solid.hull.vertices_m[face.corners[0]];
        const Vector3d& b = solid.hull.vertices_m[face.corners[1]];
        const Vector3d edge = (b - a).normalized();
        // Seen from outside the corners run counter-clockwise: the edge's outer side is edge x normal.
        const Vector3d outer = edge.cross(face.normal);
        const Quaterniond standing = rotation_of(face.normal, outer, -up, heading);
        const Vector3d pivot_m = a - a.dot(edge) * edge;  // the foot of the centroid on the edge
        const Vector3d centre_m = standing * -pivot_m;    // the centroid over the edge
        constexpr double past = 1e-3;                     // tangent of the angle beyond the vertical
        const Quaterniond turn = Quaterniond::FromTwoVectors(centre_m, up + past * heading);
        body.rotation.attitude = (turn * standing).normalized();
        from_pivot_m = turn * centre_m;
    }
    const Vector3d spin_radps = law.topple_spin_radps * axis;
    body.velocity_mps = spin_radps.cross(from_pivot_m);
    body.rotation.momentum_nms =
        solid.inertia_kgm2.cwiseProduct(body.rotation.attitude.conjugate() * spin_radps);
}

}  // namespace

BlockStart start_of_block(const SlopeView& slope, const Law& law, const RockStart& start,
                          const solids::Solid& solid, BlockScratch& scratch, const Bumps& bumps) {
    BlockStart begin;
    begin.triangle = start.triangle;
    const Plane plane = slope.terrain().plane_of(start.triangle);
    const double ground_m = plane.height_m(start.position_m.x(), start.position_m.y());
    const double height_m = start.position_m.z() - ground_m;
    const StartKind kind = law.start != StartKind::by_height ? law.start
                           : start.rolling                   ? StartKind::sliding
                                                             : StartKind::falling;
    const Vector3d normal = plane.normal();
    Vector3d heading{start.heading.x(), start.heading.y(), 0.0};
    if (heading.squaredNorm() == 0.0) {
        heading = Vector3d::UnitX();
    }
    Body& body = begin.body;
    body.centre_m = start.position_m;
    body.velocity_mps = start.velocity_mps;
    body.rotation.attitude = (start.block.attitude * solid.from_given.conjugate()).normalized();
    if (kind == StartKind::falling) {
        body.centre_m.z() -= lowest_m(solid, body.rotation.attitude);
        begin.on_ground = false;
        const Vector3d spin_radps = law.start_spin_radps * Vector3d::UnitZ().cross(heading).normalized();
        body.rotation.momentum_nms =
            solid.inertia_kgm2.cwiseProduct(body.rotation.attitude.conjugate() * spin_radps);
        // On a slope the ground beside the centre is higher: the block is raised until it is clear of it.
        const double clear_m = std::max(height_m, 1e-3);
        for (int i = 0; i < 1000; ++i) {
            const double gap_m =
                Block{slope, law, solid, body, begin.triangle, scratch, bumps}.gap_m(solid.bounding_radius_m);
            if (gap_m > 0.0) {
                break;
            }
            body.centre_m.z() += std::max(clear_m, -gap_m);
        }
        return begin;
    }
    begin.on_ground = true;
    const Vector3d downhill = (heading - heading.dot(normal) * normal).normalized();
    if (kind == StartKind::toppling) {
        topple(law, solid, heading, body);
    } else {
        if (!solid.is_sphere() && !law.keeps_attitude) {
            body.rotation.attitude = lying(solid, normal, downhill, body.rotation.attitude);
        }
        // The same speed along the ground.
        body.velocity_mps = start.velocity_mps.norm() * downhill;
    }
    body.centre_m.z() = ground_m + 3.0 * solid.bounding_radius_m;
    lower_to_ground(slope, law, solid, begin, scratch, bumps);
    return begin;
}

std::shared_ptr<const solids::Solid> solid_for(const RockStart& start) {
    if (start.block.solid) {
        return start.block.solid;
    }
    const double volume_m3 =
        std::numbers::pi / 6.0 * start.rock.diameter_m * start.rock.diameter_m * start.rock.diameter_m;
    return std::make_shared<const solids::Solid>(
        solids::ball_of(start.rock.diameter_m, start.rock.mass_kg / volume_m3));
}

}  // namespace rockfall::rigid
