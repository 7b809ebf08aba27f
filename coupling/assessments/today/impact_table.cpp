#include "coupling/assessments/today/impact_table.hpp"

#include <cmath>

#include "config/units/angle.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {

namespace {

const char* word_for(rockfall::GroundImpact::Onward onward) {
    using Onward = rockfall::GroundImpact::Onward;
    return onward == Onward::jumps ? "jumps" : onward == Onward::rolls ? "rolls" : "stops";
}

double angle_deg(const rockfall::Speeds& speeds) {
    return config::Angle::from_radians(std::atan2(speeds.normal_mps, speeds.along_mps)).in_degrees();
}

}  // namespace

void write_impacts(std::ostream& out, std::span<const rockfall::RockImpacts> rocks,
                   const Eigen::Vector2d& origin_m) {
    TableRows row{out, static_layouts(), "impacts.csv"};
    for (const rockfall::RockImpacts& rock : rocks) {
        for (std::size_t i = 0; i < rock.impacts.size(); ++i) {
            const rockfall::GroundImpact& impact = rock.impacts[i];
            row.whole(rock.rock).text(name_of(rock.cover)).whole(i);
            row.number<2>(impact.place_m.x() + origin_m.x()).number<2>(impact.place_m.y() + origin_m.y());
            row.number<2>(impact.place_m.z()).whole(static_cast<unsigned>(impact.ground));
            row.number<3>(impact.before.whole_mps()).number<2>(angle_deg(impact.before));
            row.text(word_for(impact.onward));
            row.number<3>(impact.after.whole_mps()).number<2>(angle_deg(impact.after));
            row.number<3>(impact.jump.length_m()).number<3>(impact.jump.plan_length_m());
            row.number<3>(impact.jump.highest_m).number<4>(impact.jump.time_s);
            row.end();
        }
    }
}

}  // namespace coupling
