#include "coupling/assessments/collapse/handed_departures.hpp"

#include <map>

namespace coupling::collapse {

Departures departures_of_single_blocks(const HandOver& hand_over, const CollapseSite& site) {
    if (!site.handed_ground) {
        return {};
    }
    const rockfall::Terrain& terrain = site.handed_ground->slope().terrain;
    std::map<rockfall::RimPart, std::uint64_t> left_over;
    for (const HandedFall& fall : hand_over.falls()) {
        if (fall.has_ended && fall.end.reason == rockfall::StopReason::left_terrain) {
            const Eigen::Vector2d end_m = fall.moments.back().centre_m.head<2>();
            ++left_over[terrain.rim().part_at(terrain, fall.end.triangle, end_m,
                                              fall.block.centre_m.head<2>())];
        }
    }
    return departures_of(hand_over.blocks(), left_over, terrain);
}

void warn_of_departures(const Departures& departures, config::Warnings& warnings) {
    if (auto sentence = warning_of(departures, "as single blocks")) {
        warnings.add(std::move(*sentence), config::Effect::answer);
    }
}

}  // namespace coupling::collapse
