#include "rockfall/motion/rigid/model.hpp"

#include <array>

namespace rockfall::rigid {
namespace {

constexpr std::string_view grounds = "rigid_ground or the column of terrain.surface_types, or [rigid]";

Ground figures_of(const SurfaceType& type, const Law& law) {
    return ground_under(law, type.block);
}

constexpr std::array columns{
    GroundColumn<Law>{.name = "friction",
                      .from = grounds,
                      .remark = "at the start of a slip",
                      .value = [](const SurfaceType& type, const Law& law,
                                  double) { return figures_of(type, law).friction; }},
    GroundColumn<Law>{.name = "friction_max",
                      .from = grounds,
                      .value =
                          [](const SurfaceType& type, const Law& law, double) {
                              const Ground ground = figures_of(type, law);
                              return ground.law == FrictionLaw::slip ? ground.friction_max : ground.friction;
                          }},
    GroundColumn<Law>{.name = "slip_kappa_pm",
                      .from = grounds,
                      .value =
                          [](const SurfaceType& type, const Law& law, double) {
                              const Ground ground = figures_of(type, law);
                              return ground.law == FrictionLaw::slip ? ground.slip_kappa_pm : 0.0;
                          }},
    GroundColumn<Law>{.name = "slip_beta_ps",
                      .from = grounds,
                      .value =
                          [](const SurfaceType& type, const Law& law, double) {
                              const Ground ground = figures_of(type, law);
                              return ground.law == FrictionLaw::slip ? ground.slip_beta_ps : 0.0;
                          }},
    GroundColumn<Law>{.name = "contact_drag_ps",
                      .from = grounds,
                      .value = [](const SurfaceType& type, const Law& law,
                                  double) { return figures_of(type, law).drag_ps; }},
    GroundColumn<Law>{.name = "restitution",
                      .from = grounds,
                      .value = [](const SurfaceType& type, const Law& law,
                                  double) { return figures_of(type, law).restitution; }},
    GroundColumn<Law>{.name = "rolling_resistance",
                      .from = grounds,
                      .value = [](const SurfaceType& type, const Law& law,
                                  double) { return figures_of(type, law).rolling_resistance; }},
    GroundColumn<Law>{
        .name = "soil_strength_kpa",
        .from = grounds,
        .value = [](const SurfaceType& type, const Law& law,
                    double) { return law.scar.on ? figures_of(type, law).soil_strength_kpa : 0.0; }},
    GroundColumn<Law>{.name = "roughness_m",
                      .from = "terrain.surface_types or the shipped type, or [rigid]",
                      .value = [](const SurfaceType& type, const Law& law,
                                  double) { return roughness_of(law, type.roughness_m); }},
    GroundColumn<Law>{
        .name = "p_stop",
        .from = "terrain.stopping, the column p_stop or the shipped type; counts with rigid.stops_by_chance",
        .value = [](const SurfaceType& type, const Law& law,
                    double diameter_m) { return law.stops_by_chance ? type.stopping.at(diameter_m) : 0.0; }},
    GroundColumn<Law>{.name = "rolling_stops_per_m",
                      .from = "as p_stop",
                      .value =
                          [](const SurfaceType& type, const Law& law, double diameter_m) {
                              return law.stops_by_chance ? type.rolling_stops_per_m.at(diameter_m) : 0.0;
                          }},
};

}  // namespace

const ModelDescription& Model::description() {
    static const ModelDescription description{
        .name = "rigid",
        .title = "Rigid blocks",
        .rocks = "rocks are rigid blocks with a shape: they fly, turn, strike, slide and roll",
        .law = "rigid blocks of real shape, non-smooth contact with Coulomb friction",
        .source = "Leine et al. 2014, Multibody Syst. Dyn. 32:241",
        .energy = "translation and rotation",
        .spins = true,
        .has_shape = true,
        .path_bytes_per_m = 400.0,
        .shared_settings = {"release.attitude"},
        .caution =
            "rockfall.motion = rigid: where blocks stop is not confirmed: in the field tests run-out "
            "spreads too widely or too few blocks stop; simulate the same scenario with another "
            "rockfall.motion, such as picus, before run-out or reach is used"};
    return description;
}

std::span<const GroundColumn<Law>> Model::ground_columns() {
    return columns;
}

void Model::take_factors(Law& law, const FallFactors& factors) {
    // Figures below 0 are those of the ground types, which have their factors already.
    for (double* figure : {&law.friction, &law.friction_max}) {
        *figure *= *figure >= 0.0 ? factors.friction : 1.0;
    }
    for (double* figure : {&law.rolling_resistance, &law.drag_ps}) {
        *figure *= *figure >= 0.0 ? factors.losses : 1.0;
    }
    law.soil_strength_kpa /= law.soil_strength_kpa >= 0.0 ? factors.losses : 1.0;
}

SidewaysTurn Model::sideways_turn(const Written&) {
    return {"by the shape of the block and of the ground", {}};
}

}  // namespace rockfall::rigid
