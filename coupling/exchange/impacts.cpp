#include "coupling/exchange/impacts.hpp"

#include <algorithm>
#include <cmath>

#include "config/random/stream.hpp"
#include "rockfall/obstacles/tree_energy.hpp"

namespace coupling::exchange {

forest::Impact impact_on(const forest::Tree& tree, const rockfall::TreeHitRecord& hit,
                         const rockfall::PlacedStem& stem, const rockfall::RockRecord& rock,
                         double fracture_energy) {
    const double sound_j = rockfall::largest_energy_j(tree.dbh_cm, fracture_energy);
    return {.tree = tree.id,
            .height_m = std::max(0.0, static_cast<double>(hit.height_m)),
            .energy_share = hit.energy_j / sound_j,
            .frontal = hit.type == rockfall::HitType::frontal,
            .rock_diameter_m = rock.diameter_m,
            .direction_rad = std::atan2(stem.y_m - hit.position_m.y(), stem.x_m - hit.position_m.x())};
}

std::vector<forest::Impact> impacts_of(std::span<const RockHit> hits, const RealRocks& real) {
    std::vector<forest::Impact> impacts;
    for (const RockHit& hit : hits) {
        const config::StreamKey key{real.seed, real.replicate, static_cast<std::uint16_t>(real.year),
                                    hit.rock};
        if (config::RandomStream{key, config::Purpose::real_rock}.uniform() < real.share) {
            impacts.push_back(hit.impact);
        }
    }
    return impacts;
}

}  // namespace coupling::exchange
