#include "rockfall/motion/classical/model.hpp"

#include <array>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "rockfall/motion/classical/friction.hpp"

namespace rockfall::classical {
namespace {

constexpr std::string_view types = "terrain.surface_types, or the shipped type";

constexpr std::array columns{
    GroundColumn<Law>{
        .name = "r_n",
        .from = types,
        .value = [](const SurfaceType& type, const Law&, double) { return type.as_published().normal; }},
    GroundColumn<Law>{
        .name = "r_t",
        .from = types,
        .value = [](const SurfaceType& type, const Law&, double) { return type.as_published().tangential; }},
    GroundColumn<Law>{
        .name = "friction",
        .from = "(1 - r_t) / r_t, classical.friction_angle_deg or the ground type",
        .value = [](const SurfaceType& type, const Law& law, double) { return friction_of(type, law); }},
};

}  // namespace

const ModelDescription& Model::description() {
    // Measured on the first example and on an even slope of 40 degrees: 127 and 45 bytes.
    static const ModelDescription description{
        .name = "classical",
        .title = "Classical, constant restitution",
        .rocks = "rocks are points that do not spin, energies are those of translation alone",
        .law = "constant restitution",
        .source = "Stevens 1998",
        .energy = "translation alone",
        .path_bytes_per_m = 80.0,
        .us_per_path_m = 0.43,
        .shared_settings = {"rockfall.rolling_edge_deg", "release.elongation", "release.elongation_scatter",
                            "rockfall.loss_by_elongation", "rockfall.loss_scatter"},
        .sideways_settings = {"classical.lateral_deg"}};
    return description;
}

std::span<const GroundColumn<Law>> Model::ground_columns() {
    return columns;
}

void Model::take_factors(Law& law, const FallFactors& factors) {
    law.lateral = config::Angle::from_radians(factors.sideways * law.lateral.in_radians());
    law.friction_angle_tangent *= factors.friction;
}

SidewaysTurn Model::sideways_turn(const Written& written) {
    return {config::joined("±", config::to_text(written.lateral_deg), "° at impacts"),
            description().sideways_settings};
}

}  // namespace rockfall::classical
