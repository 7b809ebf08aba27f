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
#include "config/text/joined.hpp"
#include "rockfall/motion/seam/presets.hpp"

namespace rockfall {

namespace {

/// The laws of all models, or who published them, in the order of the list: "a; b; or c".
std::string of_all_models(std::string_view ModelDescription::*text, std::string_view before_last) {
    std::string all;
    for (const MotionModel model : all_models()) {
        const bool last = to_place(model) + 1 == all_models().size();
        all.append(all.empty() ? "" : last ? before_last : "; ").append(description_of(model).*text);
    }
    return all;
}

void declare_motion(config::Options& options, MotionLaws& motion, SharedSettings& shared) {
    std::vector<std::pair<std::string, MotionModel>> names;
    for (const MotionModel model : all_models()) {
        names.emplace_back(description_of(model).name, model);
    }
    options.choice("rockfall.motion", motion.model, names,
                   {.meaning = "motion model: " + of_all_models(&ModelDescription::law, "; or "),
                    .source = of_all_models(&ModelDescription::source, "; ")});
    options.number("rockfall.rolling_edge_deg", shared.rolling_edge_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 45.0,
                    .meaning = "bend of the ground above which a rolling rock takes off or hits",
                    .source = "choice, 2-8 deg in PiR3D (Cottaz et al. 2010)"});
    options.number("rockfall.loss_by_elongation", shared.losses.by_elongation,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 3.0,
                    .meaning = "power with which losses at the ground grow with the elongation of a rock",
                    .source = "fitted, see validation/README.md",
                    .presets = published("0")});
    options.number(
        "rockfall.loss_scatter", shared.losses.scatter,
        {.unit = "-",
         .low = 0.0,
         .high = 1.0,
         .meaning = "standard deviation of ln(losses at the ground) between rocks of one elongation",
         .source = "fitted, see validation/README.md",
         .presets = published("0")});
    options.count("rockfall.most_impacts", shared.most_impacts,
                  {.low = 100,
                   .high = 1e6,
                   .meaning = "a rock with more ground impacts is given up and counted as such",
                   .source = "choice"});
}

void declare_ground(config::Options& options, GroundLaw& ground) {
    options.number("rockfall.vertical_tolerance_m", ground.vertical_tolerance_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "largest height error when a DEM is thinned; 0 keeps every point",
                    .source = "choice"});
    options.number(
        "rockfall.contact_radius_m", ground.contact_radius_m,
        {.unit = "m",
         .low = -1.0,
         .high = 50.0,
         .meaning = "radius over which a rock feels the ground as a plane, the same everywhere; 0: "
                    "the heights as they are; -1: by the size of the rocks and the noise of the heights",
         .source = "Rammer et al. 2010, discussion; radius by noise: own derivation",
         .presets = published("0"),
         .formerly = "rockfall.contact_support_m"});
    const std::vector<config::Need> by_noise{{"rockfall.contact_radius_m", {"-1"}}};
    options.number("rockfall.contact_diameters", ground.contact_diameters,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 50.0,
                    .meaning = "that radius is at least so many mean diameters of the rocks",
                    .source = "choice",
                    .formerly = "rockfall.contact_support_diameters",
                    .needs = by_noise});
    options.number("rockfall.contact_slope_error_deg", ground.contact_slope_error_deg,
                   {.unit = "deg",
                    .low = 0.1,
                    .high = 45.0,
                    .meaning = "that radius is so wide that the noise of the heights, measured at the start, "
                               "leaves no more than this in the slope that rocks feel (standard deviation)",
                    .source = "choice",
                    .needs = by_noise});
    options.number(
        "rockfall.contact_shift_m", ground.contact_shift_m,
        {.unit = "m",
         .low = 0.0,
         .high = 50.0,
         .meaning = "no point of the ground is moved further than this by the contact zone, or than "
                    "four times the noise of the heights",
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

ContactLaw GroundLaw::contact_law(double mean_diameter_m) const {
    ContactLaw law;
    if (as_it_is) {
        law.given_radius_m = 0.0;
    } else if (contact_radius_m >= 0.0) {
        law.given_radius_m = contact_radius_m;
    }
    law.least_radius_m = contact_diameters * mean_diameter_m;
    const config::SinCos error =
        config::sin_cos_of(config::Angle::from_degrees(contact_slope_error_deg).in_radians());
    law.slope_error = error.sin / error.cos;
    law.largest_shift_m = contact_shift_m;
    return law;
}

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
    declare_motion(options, parameters.fall.motion, parameters.written.shared);
    declare_ground(options, parameters.ground);
    for_each_model([&]<class Model>(std::type_identity<Model>) {
        Model::declare(options, parameters.fall.motion.of<Model>(), parameters.written.of<Model>());
    });
    declare_trees(options, parameters.fall.tree);
    declare_logs(options, parameters.fall.log);
}

void take_over(Parameters& parameters, const config::Options& options) {
    config::Problems problems;
    for_each_model([&]<class Model>(std::type_identity<Model>) {
        Model::take_over(parameters.written.of<Model>(), parameters.written.shared,
                         parameters.fall.motion.of<Model>(), options, problems);
    });
    parameters.ground.as_it_is = description_of(parameters.fall.motion.model).has_shape;
    parameters.fall.log.stop_share = parameters.fall.tree.stop_share;
    const TreeImpactLaw& tree = parameters.fall.tree;
    if (tree.scratch_limit < tree.frontal_limit) {
        problems.add(config::ExitCode::settings, options.place_of("tree_impact.scratch_limit"),
                     "tree_impact.scratch_limit below tree_impact.frontal_limit",
                     "lateral hits between frontal hits and scratches");
    }
    problems.throw_if_any();
}

void stay_in_plane(Parameters& parameters) {
    for_each_model([&]<class Model>(std::type_identity<Model>) {
        Model::stay_in_plane(parameters.fall.motion.of<Model>(), parameters.written.of<Model>());
    });
}

SidewaysTurn sideways_turn(const Parameters& parameters) {
    return with_model(parameters.fall.motion, [&]<class Model>(std::type_identity<Model>, const auto&) {
        return Model::sideways_turn(parameters.written.of<Model>());
    });
}

}  // namespace rockfall
