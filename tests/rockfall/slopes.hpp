#pragma once

// Synthetic slopes for tests. x runs downhill: the fall line is the positive x direction.

#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "config/grid/raster.hpp"
#include "config/units/angle.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "rockfall/trajectory.hpp"

namespace rockfall::testing {

/// A raster of heights from a function of x and y at the cell centres.
inline config::Raster<double> heights_of(const config::GridFrame& frame,
                                         const std::function<double(double, double)>& height_m) {
    config::Raster<double> heights{frame};
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        heights.values[i] = height_m(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row));
    }
    return heights;
}

/// A soil of PiR3D with round numbers: widths, then threshold 5 degrees.
inline Soil test_soil(double friction = 0.6, Restitution restitution = {0.35, 0.85}) {
    const auto radians = [](double degrees) { return config::Angle::from_degrees(degrees).in_radians(); };
    const Width restitution_share{0.10, 0.06, 10.0};
    const Width angle{radians(20.0), radians(15.0), 10.0};
    return {"test soil",        restitution, friction, restitution_share,     restitution_share,
            {0.15, 0.10, 10.0}, angle,       angle,    std::tan(radians(5.0))};
}

/// A slope of one ground type over heights.
inline Slope slope_over(const config::Raster<double>& heights, Restitution restitution,
                        double stop_probability = 0.0) {
    SurfaceType type;
    type.code = 1;
    type.label = "test ground";
    type.restitution = restitution;
    type.stopping = StopCurve{{{1.0, stop_probability}}};
    type.soil = test_soil();
    return {triangulate(heights, 0.0), SurfaceMap::uniform(SurfaceId{0}), {type}};
}

/// An even slope, 1000 m x 100 m by default, falling towards +x.
inline Slope plane_slope(double slope_deg, Restitution restitution, double stop_probability = 0.0,
                         double length_m = 1000.0, double width_m = 100.0) {
    const double tangent = std::tan(config::Angle::from_degrees(slope_deg).in_radians());
    const config::GridFrame frame{
        static_cast<int>(length_m / 10.0), static_cast<int>(width_m / 10.0), 0.0, 0.0, 10.0, 10.0};
    return slope_over(heights_of(frame, [&](double x, double) { return 2000.0 - tangent * x; }), restitution,
                      stop_probability);
}

/// Law of exactly what the paper states, without any chance.
inline FallLaw deterministic_law() {
    FallLaw law;
    law.motion.of<picus::Model>().noise = picus::NoiseScope::off;
    law.motion.of<picus::Model>().restitution.normal_halved_mps = 0.0;
    law.motion.of<picus::Model>().jump_angle.scatter = 0.0;
    law.motion.of<picus::Model>().jump_angle.coefficient = config::Angle::from_degrees(80.0);
    law.motion.of<picus::Model>().facets.slope_by_losses = 0.0;
    law.motion.of<picus::Model>().impact_friction = false;
    law.motion.of<picus::Model>().lateral.at_rest = config::Angle{};
    law.motion.of<picus::Model>().lateral.when_fast = config::Angle{};
    law.motion.of<picus::Model>().blend_steep_impacts = false;
    law.tree.taper = false;
    law.tree.height_effect = false;
    const auto degrees = [](double d) { return config::Angle::from_degrees(d); };
    law.tree.deviation.limits = {degrees(0.0), degrees(22.5), degrees(67.5), degrees(76.0)};
    law.tree.deviation.shares = {{{0.44, 0.50, 0.06}, {0.19, 0.76, 0.05}, {0.72, 0.24, 0.04}}};
    return law;
}

/// The motion model of PiR3D without any chance.
inline FallLaw sliding_law() {
    FallLaw law = deterministic_law();
    law.motion.model = motion_model<pir3d::Model>;
    law.motion.of<pir3d::Model>().uncertainty = pir3d::Uncertainty::off;
    return law;
}

/// A rock at a place given in absolute coordinates, at a height above ground.
inline RockStart start_at(const Slope& slope, double x_m, double y_m, double height_m,
                          const Eigen::Vector3d& velocity_mps, double diameter_m = 0.95,
                          std::uint64_t id = 0) {
    RockStart start;
    start.id = id;
    const Eigen::Vector2d place = Eigen::Vector2d{x_m, y_m} - slope.terrain.origin_m();
    start.triangle = slope.terrain.locate(place.x(), place.y()).value();
    start.position_m = {place.x(), place.y(),
                        slope.terrain.plane_of(start.triangle).height_m(place.x(), place.y()) + height_m};
    start.velocity_mps = velocity_mps;
    start.rolling = height_m == 0.0;
    start.rock = Rock::sphere(diameter_m, 2700.0);
    return start;
}

/// Keeps what a rock did, event by event.
struct EventLog {
    struct Jump {
        Flight flight;
        double until_s;
        double spin_radps;
        std::vector<Stretch> stretches;
    };
    struct Roll {
        RollingPiece piece;
        std::uint32_t triangle;
    };
    struct Hit {
        Eigen::Vector3d position_m;
        StemHit hit;
        TreeImpact impact;
        double energy_j;
    };
    std::vector<Jump> jumps;
    std::vector<Roll> rolls;
    struct Met {
        Eigen::Vector3d position_m;
        LogHit hit;
        LogImpact impact;
        double energy_j;
    };
    std::vector<Hit> hits;
    std::vector<Met> logs;
    std::vector<Eigen::Vector3d> impacts;
    struct Crossing {
        Eigen::Vector3d position_m;
        NetCrossing crossing;
    };
    std::vector<Crossing> nets;

    void flew(const Rock&, const Flight& flight, double until_s, std::span<const Stretch> stretches,
              double spin) {
        jumps.push_back({flight, until_s, spin, {stretches.begin(), stretches.end()}});
    }
    void rolled(const Rock&, const RollingPiece& piece, std::uint32_t triangle) {
        rolls.push_back({piece, triangle});
    }
    void impacted(const Eigen::Vector3d& position, int) { impacts.push_back(position); }
    void met_stem(const Eigen::Vector3d& position, const StemHit& hit, const TreeImpact& impact,
                  double energy) {
        hits.push_back({position, hit, impact, energy});
    }
    void met_log(const Eigen::Vector3d& position, const LogHit& hit, const LogImpact& impact, double energy) {
        logs.push_back({position, hit, impact, energy});
    }
    void crossed_net(const Eigen::Vector3d& position, const NetCrossing& crossing) {
        nets.push_back({position, crossing});
    }
};

/// A fall with its events among any obstacles.
inline std::pair<FallEnd, EventLog> logged_fall(const Slope& slope, const FallLaw& law,
                                                const RockStart& start, const Obstacles& obstacles,
                                                std::uint64_t seed = 1) {
    EventLog log;
    FallScratch scratch;
    const FallEnd end = fall(slope, obstacles, law, {seed, 0, 0, start.id}, start, scratch, log);
    return {end, std::move(log)};
}

/// A fall with its events.
inline std::pair<FallEnd, EventLog> logged_fall(const Slope& slope, const FallLaw& law,
                                                const RockStart& start, const StemIndex* stems = nullptr,
                                                std::uint64_t seed = 1, std::span<std::uint8_t> gone = {}) {
    return logged_fall(slope, law, start, Obstacles{stems, gone, nullptr, {}}, seed);
}

}  // namespace rockfall::testing
