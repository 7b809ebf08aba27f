#include "rockfall/obstacles/tree_impact.hpp"

#include <algorithm>
#include <cmath>

#include "rockfall/obstacles/tree_energy.hpp"

namespace rockfall {

HitType hit_type(double relative_position, const TreeImpactLaw& law) {
    if (relative_position <= law.frontal_limit) {
        return HitType::frontal;
    }
    return relative_position <= law.scratch_limit ? HitType::lateral : HitType::scratch;
}

TreeImpact meet_stem(double energy_j, const StemHit& hit, const PlacedStem& stem, const TreeImpactLaw& law,
                     const config::FourUniforms& draws) {
    const double position = std::min(1.0, std::abs(hit.offset_m) / hit.reach_m);
    const HitType type = hit_type(position, law);
    const double relative_diameter =
        law.height_effect ? std::min(1.0, taper(std::min(hit.height_m, stem.top_m), stem.height_m)) : 1.0;
    const double strength_j = law.energy_factor * energy_at_j(stem.largest_energy_j, relative_diameter);
    const double available_j = usable_share(position) * strength_j;
    const double loss_j = std::min(energy_j, available_j);
    const double kept_share = (energy_j - loss_j) / energy_j;

    const config::Angle drawn = drawn_deviation(type, law.deviation, draws[0], draws[1]);
    config::SinCos turn =
        limited_turn(config::sin_cos_of(drawn.in_radians()), available_j, strength_j, energy_j);
    const bool axis_is_left = hit.offset_m > 0.0 || (hit.offset_m == 0.0 && draws[2] < 0.5);
    if (axis_is_left) {
        turn.sin = -turn.sin;
    }
    const bool stopped = kept_share < law.stop_share;
    return {type,
            stopped ? energy_j : loss_j,
            stopped ? 0.0 : std::sqrt(kept_share),
            turn,
            type == HitType::frontal && energy_j > strength_j,
            stopped};
}

}  // namespace rockfall
