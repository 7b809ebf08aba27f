#include "rockfall/parameters.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "config/data/shipped_tables.hpp"
#include "config/math/elementary.hpp"
#include "config/table/table.hpp"

namespace rockfall {

namespace {

using Presets = std::vector<config::Preset>;

/// A value that all three published variants share: they differ from the default in the same way.
Presets published(const std::string& value) {
    return {{"strict", value}, {"paper_rebound", value}, {"paper_initial", value}};
}

/// What is switched off in the initial model of the paper (its section 3.1), and what in the step after it.
Presets from_rebound_on(const std::string& initial) {
    return {{"paper_initial", initial}};
}
Presets from_final_on(const std::string& earlier) {
    return {{"paper_rebound", earlier}, {"paper_initial", earlier}};
}

void declare_ground(config::Options& options, GroundLaw& ground) {
    options.number("rockfall.vertical_tolerance_m", ground.vertical_tolerance_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "largest height error when a DEM is thinned; 0 keeps every point",
                    .source = "choice"});
    options.number("rockfall.contact_support_m", ground.contact_support_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 50.0,
                    .meaning = "radius over which a rock feels the ground as a plane; 0: the bare grid",
                    .source = "Rammer et al. 2010, discussion; value: choice",
                    .presets = published("0")});
    options.number("rockfall.contact_shift_m", ground.contact_shift_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 50.0,
                    .meaning = "no point of the ground is moved further than this by the contact zone",
                    .source = "choice"});
}

void declare_motion(config::Options& options, MotionLaws& motion) {
    options.choice(
        "rockfall.motion", motion.model,
        {{"picus", MotionModel::picus}, {"pir3d", MotionModel::pir3d}, {"classical", MotionModel::classical}},
        {.meaning = "motion model: jump-angle law and rolling; sliding and PiR3D's soils; or "
                    "constant restitution",
         .source = "Rammer et al. 2010; Cottaz et al. 2010; Stevens 1998"});
    pir3d::Law& law = motion.pir3d;
    options.choice("pir3d.spread", law.spread,
                   {{"uniform", pir3d::Spread::uniform}, {"normal", pir3d::Spread::normal}},
                   {.meaning = "distribution of k, R_N, R_T and the angles; normal is cut at 3 deviations",
                    .source = "Cottaz et al. 2010, 2.4"});
    options.choice("pir3d.uncertainty", law.uncertainty,
                   {{"off", pir3d::Uncertainty::off},
                    {"constant", pir3d::Uncertainty::constant},
                    {"by_speed", pir3d::Uncertainty::by_speed}},
                   {.meaning = "their widths: none, those at rest, or falling with speed",
                    .source = "Cottaz et al. 2010, Eqs. 6-9"});
    options.number("pir3d.position_tolerance_m", law.position_tolerance_m,
                   {.unit = "m",
                    .low = 1e-9,
                    .high = 1.0,
                    .meaning = "largest error of a step of sliding; larger ones are made again, shorter",
                    .source = "Cottaz et al. 2010, 2.3.1.2"});
    options.number("pir3d.least_hop", law.least_hop,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "hops shorter than this times the rock's radius are sliding",
                    .source = "choice"});
}

void declare_classical(config::Options& options, classical::Law& law, WrittenLaw& written) {
    options.number("classical.restitution_deviation", law.restitution_deviation,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.5,
                    .meaning = "standard deviation of r_n and r_t at each impact, cut at 3 deviations",
                    .source = "choice, of the size that users of lumped-mass programs give"});
    options.number("classical.lateral_deg", written.classical_lateral_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 90.0,
                    .meaning = "largest turn of a rock at an impact, either way, at every speed",
                    .source = "choice: that of fast rocks under picus"});
    options.choice("classical.friction", law.friction,
                   {{"from_rt", classical::Friction::from_rt}, {"angle", classical::Friction::angle}},
                   {.meaning = "friction of sliding: (1 - r_t) / r_t of the ground, or one angle",
                    .source = "choice; both are in use (help of RocFall, analysis method)"});
    options.number("classical.friction_angle_deg", written.classical_friction_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 89.0,
                    .meaning = "friction angle of sliding where classical.friction is angle",
                    .source = "choice"});
    options.number("classical.least_hop", law.least_hop,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "hops shorter than this times the rock's radius are sliding",
                    .source = "choice"});
}

void declare_restitution(config::Options& options, PicusLaw& law) {
    options.flag("rockfall.damping", law.restitution.damping,
                 {.meaning = "restitution falls with impact speed above 10 m/s",
                  .source = "Rammer et al. 2010, Eqs. 7-8; Johnson 1985",
                  .presets = from_rebound_on("no")});
    options.number("rockfall.rt_noise", law.restitution.tangential_noise,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.5,
                    .meaning = "half width of the uniform noise on the tangential restitution",
                    .source = "Rammer et al. 2010, 2.4.1"});
    options.choice("rockfall.rt_noise_scope", law.noise,
                   {{"off", NoiseScope::off}, {"impact", NoiseScope::impact}, {"rock", NoiseScope::rock}},
                   {.meaning = "whether that noise is drawn at each impact or once for each rock",
                    .source = "choice"});
}

void declare_rebound(config::Options& options, PicusLaw& law, WrittenLaw& written) {
    options.choice("rockfall.rebound", law.angle,
                   {{"jump_angle", ReboundAngle::jump_angle_law}, {"geometric", ReboundAngle::geometric}},
                   {.meaning = "how steeply rocks leave the ground: by speed, or mirrored by restitution",
                    .source = "Rammer et al. 2010, Eq. 9",
                    .presets = from_rebound_on("geometric")});
    options.number("rockfall.jump_angle_coefficient_deg", written.jump_angle_coefficient_deg,
                   {.unit = "deg",
                    .low = 1.0,
                    .high = 180.0,
                    .meaning = "jump angle at 1 m/s",
                    .source = "Rammer et al. 2010, Eq. 9"});
    options.number("rockfall.jump_angle_exponent", law.jump_angle.exponent,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 3.0,
                    .meaning = "the jump angle falls with speed to this power",
                    .source = "Rammer et al. 2010, Eq. 9"});
    options.number("rockfall.jump_angle_cap_deg", written.jump_angle_cap_deg,
                   {.unit = "deg",
                    .low = 1.0,
                    .high = 89.0,
                    .meaning = "largest jump angle: the law was fitted to faster rocks",
                    .source = "choice"});
    options.number("rockfall.jump_angle_scatter", law.jump_angle.scatter,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "standard deviation of ln(jump angle), cut at two deviations",
                    .source = "choice, from the heights observed at Vaujany",
                    .presets = published("0")});
    options.flag("rockfall.blend_steep_impacts", law.blend_steep_impacts,
                 {.meaning = "impacts steeper than 60 deg go over to the geometric rebound",
                  .source = "choice",
                  .presets = published("no")});
}

void declare_deviation(config::Options& options, PicusLaw& law, WrittenLaw& written) {
    options.number("rockfall.lateral_slow_deg", written.lateral_slow_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 90.0,
                    .meaning = "largest sideways turn of a slow rock at a ground impact",
                    .source = "choice, 10-20 % lateral dispersion (Azzoni & de Freitas 1995)"});
    options.number("rockfall.lateral_fast_deg", written.lateral_fast_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 90.0,
                    .meaning = "largest sideways turn of a fast rock at a ground impact",
                    .source = "choice"});
    options.number("rockfall.lateral_fast_mps", law.lateral.fast_mps,
                   {.unit = "m/s",
                    .low = 0.1,
                    .high = 100.0,
                    .meaning = "speed from which a rock counts as fast here",
                    .source = "choice, as in PiR3D (Cottaz et al. 2010)"});
}

void declare_rolling(config::Options& options, RollingLaw& law, WrittenLaw& written) {
    options.number("rockfall.rolling_friction", law.friction,
                   {.unit = "-",
                    .low = 0.01,
                    .high = 2.0,
                    .meaning = "rolling friction coefficient of every ground type",
                    .source = "Azzoni et al. 1995; Rammer et al. 2010"});
    options.number("rockfall.rolling_edge_deg", written.rolling_edge_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 45.0,
                    .meaning = "bend of the ground above which a rolling rock takes off or hits",
                    .source = "choice, 2-8 deg in PiR3D (Cottaz et al. 2010)"});
    options.number("rockfall.rolling_start_factor", law.start_factor,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 5.0,
                    .meaning = "slower than this times sqrt(g R cos b) after an impact, rocks roll",
                    .source = "choice"});
    options.number("rockfall.rolling_launch_factor", law.launch_factor,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 50.0,
                    .meaning = "faster than this times sqrt(g R cos b), rolling rocks jump",
                    .source = "choice"});
}

void declare_stopping(config::Options& options, StoppingLaw& law, WrittenLaw& written) {
    options.flag("rockfall.stopping", law.by_chance,
                 {.meaning = "ground impacts stop rocks with the probability p_stop of the surface",
                  .source = "Rammer et al. 2010, Eq. 10",
                  .presets = from_final_on("no")});
    options.number("rockfall.rest_speed_mps", law.slow_mps,
                   {.unit = "m/s",
                    .low = 0.0,
                    .high = 5.0,
                    .meaning = "slower rocks rest on ground flatter than the friction angle",
                    .source = "choice, as in Rockyfor3D"});
    options.count("rockfall.most_impacts", written.most_impacts,
                  {.low = 100,
                   .high = 1e6,
                   .meaning = "a rock with more ground impacts is given up and counted as such",
                   .source = "choice"});
}

void declare_trees(config::Options& options, TreeImpactLaw& law) {
    options.number("tree_impact.frontal_limit", law.frontal_limit,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "hits more central than this (0 centre, 1 edge) are frontal",
                    .source = "choice, from the sigmoid of Dorren & Berger 2006"});
    options.number("tree_impact.scratch_limit", law.scratch_limit,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "hits further out than this only scratch",
                    .source = "choice, zero of the sigmoid of Dorren & Berger 2006"});
    options.flag("tree_impact.taper", law.taper,
                 {.meaning = "stems grow thinner upwards; no: DBH at every height",
                  .source = "choice",
                  .presets = published("no")});
    options.flag("tree_impact.height_effect", law.height_effect,
                 {.meaning = "a hit above 1.3 m meets the strength of the thinner stem there",
                  .source = "choice, after Lundstrom et al. 2009",
                  .presets = published("no")});
    options.flag("tree_impact.remove_broken", law.remove_broken,
                 {.meaning = "broken trees and logs are no longer in the way of the rocks that follow",
                  .source = "Vaujany experiments (Rammer et al. 2010)"});
    options.number("tree_impact.stop_share", law.stop_share,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.5,
                    .meaning = "a rock left with less of its energy stays at the tree or log",
                    .source = "choice"});
}

void declare_logs(config::Options& options, LogImpactLaw& law) {
    options.number("log_impact.loose_share", law.loose_share,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "energy that a log takes which nothing holds, by that of an anchored one",
                    .source = "choice"});
    options.number("log_impact.climb_share", law.climb_share,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "share of a log's energy that a rock spends at most to climb it",
                    .source = "choice"});
    options.number("log_impact.friction", law.friction,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 5.0,
                    .meaning = "friction along a log that blocks a flying rock; steeper than 1/this it stays",
                    .source = "choice"});
}

/// Row of a hit type in the deviation table.
std::size_t hit_type_of(const config::Table& table, std::size_t row, config::Problems& problems) {
    const std::vector<std::string> names{"frontal", "lateral", "scratch"};
    for (std::size_t type = 0; type < names.size(); ++type) {
        if (table.text(row, "hit_type") == names[type]) {
            return type;
        }
    }
    problems.add(config::ExitCode::data, table.place(row, "hit_type"),
                 config::in_quotes(table.text(row, "hit_type")), "frontal, lateral or scratch");
    return 0;
}

}  // namespace

DeviationMatrix read_deviation_matrix(std::string_view text, const std::string& file) {
    std::istringstream in{std::string{text}};
    const config::Table table = config::Table::read(in, file);
    config::Problems problems;
    table.require({"hit_type", "from_deg", "to_deg", "share"}, problems);
    problems.throw_if_any();

    DeviationMatrix matrix;
    std::array<std::size_t, hit_types> classes_read{};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::size_t type = hit_type_of(table, row, problems);
        const auto from_deg = table.number(row, "from_deg", {.low = 0.0, .high = 90.0}, problems);
        const auto to_deg = table.number(row, "to_deg", {.low = 0.0, .high = 90.0}, problems);
        const auto share = table.number(row, "share", {.low = 0.0, .high = 1.0}, problems);
        const std::size_t rank = classes_read[type]++;
        if (!from_deg || !to_deg || !share || rank >= matrix.shares[type].size()) {
            continue;
        }
        matrix.shares[type][rank] = *share;
        matrix.limits[rank] = config::Angle::from_degrees(*from_deg);
        matrix.limits[rank + 1] = config::Angle::from_degrees(*to_deg);
    }
    for (std::size_t type = 0; type < hit_types; ++type) {
        const auto& shares = matrix.shares[type];
        if (classes_read[type] != shares.size() || std::abs(shares[0] + shares[1] + shares[2] - 1.0) > 1e-9) {
            problems.add(config::ExitCode::data, {file}, "classes of one hit type that do not sum to 1",
                         "three classes for each hit type");
        }
    }
    problems.throw_if_any();
    return matrix;
}

DeviationMatrix shipped_deviation_matrix() {
    return read_deviation_matrix(config::shipped_table("tree_deviation.csv"), "tree_deviation.csv");
}

Parameters::Parameters() {
    fall.tree.deviation = shipped_deviation_matrix();
}

void declare(config::Options& options, Parameters& parameters) {
    PicusLaw& law = parameters.fall.motion.picus;
    declare_motion(options, parameters.fall.motion);
    declare_classical(options, parameters.fall.motion.classical, parameters.written);
    declare_ground(options, parameters.ground);
    declare_restitution(options, law);
    declare_rebound(options, law, parameters.written);
    declare_deviation(options, law, parameters.written);
    declare_rolling(options, law.rolling, parameters.written);
    declare_stopping(options, law.stopping, parameters.written);
    declare_trees(options, parameters.fall.tree);
    declare_logs(options, parameters.fall.log);
}

void take_over(Parameters& parameters, const config::Options& options) {
    const WrittenLaw& written = parameters.written;
    PicusLaw& law = parameters.fall.motion.picus;
    law.jump_angle.coefficient = config::Angle::from_degrees(written.jump_angle_coefficient_deg);
    law.jump_angle.cap = config::Angle::from_degrees(written.jump_angle_cap_deg);
    law.lateral.at_rest = config::Angle::from_degrees(written.lateral_slow_deg);
    law.lateral.when_fast = config::Angle::from_degrees(written.lateral_fast_deg);
    const config::SinCos edge =
        config::sin_cos_of(config::Angle::from_degrees(written.rolling_edge_deg).in_radians());
    law.rolling.edge_angle_tangent = edge.sin / edge.cos;
    law.stopping.most_impacts = static_cast<std::uint32_t>(written.most_impacts);
    parameters.fall.motion.pir3d.most_impacts = law.stopping.most_impacts;
    classical::Law& classical = parameters.fall.motion.classical;
    classical.lateral = config::Angle::from_degrees(written.classical_lateral_deg);
    const config::SinCos friction =
        config::sin_cos_of(config::Angle::from_degrees(written.classical_friction_deg).in_radians());
    classical.friction_angle_tangent = friction.sin / friction.cos;
    classical.edge_angle_tangent = law.rolling.edge_angle_tangent;
    classical.most_impacts = law.stopping.most_impacts;
    parameters.fall.log.stop_share = parameters.fall.tree.stop_share;

    config::Problems problems;
    if (law.rolling.launch_factor <= law.rolling.start_factor) {
        problems.add(config::ExitCode::settings, options.place_of("rockfall.rolling_launch_factor"),
                     "rockfall.rolling_launch_factor not above rockfall.rolling_start_factor",
                     "a rock that just began to roll not to jump at once");
    }
    const TreeImpactLaw& tree = parameters.fall.tree;
    if (tree.scratch_limit < tree.frontal_limit) {
        problems.add(config::ExitCode::settings, options.place_of("tree_impact.scratch_limit"),
                     "tree_impact.scratch_limit below tree_impact.frontal_limit",
                     "lateral hits between frontal hits and scratches");
    }
    problems.throw_if_any();
}

}  // namespace rockfall
