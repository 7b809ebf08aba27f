#include "config/options/options.hpp"
#include "config/options/values.hpp"
#include "config/text/numbers.hpp"
#include "rockfall/motion/rigid/model.hpp"

namespace rockfall::rigid {
namespace {

using Presets = std::vector<config::Preset>;

/// The set of settings that imitates the engine PhysX as Unity uses it.
Presets unity(const std::string& value) {
    return {{"unity_compat", value}};
}

struct Replacement {
    const char* key;
    std::string Written::*text;
    double Law::*figure;
    double high;
    const char* unit;
    const char* meaning;
    const char* source;
    const char* in_unity;
};

constexpr double most_friction = 10.0;

const std::vector<Replacement>& replacements() {
    static const std::vector<Replacement> all{
        {"rigid.friction", &Written::friction, &Law::friction, most_friction, "-",
         "friction of all grounds: mu, or mu_min of the slip law; empty: each ground's own",
         "Leine et al. 2014; of unity_compat tan(35 deg) / 2", "0.350103769104863"},
        {"rigid.friction_max", &Written::friction_max, &Law::friction_max, most_friction, "-",
         "mu_max of the slip law of all grounds; empty: each ground's own", "Leine et al. 2014", nullptr},
        {"rigid.slip_kappa_pm", &Written::slip_kappa_pm, &Law::slip_kappa_pm, 1000.0, "1/m",
         "growth of friction with the slip; empty: each ground's own", "Leine et al. 2014, Eq. 46", nullptr},
        {"rigid.slip_beta_ps", &Written::slip_beta_ps, &Law::slip_beta_ps, 1e5, "1/s",
         "decay of the slip without contact; empty: each ground's own", "Leine et al. 2014, Eq. 47", nullptr},
        {"rigid.contact_drag_ps", &Written::drag_ps, &Law::drag_ps, 100.0, "1/s",
         "drag in contact, proportional to the velocity; empty: each ground's own",
         "users of RAMMS::ROCKFALL, second hand", "0"},
        {"rigid.restitution", &Written::restitution, &Law::restitution, 1.0, "-",
         "restitution e of all grounds; empty: each ground's own", "choice", "0"},
        {"rigid.rolling_resistance", &Written::rolling_resistance, &Law::rolling_resistance, most_friction,
         "-", "mu_r of all grounds, a couple mu_r N r against the spin; empty: each ground's own", "choice",
         "0"},
        {"rigid.scar_soil_strength_kpa", &Written::soil_strength_kpa, &Law::soil_strength_kpa, 1e6, "kPa",
         "strength M_e of the soil of all grounds, 0: no scars; empty: each ground's own",
         "Lu et al. 2019 have kN/m2", nullptr},
        {"rigid.roughness_m", &Written::roughness_m, &Law::roughness_m, 10.0, "m",
         "standard deviation of heights of all grounds between the points of the terrain; empty: each "
         "ground's "
         "own",
         "choice, see rockfall/motion/rigid/README.md", "0"},
    };
    return all;
}

void declare_grounds(config::Options& options, Law& law, Written& written) {
    options.text("rigid.friction_law", written.friction_law,
                 {.meaning = "by_ground, constant, or slip: friction grows with the slip",
                  .source = "Leine et al. 2014, Eqs. 46-47",
                  .presets = unity("constant")});
    for (const Replacement& of : replacements()) {
        options.text(of.key, written.*of.text,
                     {.unit = of.unit,
                      .meaning = of.meaning,
                      .source = of.source,
                      .presets = of.in_unity != nullptr ? unity(of.in_unity) : Presets{}});
    }
    options.number("rigid.restitution_halved_mps", law.restitution_halved_mps,
                   {.unit = "m/s",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "speed into the ground that halves the restitution; 0: none does",
                    .source = "Pfeiffer & Bowen 1989"});
    options.number("rigid.plastic_mps", law.plastic_mps,
                   {.unit = "m/s",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "slower impacts have no restitution",
                    .source = "choice, 0.02-0.05"});
    options.flag("rigid.stops_by_chance", law.stops_by_chance,
                 {.meaning = "stop probabilities of the ground types, as picus has them",
                  .source = "Rammer et al. 2010, 3.2.2"});
}

void declare_scars(config::Options& options, ScarLaw& scar) {
    options.flag("rigid.scarring", scar.on,
                 {.meaning = "drag in the scar that a block ploughs at an impact",
                  .source = "Lu et al. 2019, Eq. 11 as printed, which gives less than the depths they list",
                  .presets = unity("no")});
    options.number("rigid.scar_drag_factor", scar.drag_factor,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "C_f + C_s",
                    .source = "fit to the largest speeds of Vaujany, with the strengths of the grounds",
                    .needs = {{"rigid.scarring"}}});
    options.number("rigid.scar_soil_density_kgpm3", scar.soil_density_kgpm3,
                   {.unit = "kg/m3",
                    .low = 500.0,
                    .high = 3000.0,
                    .meaning = "density of the soil",
                    .source = "choice",
                    .needs = {{"rigid.scarring"}}});
}

void declare_contact(config::Options& options, Law& law) {
    options.number("rigid.step_s", law.step_s,
                   {.unit = "s",
                    .low = 1e-5,
                    .high = 0.01,
                    .meaning = "step of lasting contact",
                    .source = "choice, see rockfall/motion/rigid/README.md"});
    options.choice("rigid.impact_law", law.solver.impact,
                   {{"newton", ImpactLaw::newton}, {"poisson", ImpactLaw::poisson}},
                   {.meaning = "restitution of velocities or of percussions, where several points touch",
                    .source = "Leine et al. 2014; Glocker 2001"});
    options.flag("rigid.double_friction", law.double_friction,
                 {.meaning = "friction counts twice where two or more points touch, as in PhysX",
                  .source = "two anchors of a patch in PhysX",
                  .presets = unity("yes")});
    options.number("rigid.spin_cap_radps", law.spin_cap_radps,
                   {.unit = "rad/s",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "no block spins faster; 0: no limit",
                    .source = "Unity: 7 by component default, 50 by project default",
                    .presets = unity("7")});
    options.number("rigid.rest_mps", law.rest_mps,
                   {.unit = "m/s",
                    .low = 1e-4,
                    .high = 1.0,
                    .meaning = "a block on the ground that stays slower and gains no speed rests",
                    .source = "choice"});
    options.number("rigid.longest_s", law.longest_s,
                   {.unit = "s",
                    .low = 1.0,
                    .high = 1e5,
                    .meaning = "a block that moves longer is given up",
                    .source = "choice"});
}

void declare_start_of_blocks(config::Options& options, Law& law) {
    options.choice("rigid.start", law.start,
                   {{"by_height", StartKind::by_height},
                    {"falling", StartKind::falling},
                    {"sliding", StartKind::sliding},
                    {"toppling", StartKind::toppling}},
                   {.meaning = "how blocks begin; by_height: falling where the start height is above 0, "
                               "else sliding",
                    .source = "study of the G318 highway"});
    options.number("rigid.start_spin_radps", law.start_spin_radps,
                   {.unit = "rad/s",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "spin with which falling blocks begin, as if they rolled along their heading",
                    .source = "choice, of thrown blocks",
                    .needs = {{"rigid.start", {"by_height", "falling"}}}});
    options.number("rigid.topple_spin_radps", law.topple_spin_radps,
                   {.unit = "rad/s",
                    .low = 0.0,
                    .high = 50.0,
                    .meaning = "spin about the lower edge with which toppling blocks turn on",
                    .source = "choice"});
    options.flag("rigid.keeps_attitude", law.keeps_attitude,
                 {.meaning = "sliding blocks keep release.attitude; no: they lie on their largest face",
                  .source = "choice"});
}

}  // namespace

void Model::declare(config::Options& options, Law& law, Written& written) {
    declare_grounds(options, law, written);
    declare_scars(options, law.scar);
    declare_contact(options, law);
    declare_start_of_blocks(options, law);
}

void Model::take_over(const Written& written, const SharedSettings& shared, Law& law,
                      const config::Options& options, config::Problems& problems) {
    law.most_impacts = static_cast<std::uint32_t>(shared.most_impacts);
    law.friction_law.reset();
    if (written.friction_law == "constant") {
        law.friction_law = FrictionLaw::constant;
    } else if (written.friction_law == "slip") {
        law.friction_law = FrictionLaw::slip;
    } else if (written.friction_law != "by_ground") {
        problems.add(config::ExitCode::settings, options.place_of("rigid.friction_law"),
                     "rigid.friction_law " + config::in_quotes(written.friction_law),
                     "by_ground, constant or slip");
    }
    for (const Replacement& of : replacements()) {
        law.*of.figure = -1.0;
        const std::string& text = written.*of.text;
        if (text.empty()) {
            continue;
        }
        const auto value = config::parse_number(text);
        if (!value || *value < 0.0 || *value > of.high) {
            problems.add(
                config::ExitCode::settings, options.place_of(of.key),
                std::string{of.key} + " " + config::in_quotes(text),
                "a number in [0, " + config::to_text(of.high) + "], or nothing for each ground's own");
            continue;
        }
        law.*of.figure = *value;
    }
    if (law.friction_max >= 0.0 && law.friction_max < law.friction) {
        problems.add(config::ExitCode::settings, options.place_of("rigid.friction_max"),
                     "rigid.friction_max below rigid.friction", "friction that grows with the slip");
    }
}

void Model::stay_in_plane(Law& law, Written&) {
    law.in_plane = true;
}

}  // namespace rockfall::rigid
