#include "config/options/options.hpp"
#include "config/units/angle.hpp"
#include "rockfall/motion/picus/model.hpp"
#include "rockfall/motion/seam/presets.hpp"

namespace rockfall::picus {
namespace {

void declare_restitution(config::Options& options, Law& law) {
    options.flag("picus.damping", law.restitution.damping,
                 {.meaning = "restitution falls with impact speed above 10 m/s",
                  .source = "Rammer et al. 2010, Eqs. 7-8; Johnson 1985",
                  .presets = from_rebound_on("no"),
                  .formerly = "rockfall.damping"});
    options.flag(
        "picus.fitted_restitution", law.restitution.fitted,
        {.meaning = "shipped ground types have the r_t fitted to where rocks came to rest; no: that of "
                    "the paper",
         .source = "fitted, see validation/README.md",
         .presets = published("no")});
    options.number("picus.normal_restitution_halved_mps", law.restitution.normal_halved_mps,
                   {.unit = "m/s",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "speed into the ground that halves the normal restitution; 0: none does",
                    .source = "Pfeiffer & Bowen 1989",
                    .presets = published("0")});
    options.number("picus.rt_noise", law.restitution.tangential_noise,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.5,
                    .meaning = "half width of the uniform noise on the tangential restitution",
                    .source = "Rammer et al. 2010, 2.4.1: 0.05",
                    .presets = published("0.05"),
                    .formerly = "rockfall.rt_noise",
                    .needs = {{"picus.rt_noise_scope", {"impact", "rock"}}}});
    options.number("picus.loss_noise", law.restitution.loss_noise,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "half width of the uniform noise on what the ground takes, 1 - r_t, by itself",
                    .source = "fitted to filmed rebounds, see validation/README.md",
                    .presets = published("0"),
                    .needs = {{"picus.rt_noise_scope", {"impact", "rock"}}}});
    options.choice("picus.rt_noise_scope", law.noise,
                   {{"off", NoiseScope::off}, {"impact", NoiseScope::impact}, {"rock", NoiseScope::rock}},
                   {.meaning = "whether that noise is drawn at each impact or once for each rock",
                    .source = "choice",
                    .formerly = "rockfall.rt_noise_scope"});
}

void declare_rebound(config::Options& options, Law& law, Written& written) {
    options.choice("picus.rebound", law.angle,
                   {{"jump_angle", ReboundAngle::jump_angle_law}, {"geometric", ReboundAngle::geometric}},
                   {.meaning = "how steeply rocks leave the ground: by speed, or mirrored by restitution",
                    .source = "Rammer et al. 2010, Eq. 9",
                    .formerly = "rockfall.rebound"});
    options.number(
        "picus.jump_angle_coefficient_deg", written.jump_angle_coefficient_deg,
        {.unit = "deg",
         .low = 1.0,
         .high = 180.0,
         .meaning = "jump angle at 1 m/s",
         .source = "80: Rammer et al. 2010, Eq. 9; less, as facets add to it; 14 of paper_initial is "
                   "rebuilt",
         .presets = {{"strict", "80"}, {"paper_rebound", "80"}, {"paper_initial", "14"}},
         .formerly = "rockfall.jump_angle_coefficient_deg"});
    options.number("picus.jump_angle_exponent", law.jump_angle.exponent,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 3.0,
                    .meaning = "the jump angle falls with speed to this power; 0: a constant angle",
                    .source = "Rammer et al. 2010, Eq. 9; section 3.1 for paper_initial",
                    .presets = from_rebound_on("0"),
                    .formerly = "rockfall.jump_angle_exponent"});
    options.number("picus.jump_angle_cap_deg", written.jump_angle_cap_deg,
                   {.unit = "deg",
                    .low = 1.0,
                    .high = 89.0,
                    .meaning = "largest jump angle: the law was fitted to faster rocks",
                    .source = "choice",
                    .formerly = "rockfall.jump_angle_cap_deg"});
    options.number("picus.jump_angle_scatter", law.jump_angle.scatter,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "standard deviation of ln(jump angle), cut at two deviations",
                    .source = "choice, from published spreads at Vaujany and Bad Ischl",
                    .presets = published("0"),
                    .formerly = "rockfall.jump_angle_scatter"});
    options.flag("picus.jump_angle_by_ground", law.jump_angle_by_ground,
                 {.meaning = "jump angles are multiplied by jump_angle_factor of the ground type",
                  .source = "choice, from jumps observed on pasture",
                  .presets = published("no")});
    options.number("picus.facet_slope_by_losses", law.facets.slope_by_losses,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "rocks meet facets up to this times 1 - r_t steep; 0: even ground",
                    .source = "fitted to filmed rebounds, see validation/README.md",
                    .presets = published("0")});
    options.flag(
        "picus.impact_friction", law.impact_friction,
        {.meaning = "an impact takes at least what dry friction does: hops are no cheaper than rolling",
         .source = "Coulomb friction at impacts; that it bounds r_t: choice",
         .presets = published("no")});
    options.flag("picus.blend_steep_impacts", law.blend_steep_impacts,
                 {.meaning = "impacts steeper than 60 deg go over to the geometric rebound",
                  .source = "choice",
                  .presets = published("no"),
                  .formerly = "rockfall.blend_steep_impacts"});
}

void declare_deviation(config::Options& options, Law& law, Written& written) {
    options.number("picus.lateral_slow_deg", written.lateral_slow_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 90.0,
                    .meaning = "largest sideways turn of a slow rock at a ground impact",
                    .source = "choice, 10-20 % lateral dispersion (Azzoni & de Freitas 1995)",
                    .formerly = "rockfall.lateral_slow_deg"});
    options.number("picus.lateral_fast_deg", written.lateral_fast_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 90.0,
                    .meaning = "largest sideways turn of a fast rock at a ground impact",
                    .source = "choice",
                    .formerly = "rockfall.lateral_fast_deg"});
    options.number("picus.lateral_fast_mps", law.lateral.fast_mps,
                   {.unit = "m/s",
                    .low = 0.1,
                    .high = 100.0,
                    .meaning = "speed from which a rock counts as fast here",
                    .source = "choice, as in PiR3D (Cottaz et al. 2010)",
                    .formerly = "rockfall.lateral_fast_mps"});
}

void declare_rolling(config::Options& options, RollingLaw& law) {
    options.number("picus.rolling_friction", law.friction,
                   {.unit = "-",
                    .low = 0.01,
                    .high = 2.0,
                    .meaning = "rolling friction coefficient of ground types without one of their own",
                    .source = "Azzoni et al. 1995; Rammer et al. 2010",
                    .formerly = "rockfall.rolling_friction"});
    options.number("picus.rolling_start_factor", law.start_factor,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 5.0,
                    .meaning = "slower than this times sqrt(g R cos b) after an impact, rocks roll",
                    .source = "choice",
                    .formerly = "rockfall.rolling_start_factor"});
    options.number("picus.rolling_launch_factor", law.launch_factor,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 50.0,
                    .meaning = "faster than this times sqrt(g R cos b), rolling rocks jump",
                    .source = "choice",
                    .formerly = "rockfall.rolling_launch_factor"});
}

void declare_stopping(config::Options& options, Law& law) {
    options.flag("picus.stopping", law.stopping.by_chance,
                 {.meaning = "ground impacts stop rocks with the probability p_stop of the surface",
                  .source = "Rammer et al. 2010, Eq. 10",
                  .presets = from_final_on("no"),
                  .formerly = "rockfall.stopping"});
    options.flag("picus.rolling_stops", law.stopping.catches_rolling,
                 {.meaning = "the ground also catches rolling rocks, at the rate rolling_stops_per_m",
                  .source = "choice; the paper stops rocks at impacts alone",
                  .presets = published("no"),
                  .needs = {{"picus.stopping"}}});
    options.flag(
        "picus.stops_by_hop_length", law.stops_by_hop_length,
        {.meaning = "a hop n times as long as the law's stops like n impacts; no: each impact counts",
         .source = "choice, so that longer hops do not let more rocks pass",
         .presets = published("no"),
         .needs = {{"picus.stopping"}}});
    options.number("picus.rest_speed_mps", law.stopping.slow_mps,
                   {.unit = "m/s",
                    .low = 0.0,
                    .high = 5.0,
                    .meaning = "slower rocks rest on ground flatter than the friction angle",
                    .source = "choice, as in Rockyfor3D",
                    .formerly = "rockfall.rest_speed_mps"});
}

}  // namespace

void Model::declare(config::Options& options, Law& law, Written& written) {
    declare_restitution(options, law);
    declare_rebound(options, law, written);
    declare_deviation(options, law, written);
    declare_rolling(options, law.rolling);
    declare_stopping(options, law);
}

void Model::take_over(const Written& written, const SharedSettings& shared, Law& law,
                      const config::Options& options, config::Problems& problems) {
    law.jump_angle.coefficient = config::Angle::from_degrees(written.jump_angle_coefficient_deg);
    law.jump_angle.cap = config::Angle::from_degrees(written.jump_angle_cap_deg);
    law.lateral.at_rest = config::Angle::from_degrees(written.lateral_slow_deg);
    law.lateral.when_fast = config::Angle::from_degrees(written.lateral_fast_deg);
    law.rolling.edge_angle_tangent = shared.edge_angle_tangent();
    law.losses = shared.losses;
    law.stopping.most_impacts = static_cast<std::uint32_t>(shared.most_impacts);
    if (law.rolling.launch_factor <= law.rolling.start_factor) {
        problems.add(config::ExitCode::settings, options.place_of("picus.rolling_launch_factor"),
                     "picus.rolling_launch_factor not above picus.rolling_start_factor",
                     "a rock that just began to roll not to jump at once");
    }
}

void Model::stay_in_plane(Law&, Written& written) {
    written.lateral_slow_deg = 0.0;
    written.lateral_fast_deg = 0.0;
}

}  // namespace rockfall::picus
