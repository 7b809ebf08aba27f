#include "coupling/today/grounds.hpp"

#include <cmath>
#include <cstddef>

#include "coupling/results/csv_row.hpp"
#include "coupling/today/static_layouts.hpp"
#include "rockfall/motion/classical/friction.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {
namespace {

using rockfall::MotionModel;
using rockfall::SurfaceType;

double degrees(double angle_rad) {
    return config::Angle::from_radians(angle_rad).in_degrees();
}

void take_soil(const rockfall::pir3d::Soil& soil, GroundFigures& ground) {
    ground.soil = soil.name;
    ground.r_n = soil.restitution.normal;
    ground.r_t = soil.restitution.tangential;
    ground.friction = soil.friction;
    ground.threshold_deg = degrees(std::atan(soil.threshold_tangent));
    ground.dr_slow_percent = 100.0 * soil.restitution_share.slow;
    ground.dr_fast_percent = 100.0 * soil.restitution_share.fast;
    ground.dk_slow_percent = 100.0 * soil.friction_share.slow;
    ground.dk_fast_percent = 100.0 * soil.friction_share.fast;
    ground.angle_slow_deg = degrees(soil.angle_rad.slow);
    ground.angle_fast_deg = degrees(soil.angle_rad.fast);
    ground.limit_mps = soil.limit_mps;
}

GroundFigures figures_of(const SurfaceType& type, const rockfall::FallLaw& law, double diameter_m) {
    GroundFigures ground;
    ground.code = type.code;
    ground.label = type.label;
    if (law.motion.model == MotionModel::pir3d) {
        if (type.soil) {
            take_soil(*type.soil, ground);
        }
        return ground;
    }
    ground.r_n = type.restitution.normal;
    ground.r_t = type.restitution.tangential;
    if (law.motion.model == MotionModel::classical) {
        ground.friction = rockfall::classical::friction_of(type.restitution, law.motion.classical);
    } else if (law.motion.picus.stopping.by_chance) {
        ground.p_stop = type.stopping.at(diameter_m);
        ground.rolling_stops_per_m = type.rolling_stops_per_m.at(diameter_m);
    }
    return ground;
}

/// Cells of the maps by ground type; a type that only faces of a mesh carry has none, but occurs.
struct Occurrence {
    std::vector<std::size_t> cells;
    std::vector<bool> occurs;
    std::size_t all = 0;
};

Occurrence occurrence_of(const Site& site) {
    Occurrence found{std::vector<std::size_t>(site.slope.types.size()),
                     std::vector<bool>(site.slope.types.size())};
    for (const std::uint8_t id : site.surface.values) {
        if (id < found.cells.size()) {
            ++found.cells[id];
            ++found.all;
            found.occurs[id] = true;
        }
    }
    for (const rockfall::Triangle& triangle : site.slope.terrain.triangles()) {
        if (triangle.surface > 0) {
            found.occurs[triangle.surface - 1] = true;
        }
    }
    return found;
}

}  // namespace

double middle_diameter_m(const RunResults& results) {
    return rockfall::diameter_range(start_law(results.scenario), results.site.sources).mean_m;
}

std::vector<GroundFigures> grounds_of(const RunResults& results) {
    const Occurrence found = occurrence_of(results.site);
    const double diameter_m = middle_diameter_m(results);
    std::vector<GroundFigures> grounds;
    for (std::size_t i = 0; i < found.cells.size(); ++i) {
        if (found.occurs[i]) {
            grounds.push_back(
                figures_of(results.site.slope.types[i], results.scenario.rockfall.fall, diameter_m));
            grounds.back().area_share =
                found.all == 0 ? 0.0 : static_cast<double>(found.cells[i]) / static_cast<double>(found.all);
        }
    }
    return grounds;
}

void write_grounds(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "grounds.csv"};
    for (const GroundFigures& ground : grounds_of(results)) {
        row.whole(static_cast<unsigned>(ground.code)).text(ground.label).number<4>(ground.area_share);
        row.text(ground.soil).number<3>(ground.r_n).number<3>(ground.r_t);
        row.number<6>(ground.p_stop).number<6>(ground.rolling_stops_per_m);
        row.number<3>(ground.friction).number<2>(ground.threshold_deg);
        row.number<2>(ground.dr_slow_percent).number<2>(ground.dr_fast_percent);
        row.number<2>(ground.dk_slow_percent).number<2>(ground.dk_fast_percent);
        row.number<2>(ground.angle_slow_deg).number<2>(ground.angle_fast_deg).number<2>(ground.limit_mps);
        row.end();
    }
}

}  // namespace coupling
