#include "rockfall/motion/pir3d/model.hpp"

#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/units/angle.hpp"

namespace rockfall::pir3d {
namespace {

constexpr std::string_view soils = "terrain.soils, or the shipped soil";

/// A column whose figure is one of the soil.
template <class Figure>
constexpr GroundColumn<Law> of_soil(std::string_view name, Figure, std::string_view from = soils,
                                    std::string_view remark = {}) {
    return {.name = name,
            .from = from,
            .remark = remark,
            .value = [](const SurfaceType& type, const Law&, double) {
                return type.soil ? Figure{}(*type.soil) : no_figure;
            }};
}

double percent(double share) {
    return 100.0 * share;
}

double degrees(double angle_rad) {
    return config::Angle::from_radians(angle_rad).in_degrees();
}

constexpr std::array columns{
    GroundColumn<Law>{
        .name = "soil",
        .from = "terrain.surface_types, or the shipped type; pir3d: terrain.soils, or the shipped soil"},
    of_soil(
        "r_n", [](const Soil& soil) { return soil.restitution.normal; }, soils, "of the soil"),
    of_soil(
        "r_t", [](const Soil& soil) { return soil.restitution.tangential; }, soils, "of the soil"),
    of_soil(
        "friction", [](const Soil& soil) { return soil.friction; }, "the soil"),
    of_soil("threshold_deg", [](const Soil& soil) { return soil.threshold_tangent; }),
    of_soil("dr_slow_percent", [](const Soil& soil) { return percent(soil.normal_share.slow); }),
    of_soil("dr_fast_percent", [](const Soil& soil) { return percent(soil.normal_share.fast); }),
    of_soil("dk_slow_percent", [](const Soil& soil) { return percent(soil.friction_share.slow); }),
    of_soil("dk_fast_percent", [](const Soil& soil) { return percent(soil.friction_share.fast); }),
    of_soil("angle_slow_deg", [](const Soil& soil) { return degrees(soil.sideways_rad.slow); }),
    of_soil("angle_fast_deg", [](const Soil& soil) { return degrees(soil.sideways_rad.fast); }),
    of_soil("limit_mps", [](const Soil& soil) { return soil.normal_share.limit_mps; }),
    of_soil("dr_t_slow_percent", [](const Soil& soil) { return percent(soil.tangential_share.slow); }),
    of_soil("dr_t_fast_percent", [](const Soil& soil) { return percent(soil.tangential_share.fast); }),
    of_soil("angle_v_slow_deg", [](const Soil& soil) { return degrees(soil.upwards_rad.slow); }),
    of_soil("angle_v_fast_deg", [](const Soil& soil) { return degrees(soil.upwards_rad.fast); }),
    of_soil("limit_r_t_mps", [](const Soil& soil) { return soil.tangential_share.limit_mps; }),
    of_soil("limit_k_mps", [](const Soil& soil) { return soil.friction_share.limit_mps; }),
    of_soil("limit_angle_h_mps", [](const Soil& soil) { return soil.sideways_rad.limit_mps; }),
    of_soil("limit_angle_v_mps", [](const Soil& soil) { return soil.upwards_rad.limit_mps; }),
};

}  // namespace

const ModelDescription& Model::description() {
    // Measured on the first example and on an even slope of 40 degrees: 40 and 220 bytes.
    static const ModelDescription description{
        .name = "pir3d",
        .title = "PiR3D",
        .rocks = "rocks slide and do not spin, energies are those of translation alone",
        .law = "sliding and PiR3D's soils",
        .source = "Cottaz et al. 2010",
        .energy = "translation alone",
        .needs_soils = true,
        .path_bytes_per_m = 90.0,
        .us_per_path_m = 0.22,
        .shared_settings = {"release.elongation", "release.elongation_scatter", "rockfall.loss_by_elongation",
                            "rockfall.loss_scatter"}};
    return description;
}

std::span<const GroundColumn<Law>> Model::ground_columns() {
    return columns;
}

/// Restitution that knows no speed lets rocks get ever faster on long slopes.
std::vector<std::string> Model::doubts(const Slope&, double drop_m, const Law&) {
    constexpr double long_drop_m = 300.0;  // choice: beyond the slopes that the model was fitted on
    if (drop_m < long_drop_m) {
        return {};
    }
    return {config::joined(
        "pir3d: restitution does not fall with speed, so nothing bounds the speed of rocks; they "
        "may drop ",
        std::to_string(std::lround(drop_m)),
        " m here (over 1400 m this model gave up to 97 m/s). Compare speeds and energies with "
        "another rockfall.motion")};
}

SidewaysTurn Model::sideways_turn(const Written&) {
    return {"at impacts as the soils of PiR3D say", {"pir3d.spread", "pir3d.uncertainty", "terrain.soils"}};
}

}  // namespace rockfall::pir3d
