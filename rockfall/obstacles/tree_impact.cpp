#include "rockfall/obstacles/tree_impact.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall {
namespace {

/// Even a scratch turns the path a little: the limit on the angle sees at least this share of the stem's
/// energy.
constexpr double least_share_for_turning = 0.02;

config::Angle drawn_deviation(HitType type, const DeviationMatrix& matrix, double class_draw,
                              double angle_draw) {
    const std::array<double, 3>& shares = matrix.shares[static_cast<std::size_t>(type)];
    std::size_t k = 0;
    while (k < 2 && class_draw >= shares[k]) {
        class_draw -= shares[k];
        ++k;
    }
    const double low_rad = matrix.limits[k].in_radians();
    const double high_rad = matrix.limits[k + 1].in_radians();
    return config::Angle::from_radians(low_rad + angle_draw * (high_rad - low_rad));
}

}  // namespace

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
    // A hit above the thinnest tip finds no stem to speak of; the power needs a positive base.
    const double strength_j =
        relative_diameter > 0.0 ? stem.largest_energy_j * config::pow_of(relative_diameter, 2.31) : 0.0;
    const double available_j = usable_share(position) * strength_j;
    const double loss_j = std::min(energy_j, available_j);
    const double kept_share = (energy_j - loss_j) / energy_j;

    config::SinCos turn =
        config::sin_cos_of(drawn_deviation(type, law.deviation, draws[0], draws[1]).in_radians());
    const double largest_squared_sine =
        std::min(1.0, std::max(available_j, least_share_for_turning * strength_j) / energy_j);
    if (turn.sin * turn.sin > largest_squared_sine) {
        turn = {std::sqrt(largest_squared_sine), std::sqrt(1.0 - largest_squared_sine)};
    }
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
