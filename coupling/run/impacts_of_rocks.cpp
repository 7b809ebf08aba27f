#include "coupling/run/impacts_of_rocks.hpp"

#include <algorithm>
#include <optional>

#include "rockfall/trajectory.hpp"

namespace coupling {

std::vector<rockfall::RockImpacts> impacts_of(const rockfall::Assessment& assessment,
                                              std::span<const std::uint64_t> rocks) {
    std::vector<rockfall::RockImpacts> all;
    rockfall::ImpactLog log{assessment.slope};
    rockfall::FallScratch scratch;
    for (const std::uint64_t rock : rocks) {
        const auto after = std::upper_bound(assessment.sources.begin(), assessment.sources.end(), rock,
                                            [](std::uint64_t number, const rockfall::ReleaseSource& source) {
                                                return number < source.first_rock;
                                            });
        const auto number = static_cast<std::uint32_t>(after - assessment.sources.begin()) - 1;
        const config::StreamKey key{assessment.seed, assessment.replicate, assessment.year, rock};
        const std::optional<rockfall::RockStart> start = assessment.start_of_rock(number, key);
        if (!start) {
            continue;  // its place lies outside the terrain
        }
        for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
            if (cover == rockfall::Cover::forest && assessment.only_bare()) {
                continue;
            }
            log.begin();
            rockfall::fall(assessment.slope_of(rock), assessment.obstacles(cover, {}),
                           assessment.law_of(rock), key, *start, scratch, log);
            all.push_back({rock, cover, {log.impacts().begin(), log.impacts().end()}});
        }
    }
    return all;
}

}  // namespace coupling
