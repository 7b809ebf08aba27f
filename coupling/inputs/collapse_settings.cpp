#include "coupling/inputs/collapse_settings.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/motion/block_fall.hpp"

namespace coupling::collapse {

namespace {

using config::joined;
using rockfall::rock_mass::ContactLaw;
using rockfall::rock_mass::JointSet;

constexpr const char* choice = "choice";

void declare_body(config::Options& options, CollapseSettings& s) {
    options.file(
        "collapse.source", s.source,
        {.meaning =
             "table or layer with wkt (POLYGON): the rock below them, to collapse.depth_m, breaks up"});
    options.file("collapse.mesh", s.mesh,
                 {.meaning = "instead: closed surface of the rock that breaks up, PLY or STL"});
    options.number("collapse.depth_m", s.depth_m,
                   {.unit = "m",
                    .low = 0.1,
                    .high = 1000.0,
                    .meaning = "vertical depth of the rock mass",
                    .source = choice});
    options.choice("collapse.blocks", s.blocks,
                   {{"joints", BlockKind::joints}, {"voronoi", BlockKind::voronoi}},
                   {.meaning = "blocks between joints, or Voronoi cells", .source = choice});
    options.file(
        "collapse.joint_sets", s.joint_sets,
        {.meaning = "table of joint sets: name, dip_deg, dip_direction_deg, spacing_m; perhaps spacing_law, "
                    "spacing_deviation_m, persistence, tensile_mpa, shear_mpa"});
    options.number(
        "collapse.block_size_m", s.block_size_m,
        {.unit = "m", .low = 0.2, .high = 100.0, .meaning = "mean size of Voronoi cells", .source = choice});
    options.number("collapse.least_block_m", s.least_block_m,
                   {.unit = "m",
                    .low = 0.05,
                    .high = 20.0,
                    .meaning = "smaller pieces are merged with a neighbour",
                    .source = choice});
    options.number(
        "collapse.density_kgpm3", s.density_kgpm3,
        {.unit = "kg/m3", .low = 500.0, .high = 6000.0, .meaning = "density of the rock", .source = choice});
}

void declare_strength(config::Options& options, CollapseSettings& s) {
    options.number("collapse.tensile_mpa", s.tensile_mpa,
                   {.unit = "MPa",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "tensile strength of intact rock",
                    .source = choice});
    options.number("collapse.shear_mpa", s.shear_mpa,
                   {.unit = "MPa",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "shear strength of intact rock",
                    .source = choice});
    options.number("collapse.strength_factor", s.strength_factor,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "all strengths times this: rock masses are weaker than samples",
                    .source = choice});
    options.number("collapse.strength_angle_deg", s.strength_angle_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 80.0,
                    .meaning = "shear strength grows with pressure by the tangent of this angle",
                    .source = "PFC's bond"});
    options.number("collapse.persistence", s.persistence,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "share of the faces between Voronoi cells that are open",
                    .source = choice});
    options.number("collapse.base_persistence", s.base_persistence,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "share of the border to the rock that stays that is open",
                    .source = choice});
}

void declare_laws(config::Options& options, CollapseSettings& s) {
    auto& laws = s.laws;
    options.choice("collapse.contact_law", laws.contact,
                   {{"foundation", ContactLaw::foundation}, {"pfc", ContactLaw::pfc}},
                   {.meaning = "elastic foundation, or one spring a pair", .source = choice});
    options.flag("collapse.disc_areas", s.disc_areas,
                 {.meaning = "with pfc: areas of discs of the smaller block instead of the polygons",
                  .source = choice});
    options.number("collapse.modulus_mpa", s.modulus_mpa,
                   {.unit = "MPa",
                    .low = 0.1,
                    .high = 1e6,
                    .meaning = "effective modulus of contacts and bonds",
                    .source = choice});
    options.number(
        "collapse.stiffness_ratio", laws.stiffness_ratio,
        {.unit = "-", .low = 1.0, .high = 100.0, .meaning = "normal by shear stiffness", .source = choice});
    options.number(
        "collapse.friction", laws.friction,
        {.unit = "-", .low = 0.0, .high = 5.0, .meaning = "friction between blocks", .source = choice});
    options.number("collapse.ground_friction", laws.ground_friction,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 5.0,
                    .meaning = "friction between blocks and ground",
                    .source = choice});
    options.number("collapse.damping_ratio", laws.damping_ratio,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "dashpot of contacts by the critical one",
                    .source = choice});
    options.number("collapse.bond_damping_ratio", laws.bond_damping_ratio,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "dashpot of intact bonds by the critical one",
                    .source = choice});
    options.number(
        "collapse.local_damping", laws.local_damping,
        {.unit = "-", .low = 0.0, .high = 0.9, .meaning = "PFC's local damping", .source = choice});
    options.number("collapse.step_factor", laws.step_factor,
                   {.unit = "-",
                    .low = 0.005,
                    .high = 0.5,
                    .meaning = "time step by the smallest 2 sqrt(m / k)",
                    .source = choice});
    options.number(
        "collapse.mass_scaling", laws.heavier_share,
        {.unit = "-",
         .low = 0.0,
         .high = 0.1,
         .meaning = "share of the blocks, the thinnest, that get as much mass as a longer step needs",
         .source = choice});
    options.flag("collapse.sleeping", laws.sleeping,
                 {.meaning = "blocks at rest are left out until something moves them", .source = choice});
    options.number(
        "collapse.settle_s", s.settle_s,
        {.unit = "s",
         .low = 0.0,
         .high = 100.0,
         .meaning = "the mass comes to rest under its own weight, for so long at most, before it is "
                    "let go: nothing slides or breaks, local damping 0.7",
         .source = choice});
    options.number(
        "collapse.duration_s", s.duration_s,
        {.unit = "s", .low = 0.01, .high = 3600.0, .meaning = "time that is simulated", .source = choice});
    options.number("collapse.frame_s", s.frame_s,
                   {.unit = "s",
                    .low = 0.01,
                    .high = 60.0,
                    .meaning = "time between two states that are kept and reported",
                    .source = choice});
}

void declare_pictures(config::Options& options, CollapseSettings& s) {
    options.numbers("collapse.picture_times_s", s.picture_times_s,
                    {.unit = "s",
                     .low = 0.0,
                     .high = 3600.0,
                     .meaning = "times of the views from the side and of the maps of speed and displacement, "
                                "at most 12; without: five over the whole time"});
    options.choice("collapse.block_series", s.series_of_all, {{"chosen", false}, {"all", true}},
                   {.meaning = "blocks in tables/block_series.csv: the fastest, the farthest and the median "
                               "one, or all",
                    .source = choice});
}

void declare_hand_over(config::Options& options, CollapseSettings& s) {
    options.choice(
        "collapse.hand_over", s.hand_over,
        {{"none", HandOverTo::none},
         {std::string{rockfall::BlockModel::description().name}, HandOverTo::single_blocks}},
        {.meaning = "motion model under which a moving block without bond and without contact with "
                    "another one goes on alone, with the settings of that model and the ground "
                    "types of [terrain], until another block could touch it; none: it stays in the mass",
         .source = choice});
    options.number("collapse.hand_over_after_s", s.hand_over_after_s,
                   {.unit = "s",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "how long such a block has been alone before it does",
                    .source = choice});
}

void check_collapse(const CollapseScenario& s) {
    config::Problems problems;
    const auto refuse = [&](const std::string& key, std::string found, std::string expected) {
        problems.add(config::ExitCode::settings, s.scenario.options->place_of(key), std::move(found),
                     std::move(expected));
    };
    if (s.settings.source.empty() == s.settings.mesh.empty()) {
        refuse("collapse.source",
               s.settings.source.empty() ? "neither collapse.source nor collapse.mesh"
                                         : "collapse.source beside collapse.mesh",
               "one of them: a polygon with collapse.depth_m, or a closed surface");
    }
    if (s.settings.blocks == BlockKind::joints && s.settings.joint_sets.empty()) {
        refuse("collapse.joint_sets", "collapse.blocks = joints without collapse.joint_sets",
               "a table of joint sets, or collapse.blocks = voronoi");
    }
    if (s.scenario.terrain.dem.empty() && s.scenario.terrain.points.empty() &&
        s.scenario.terrain.mesh.empty()) {
        refuse("terrain.dem", "no terrain", "terrain.dem, terrain.points or terrain.mesh");
    }
    if (s.scenario.terrain.plane.is_given()) {
        refuse("terrain.plane_width_m", "a rock mass on terrain.plane_width_m",
               "terrain.dem, terrain.points or terrain.mesh");
    }
    constexpr std::size_t most_pictures = 12;
    const std::vector<double>& times_s = s.settings.picture_times_s;
    if (times_s.size() > most_pictures) {
        refuse("collapse.picture_times_s", joined(std::to_string(times_s.size()), " times"), "at most 12");
    }
    for (const double time_s : times_s) {
        if (time_s > s.settings.duration_s) {
            refuse("collapse.picture_times_s", joined("a picture at ", config::to_text(time_s), " s"),
                   joined("times up to collapse.duration_s, ", config::to_text(s.settings.duration_s), " s"));
            break;
        }
    }
    if (s.scenario.run.years != 0 || !s.scenario.terrain.profile.empty()) {
        refuse("run.years", "a rock mass beside years or a profile",
               "neither: it breaks up on today's terrain");
    }
    problems.throw_if_any();
}

JointSet joint_set_of(const JointSetRow& row, const CollapseSettings& settings) {
    JointSet set = row;
    set.strength = {1e6 * settings.strength_factor * row.tensile_mpa.value_or(settings.tensile_mpa),
                    1e6 * settings.strength_factor * row.shear_mpa.value_or(settings.shear_mpa)};
    return set;
}

}  // namespace

rockfall::rock_mass::Laws CollapseScenario::laws() const {
    rockfall::rock_mass::Laws laws = settings.laws;
    laws.modulus_pa = 1e6 * settings.modulus_mpa;
    laws.disc_areas = settings.disc_areas;
    laws.strength_angle_tan = std::tan(settings.strength_angle_deg * std::numbers::pi / 180.0);
    return laws;
}

void declare(config::Options& options, CollapseSettings& settings) {
    declare_body(options, settings);
    declare_strength(options, settings);
    declare_laws(options, settings);
    declare_pictures(options, settings);
    declare_hand_over(options, settings);
}

bool is_collapse(const std::filesystem::path& file) {
    try {
        const FileBytes bytes = open_file(file, {file.string()}, "a scenario file");
        std::istringstream in{std::string{bytes.text()}};
        for (std::string line; std::getline(in, line);) {
            if (line.starts_with("[collapse]")) {
                return true;
            }
        }
    } catch (const config::InputError&) {
        // Whoever reads it next says what is wrong.
    }
    return false;
}

std::unique_ptr<CollapseScenario> read_collapse(const std::filesystem::path& file,
                                                const std::vector<std::string>& overrides,
                                                const std::filesystem::path& inputs_within) {
    auto all = std::make_unique<CollapseScenario>();
    Scenario& scenario = all->scenario;
    scenario.file = file;
    scenario.inputs_within = inputs_within;
    scenario.options = std::make_shared<config::Options>();
    declare(*scenario.options, scenario);
    declare(*scenario.options, all->settings);
    const FileBytes bytes = open_file(file, {file.string()}, "a scenario file");
    std::istringstream in{std::string{bytes.text()}};
    scenario.options->read(in, file.string(), overrides, "rockfall.preset");
    name_inputs(scenario);
    check_collapse(*all);
    rockfall::take_over(scenario.rockfall, *scenario.options);
    return all;
}

const config::Schema<JointSetRow>& joint_set_columns() {
    using R = JointSetRow;
    constexpr config::NumberRange strengths{0.0, 1000.0};
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "joint_sets", .setting = "collapse.joint_sets", .row = "joint set", .no_rows = "at least one row"},
        {{"name", &R::name, "in results", {.may_be_empty = true}},
         {"dip_deg", &R::dip_deg, "steepest angle below the horizon", {.range = {0.0, 90.0}}},
         {"dip_direction_deg", &R::dip_direction_deg, "of the dip, clockwise from north", {.range = {0.0, 360.0}}},
         {"spacing_m", &R::spacing_m, "mean, along the normal", {.range = {0.1, 1000.0}}},
         {"spacing_law", &R::law, "how spacings vary; empty: constant", {.optional = true, .words = {"constant", "uniform", "exponential", "lognormal"}}},
         {"spacing_deviation_m", &R::spacing_deviation_m, "of the spacings; empty: 0", {.range = {0.0, 1000.0}, .optional = true}},
         {"persistence", &R::persistence, "share of the joints' area that is open; empty: 1", {.unit = "-", .range = {0.0, 1.0}, .optional = true}},
         {"tensile_mpa", &R::tensile_mpa, "of the rock bridges; empty: collapse.tensile_mpa", {.unit = "MPa", .range = strengths}},
         {"shear_mpa", &R::shear_mpa, "of the rock bridges; empty: collapse.shear_mpa", {.unit = "MPa", .range = strengths}}}};
    // clang-format on
    return columns;
}

std::vector<JointSet> joint_sets_of(const config::Table& table, const CollapseSettings& settings) {
    config::RowProblems wrong{table};
    std::vector<JointSet> sets;
    for (const config::Read<JointSetRow>& row : joint_set_columns().rows(table, wrong)) {
        sets.push_back(joint_set_of(row, settings));
    }
    wrong.throw_first();
    return sets;
}

}  // namespace coupling::collapse
