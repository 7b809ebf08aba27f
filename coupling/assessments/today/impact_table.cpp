#include "coupling/assessments/today/impact_table.hpp"

#include <cmath>

#include "config/units/angle.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {

namespace {

const char* word_for(rockfall::GroundImpact::Onward onward) {
    using Onward = rockfall::GroundImpact::Onward;
    return onward == Onward::jumps ? "jumps" : onward == Onward::rolls ? "rolls" : "stops";
}

double angle_deg(const rockfall::Speeds& speeds) {
    return config::Angle::from_radians(std::atan2(speeds.normal_mps, speeds.along_mps)).in_degrees();
}

struct ImpactRow : rockfall::GroundImpact {
    const rockfall::RockImpacts& rock;
    std::size_t number;
    const Eigen::Vector2d& origin_m;
};

TableOf<ImpactRow> impact_table() {
    using rockfall::GroundImpact;
    return {
        "impacts.csv",
        "Each ground impact of the rocks whose paths are kept: place, speeds and angles, the jump before.",
        "an impact on the ground of a rock whose path is kept",
        {{rock_column(), [](const auto& row) { return row.rock.rock; }},
         {cover_column(), [](const auto& row) { return name_of(row.rock.cover); }},
         {"impact", "number of the impact along the path, from 0",
          [](const auto& row) { return row.number; }},
         {place_columns("", "the rock's underside"),
          [](const auto& row) -> Eigen::Vector3d {
              const Eigen::Vector3d& place_m = row.place_m;
              return {place_m.x() + row.origin_m.x(), place_m.y() + row.origin_m.y(), place_m.z()};
          }},

         {"ground", "code of the ground type", "input terrain", &GroundImpact::ground},
         {"speed_in_mps", 3, "speed before it", [](const auto& impact) { return impact.before.whole_mps(); }},
         {"angle_in_deg", 2, "of the velocity before it below the face of the terrain",
          [](const auto& impact) { return angle_deg(impact.before); }},
         {"onward", "jumps, rolls or stops", [](const auto& impact) { return word_for(impact.onward); }},
         {"speed_out_mps", 3, "speed after it", [](const auto& impact) { return impact.after.whole_mps(); }},
         {"angle_out_deg", 2, "of the velocity after it above the face of the terrain; 0 where it rolls",
          [](const auto& impact) { return angle_deg(impact.after); }},
         {"jump_length_m", 3, "straight length of the jump that ended here",
          [](const auto& impact) { return impact.jump.length_m(); }},
         {"jump_plan_length_m", 3, "the same in plan",
          [](const auto& impact) { return impact.jump.plan_length_m(); }},
         {"jump_height_m", 3, "its largest height above the ground, vertical",
          [](const auto& impact) { return impact.jump.highest_m; }},
         {"jump_time_s", 4, "its time", [](const auto& impact) { return impact.jump.time_s; }}}};
}

}  // namespace

TableLayout impact_layout() {
    return impact_table();
}

WrittenFile write_impacts(const std::filesystem::path& folder, std::span<const rockfall::RockImpacts> rocks,
                          const Eigen::Vector2d& origin_m) {
    return impact_table().write(folder, [&](auto& rows) {
        for (const rockfall::RockImpacts& rock : rocks) {
            for (std::size_t i = 0; i < rock.impacts.size(); ++i) {
                rows.add({rock.impacts[i], rock, i, origin_m});
            }
        }
    });
}

}  // namespace coupling
