#include "rockfall/motion/picus/model.hpp"

#include <array>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace rockfall::picus {
namespace {

constexpr std::string_view types = "terrain.surface_types, or the shipped type";
constexpr std::string_view stops = "terrain.stopping, else terrain.surface_types, else the shipped type";

/// A figure of stopping, which the law may leave out.
template <StopCurve SurfaceType::*curve>
double if_by_chance(const SurfaceType& type, const Law& law, double diameter_m) {
    return law.stopping.by_chance ? (type.*curve).at(diameter_m) : no_figure;
}

constexpr std::array columns{
    GroundColumn<Law>{.name = "r_n",
                      .from = types,
                      .value = [](const SurfaceType& type, const Law& law,
                                  double) { return restitution_of(type, law.restitution).normal; }},
    GroundColumn<Law>{.name = "r_t",
                      .from = types,
                      .value = [](const SurfaceType& type, const Law& law,
                                  double) { return restitution_of(type, law.restitution).tangential; }},
    GroundColumn<Law>{
        .name = "jump_angle_factor",
        .from = types,
        .value = [](const SurfaceType& type, const Law& law,
                    double) { return law.jump_angle_by_ground ? type.jump_angle_factor : 1.0; }},
    GroundColumn<Law>{.name = "p_stop", .from = stops, .value = if_by_chance<&SurfaceType::stopping>},
    GroundColumn<Law>{.name = "rolling_stops_per_m",
                      .from = stops,
                      .value =
                          [](const SurfaceType& type, const Law& law, double diameter_m) {
                              return law.stopping.catches_rolling
                                         ? if_by_chance<&SurfaceType::rolling_stops_per_m>(type, law,
                                                                                           diameter_m)
                                         : no_figure;
                          }},
};

}  // namespace

const ModelDescription& Model::description() {
    // Measured on the first example and on an even slope of 40 degrees: 41 and 22 bytes.
    static const ModelDescription description{
        .name = "picus",
        .title = "PICUS Rock’n’Roll",
        .rocks = "rocks jump, roll and spin",
        .law = "jump-angle law and rolling",
        .source = "Rammer et al. 2010",
        .energy = "translation and rotation",
        .spins = true,
        .path_bytes_per_m = 30.0,
        .us_per_path_m = 0.1,
        .shared_settings = {"rockfall.rolling_edge_deg", "release.elongation", "release.elongation_scatter",
                            "rockfall.loss_by_elongation", "rockfall.loss_scatter"},
        .sideways_settings = {"picus.lateral_slow_deg", "picus.lateral_fast_deg", "picus.lateral_fast_mps"}};
    return description;
}

std::span<const GroundColumn<Law>> Model::ground_columns() {
    return columns;
}

void Model::take_factors(Law& law, const FallFactors& factors) {
    const auto times = [](config::Angle& angle, double factor) {
        angle = config::Angle::from_radians(factor * angle.in_radians());
    };
    law.rolling.friction *= factors.friction;
    times(law.jump_angle.coefficient, factors.jump_angle);
    times(law.lateral.at_rest, factors.sideways);
    times(law.lateral.when_fast, factors.sideways);
}

SidewaysTurn Model::sideways_turn(const Written& written) {
    return {config::joined("at impacts ±", config::to_text(written.lateral_slow_deg), "° (slow) to ±",
                           config::to_text(written.lateral_fast_deg), "° (fast rocks)"),
            description().sideways_settings};
}

}  // namespace rockfall::picus
