#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "rockfall/motion/rigid/block.hpp"
#include "rockfall/solids/shapes.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::rigid::testing {

using Eigen::Vector3d;

inline double radians(double angle_deg) {
    return config::Angle::from_degrees(angle_deg).in_radians();
}

/// A plane that falls towards +x, in cells of any size.
inline Slope plane(double slope_deg, double length_m, double width_m = 20.0, double cell_m = 10.0) {
    const config::GridFrame frame{
        static_cast<int>(length_m / cell_m), static_cast<int>(width_m / cell_m), 0.0, 0.0, cell_m, cell_m};
    const double tangent = std::tan(radians(slope_deg));
    return rockfall::testing::slope_over(
        rockfall::testing::heights_of(frame, [&](double x, double) { return 2000.0 - tangent * x; }),
        {0.3, 0.8});
}

/// Constant friction and restitution everywhere.
inline Law law_of(double friction, double restitution) {
    Law law;
    law.friction_law = FrictionLaw::constant;
    law.friction = friction;
    law.restitution = restitution;
    law.rolling_resistance = 0.0;
    law.drag_ps = 0.0;
    law.restitution_halved_mps = 0.0;
    return law;
}

inline solids::Solid cube(double side_m = 0.5) {
    return solids::solid_of(solids::box({side_m, side_m, side_m}), 2700.0);
}

/// A block that lies on the plane with its lowest point at the place, its own z axis along the normal.
inline Body lying(const Slope& slope, const solids::Solid& solid, double slope_deg, double x_m, double y_m,
                  const Eigen::Quaterniond& turned = Eigen::Quaterniond::Identity()) {
    const Vector3d normal{std::sin(radians(slope_deg)), 0.0, std::cos(radians(slope_deg))};
    const Eigen::Quaterniond tilt{Eigen::AngleAxisd{radians(slope_deg), Vector3d::UnitY()}};
    Body body;
    body.rotation.attitude = (tilt * turned * solid.from_given.conjugate()).normalized();
    double lowest_m = solid.is_sphere() ? solid.bounding_radius_m : 0.0;
    for (const Vector3d& vertex_m : solid.hull.vertices_m) {
        lowest_m = std::max(lowest_m, -normal.dot(body.rotation.attitude * vertex_m));
    }
    const auto triangle = slope.terrain.locate(x_m, y_m).value();
    body.centre_m =
        Vector3d{x_m, y_m, slope.terrain.plane_of(triangle).height_m(x_m, y_m)} + lowest_m * normal;
    return body;
}

/// Moves a block for a time as the event loop does. `on_ground`: begins in contact.
inline Body moved(Block& block, const Law& law, double time_s, bool on_ground) {
    double done_s = 0.0;
    while (done_s < time_s - 1e-9) {
        if (on_ground) {
            bool inside = true;
            const Touchdown touchdown = block.step(law.step_s, inside);
            done_s += law.step_s;
            on_ground = inside && touchdown.touched && touchdown.lasts;
            if (!inside) {
                break;
            }
        } else {
            const FreeFlight flight = block.fly();
            const double until_s = std::min(flight.duration_s, time_s - done_s);
            block.go_on(until_s);
            done_s += until_s;
            if (until_s < flight.duration_s || flight.end == FlightStop::left_terrain) {
                break;
            }
            on_ground = block.strike().lasts;
        }
    }
    return block.body();
}

/// How far a block at rest on a plane gets in a time.
inline double way_m(const Slope& slope, const Law& law, const solids::Solid& solid, const Body& start,
                    double time_s) {
    BlockScratch scratch;
    const auto triangle = slope.terrain.locate(start.centre_m.x(), start.centre_m.y()).value();
    Block block{slope, law, solid, start, triangle, scratch};
    return (moved(block, law, time_s, true).centre_m - start.centre_m).norm();
}

}  // namespace rockfall::rigid::testing
