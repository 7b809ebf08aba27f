#include "config/options/options.hpp"
#include "config/units/angle.hpp"
#include "rockfall/motion/classical/model.hpp"

namespace rockfall::classical {

void Model::declare(config::Options& options, Law& law, Written& written) {
    options.number("classical.restitution_deviation", law.restitution_deviation,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.5,
                    .meaning = "standard deviation of r_n and r_t at each impact, cut at 3 deviations",
                    .source = "choice, of the size that users of lumped-mass programs give"});
    options.number("classical.lateral_deg", written.lateral_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 90.0,
                    .meaning = "largest turn of a rock at an impact, either way, at every speed",
                    .source = "choice: that of fast rocks under picus"});
    options.choice(
        "classical.friction", law.friction,
        {{"from_rt", Friction::from_rt}, {"angle", Friction::angle}, {"ground", Friction::ground}},
        {.meaning = "friction of sliding: (1 - r_t) / r_t of the ground, one angle, or ground: its "
                    "sliding_friction, else that of its soil",
         .source = "choice; both are in use (help of RocFall, analysis method)"});
    options.number("classical.friction_angle_deg", written.friction_angle_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 89.0,
                    .meaning = "friction angle of sliding where classical.friction is angle",
                    .source = "choice",
                    .needs = {{"classical.friction", {"angle"}}}});
    options.number("classical.least_hop", law.least_hop,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "hops shorter than this times the rock's radius are sliding",
                    .source = "choice"});
}

void Model::take_over(const Written& written, const SharedSettings& shared, Law& law, const config::Options&,
                      config::Problems&) {
    law.lateral = config::Angle::from_degrees(written.lateral_deg);
    law.friction_angle_tangent = tangent_of_deg(written.friction_angle_deg);
    law.edge_angle_tangent = shared.edge_angle_tangent();
    law.losses = shared.losses;
    law.most_impacts = static_cast<std::uint32_t>(shared.most_impacts);
}

void Model::stay_in_plane(Law&, Written& written) {
    written.lateral_deg = 0.0;
}

}  // namespace rockfall::classical
