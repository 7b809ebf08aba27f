#include "rockfall/draws/fall_draw.hpp"

#include <cassert>

#include "rockfall/laws/losses.hpp"

namespace rockfall {
namespace {

/// A factor of 1 must leave the last bit alone, which 1 - (1 - r) does not.
Restitution with_losses_times(Restitution usual, double factor) {
    return factor == 1.0 ? usual : with_losses(usual, factor);
}

StopCurve times(const StopCurve& curve, double factor, double most) {
    return factor == 1.0 ? curve : curve.times(factor, most);
}

}  // namespace

SurfaceType with_factors(const SurfaceType& type, const FallFactors& factors) {
    constexpr double any_rate = 1e9;
    SurfaceType changed = type;
    changed.restitution = with_losses_times(type.restitution, factors.losses);
    if (changed.published) {
        changed.published = with_losses_times(*type.published, factors.losses);
    }
    changed.rolling_friction *= factors.friction;
    changed.sliding_friction *= factors.friction;
    changed.stopping = times(type.stopping, factors.stopping, 1.0);
    changed.rolling_stops_per_m = times(type.rolling_stops_per_m, factors.stopping, any_rate);
    if (changed.soil) {
        changed.soil->restitution = with_losses_times(type.soil->restitution, factors.losses);
        changed.soil->friction *= factors.friction;
        changed.soil->sideways_rad.slow *= factors.sideways;
        changed.soil->sideways_rad.fast *= factors.sideways;
    }
    changed.block.friction *= factors.friction;
    changed.block.friction_max *= factors.friction;
    changed.block.rolling_resistance *= factors.losses;
    changed.block.drag_ps *= factors.losses;
    changed.block.soil_strength_kpa /= factors.losses;
    return changed;
}

FallLaw with_factors(const FallLaw& law, const FallFactors& factors) {
    FallLaw changed = law;
    for_each_model([&]<class Model>(std::type_identity<Model>) {
        if constexpr (requires(typename Model::Law & own) { Model::take_factors(own, factors); }) {
            Model::take_factors(changed.motion.of<Model>(), factors);
        }
    });
    changed.tree.energy_factor *= factors.tree_energy;
    changed.log.energy_factor *= factors.tree_energy;
    return changed;
}

FallDraw draw_of(const FallLaw& law, std::span<const SurfaceType> types, const FallFactors& factors,
                 std::span<const double> own_losses) {
    assert(own_losses.size() == types.size());
    FallDraw draw{with_factors(law, factors), {}, factors.block_size};
    draw.types.reserve(types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
        FallFactors here = factors;
        here.losses *= own_losses[i];
        draw.types.push_back(with_factors(types[i], here));
    }
    return draw;
}

}  // namespace rockfall
