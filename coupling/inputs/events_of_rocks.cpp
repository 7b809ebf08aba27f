#include "coupling/inputs/events_of_rocks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/units/angle.hpp"

namespace coupling::observed {
namespace {

double degrees_of(const rockfall::Speeds& speeds) {
    return config::Angle::from_radians(std::atan2(speeds.normal_mps, speeds.along_mps)).in_degrees();
}

}  // namespace

std::vector<std::uint64_t> rocks_for_impacts(std::uint64_t rocks) {
    constexpr std::uint64_t most_rocks = 2000;
    const std::uint64_t every = std::max<std::uint64_t>(1, rocks / most_rocks);
    std::vector<std::uint64_t> chosen;
    for (std::uint64_t rock = 0; rock < rocks; rock += every) {
        chosen.push_back(rock);
    }
    return chosen;
}

std::vector<SimulatedImpact> simulated_impacts(std::span<const rockfall::RockImpacts> rocks,
                                               rockfall::Cover cover) {
    std::vector<SimulatedImpact> impacts;
    for (const rockfall::RockImpacts& rock : rocks) {
        if (rock.cover != cover) {
            continue;
        }
        for (const rockfall::GroundImpact& impact : rock.impacts) {
            impacts.push_back({impact.ground, impact.before.whole_mps(), impact.after.whole_mps(),
                               degrees_of(impact.before), degrees_of(impact.after)});
        }
    }
    return impacts;
}

std::vector<EventComparison> compare_events(const Site& site, std::span<const SimulatedPassage> passages,
                                            std::span<const SimulatedImpact> impacts, std::uint64_t rocks) {
    std::vector<std::string> names;
    for (const rockfall::Target& target : site.targets) {
        names.push_back(target.id);
    }
    std::vector<EventComparison> all = compare_passages(site.observed_events, passages, names, rocks);
    const std::vector<EventComparison> of_impacts = compare_impacts(site.observed_events.impacts, impacts);
    all.insert(all.end(), of_impacts.begin(), of_impacts.end());
    return all;
}

}  // namespace coupling::observed
