#include "coupling/today/impact_table.hpp"

#include "coupling/results/figures.hpp"
#include "coupling/today/static_layouts.hpp"

namespace coupling {

namespace {

const char* word_for(rockfall::GroundImpact::Onward onward) {
    using Onward = rockfall::GroundImpact::Onward;
    return onward == Onward::jumps ? "jumps" : onward == Onward::rolls ? "rolls" : "stops";
}

}  // namespace

void write_impacts(std::ostream& out, std::span<const rockfall::RockImpacts> rocks, const Eigen::Vector2d& origin_m) {
    TableRows row{out, static_layouts(), "impacts.csv"};
    for (const rockfall::RockImpacts& rock : rocks) {
        for (std::size_t i = 0; i < rock.impacts.size(); ++i) {
            const rockfall::GroundImpact& impact = rock.impacts[i];
            row.whole(rock.rock).text(name_of(rock.cover)).whole(i);
            row.number<2>(impact.place_m.x() + origin_m.x()).number<2>(impact.place_m.y() + origin_m.y());
            row.number<2>(impact.place_m.z()).whole(static_cast<unsigned>(impact.ground));
            row.number<3>(impact.speed_in_mps).number<2>(impact.angle_in.in_degrees());
            row.text(word_for(impact.onward));
            row.number<3>(impact.speed_out_mps).number<2>(impact.angle_out.in_degrees());
            row.number<3>(impact.jump.length_m()).number<3>(impact.jump.plan_length_m());
            row.number<3>(impact.jump.highest_m).number<4>(impact.jump.time_s);
            row.end();
        }
    }
}

}  // namespace coupling
