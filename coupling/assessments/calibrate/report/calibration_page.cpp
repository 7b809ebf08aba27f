#include "coupling/assessments/calibrate/report/calibration_page.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/figures/drawn_words.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::calibrate {

using config::joined;

/// Whole percents: more digits mean nothing here.
std::string share_or_dash(double share) {
    return std::isfinite(share) ? joined(report::fixed(100.0 * share, 0), "\u00a0%") : "–";
}

std::string range_or_dash(double from, double to) {
    return std::isfinite(from) && std::isfinite(to)
               ? report::page_text("{low} to {high}",
                                   {{"low", report::three_digits(from)}, {"high", report::three_digits(to)}})
               : "–";
}

namespace {

using report::escaped;
using report::fixed;
using report::grouped;
using report::page_text;
using report::PageFields;
using report::three_digits;

PageFields row_of(const Calibration& calibration, std::size_t number, bool is_held_out) {
    const Judged& judged = calibration.judgement.observations[number];
    const Side& side = is_held_out ? judged.held_out : judged.fit;
    return {{"what", name_on_page(calibration.observations[number], calibration)},
            {"use", page_text(is_held_out ? "held out" : "fitted")},
            {"number", grouped(side.observed)},
            {"observed", three_digits(side.figure)},
            {"predicted", range_or_dash(side.predicted.front(), side.predicted.back())},
            {"before", range_or_dash(side.before.front(), side.before.back())},
            {"as_far", share_or_dash(side.as_far)}};
}

std::vector<PageFields> sides_of(const Calibration& calibration) {
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
        if (!calibration.observations[i].fit.empty()) {
            rows.push_back(row_of(calibration, i, false));
        }
        if (!calibration.observations[i].held_out.empty()) {
            rows.push_back(row_of(calibration, i, true));
        }
    }
    return rows;
}

/// A component that not all sites share has their names behind it.
std::string name_of_component(const Calibration& calibration, std::size_t place) {
    ParameterDraws::Component component = calibration.space.components()[place];
    component.parameter = component.parameter.substr(0, component.parameter.find(':'));
    const std::string name = escaped(name_of(component));
    const std::string users = calibration.users_of(place);
    return users.empty() ? name : page_text("{what} ({site})", {{"what", name}, {"site", escaped(users)}});
}

std::string name_of_parameter(const Calibration& calibration, const std::string& parameter) {
    const std::size_t place = calibration.space.find(parameter);
    return place < calibration.space.size() ? name_of_component(calibration, place) : "–";
}

/// How much narrower the range is, as a share of what it was.
std::string learned_in_words(const Learned& learned) {
    return !std::isfinite(learned.learned) || learned.is_beyond_chance() ? share_or_dash(learned.learned)
           : learned.has_too_few_sets()                                  ? page_text("too few sets")
           : learned.learned < -learned.wider_by_chance
               ? page_text("nothing; the range is wider than before")
               : page_text("not distinguishable from chance (up to {level})",
                           {{"level", share_or_dash(learned.by_chance)}});
}

std::vector<PageFields> parameters_of(const Calibration& calibration) {
    constexpr double deviations_of_90 = 1.645;
    // Three standard errors of a correlation that is none: of nine partners one is seldom beyond by chance.
    const double worth_naming = std::max(0.3, 3.0 / std::sqrt(calibration.judgement.degrees()));
    std::vector<PageFields> rows;
    for (const Learned& learned : calibration.judgement.parameters) {
        const double wide = std::exp(deviations_of_90 * learned.component.width);
        rows.push_back({{"row", std::to_string(rows.size() + 1)},
                        {"name", name_of_component(calibration, rows.size())},
                        {"before", range_or_dash(1.0 / wide, wide)},
                        {"after", range_or_dash(learned.low, learned.high)},
                        {"median", fixed(learned.median, 2)},
                        {"learned", learned_in_words(learned)},
                        {"partner", std::abs(learned.correlation) < worth_naming
                                        ? std::string{"–"}
                                        : joined(name_of_parameter(calibration, learned.partner), " (",
                                                 fixed(learned.correlation, 2), ")")}});
    }
    return rows;
}

/// A figure of a survey in the language of the page.
std::string figure_on_page(const std::string& figure, const Site& site) {
    const auto colon = figure.find(':');
    if (colon == std::string::npos) {
        return page_text(figure == "run_out_mean_m"        ? "mean run-out"
                         : figure == "run_out_deviation_m" ? "spread of run-outs"
                         : figure == "scar_height_mean_m"  ? "mean height of scars"
                                                           : "tree hits per rock");
    }
    const std::string id = figure.substr(colon + 1);
    const auto target = std::find_if(site.targets.begin(), site.targets.end(),
                                     [&](const rockfall::Target& one) { return one.id == id; });
    const std::string name = target == site.targets.end() ? id : target->name;
    const std::string quantity = figure.substr(0, colon);
    return page_text("{quantity} at {target}",
                     {{"quantity", page_text(quantity == "passing"     ? "Share of rocks that pass"
                                             : quantity == "speed_mps" ? "Speed"
                                                                       : "Height")},
                      {"target", escaped(name)}});
}

std::vector<PageFields> sensitivities_of(const Calibration& calibration) {
    std::vector<PageFields> rows;
    for (const Sensitivity& sensitivity : calibration.judgement.sensitivities) {
        std::size_t most = 0;
        for (std::size_t i = 1; i < sensitivity.shares.size(); ++i) {
            most = sensitivity.shares[i] > sensitivity.shares[most] ? i : most;
        }
        constexpr double seen = 0.05;
        const bool is_seen = sensitivity.shares[most] >= seen;
        const std::size_t site = sensitivity.figure.site;
        rows.push_back(
            {{"figure", at_site(figure_on_page(sensitivity.figure.name, calibration.sites[site]->site),
                                calibration, site)},
             {"parameter", is_seen ? name_of_component(calibration, most) : std::string{"–"}},
             {"share", is_seen ? share_or_dash(sensitivity.shares[most]) : std::string{"–"}}});
    }
    return rows;
}

/// What emulators saved, and how often they were wrong; none without them.
std::optional<PageFields> emulator_fields(const Calibration& calibration) {
    if (!calibration.plan.emulates) {
        return std::nullopt;
    }
    const Ruled& ruled = calibration.state.ruled;
    std::vector<PageFields> rows;
    for (const RuledOut& each : calibration.judgement.ruled_out) {
        rows.push_back({{"what", name_on_page(calibration.observations[each.observation], calibration)},
                        {"explained", share_or_dash(std::max(0.0, each.explained))},
                        {"ruled_out", share_or_dash(each.share)}});
    }
    const auto one_digit = [](double share) { return joined(fixed(100.0 * share, 1), "\u00a0%"); };
    return PageFields{{"ruled_out", one_digit(1.0 - calibration.state.left())},
                      {"ruled_out_none", ruled.not_run() == 0 && ruled.beyond == 0},
                      {"not_run", grouped(ruled.not_run())},
                      {"beyond", grouped(ruled.beyond)},
                      {"beyond_kept", grouped(ruled.beyond_kept)},
                      {"beyond_weight", one_digit(ruled.beyond_weight)},
                      {"of_observations", rows}};
}

/// Whether calibration_coverage.py counted intervals of such a search (README): one site, stops with heights
/// of scars, nothing else, no emulators.
bool is_coverage_counted(const Calibration& calibration) {
    const auto has = [&](Seen seen) {
        return std::any_of(calibration.observations.begin(), calibration.observations.end(),
                           [&](const Observation& one) { return one.seen == seen; });
    };
    return !calibration.has_several_sites() && !calibration.plan.emulates && has(Seen::stops) &&
           has(Seen::scar_heights) &&
           std::all_of(calibration.observations.begin(), calibration.observations.end(),
                       [](const Observation& one) {
                           return one.seen == Seen::stops || one.seen == Seen::run_out ||
                                  one.seen == Seen::scar_heights;
                       });
}

}  // namespace

std::string far_in_words(const Calibration& calibration, const std::vector<FarAlone>& rows) {
    std::string names;
    for (const FarAlone& row : rows) {
        const std::string name = name_on_page(row.observation, calibration);
        names += joined(names.empty() ? "" : "; ", name, row.use.empty() ? "" : ", ",
                        row.use.empty() ? "" : page_text(row.use), " (", share_or_dash(row.as_far), ")");
    }
    return rows.empty() ? ""
                        : page_text(
                              "Alone further away than 95 % of samples of the model: {rows}. By chance "
                              "one row in twenty is.",
                              {{"rows", names}});
}

void write_page(std::ostream& out, const Calibration& calibration, const std::vector<WrittenFile>& files) {
    const report::WritingLanguage language{calibration.scenario.report.language};
    const report::NamesOfScenario names_of_scenario{calibration.scenario};
    const Judgement& judgement = calibration.judgement;
    const std::string about =
        page_text("Calibration: {name}", {{"name", escaped(calibration.scenario.file.stem().string())}});
    const report::PageFrame frame{.title = report::page_title(calibration.scenario.report, about),
                                  .version = calibration.version,
                                  .scripts = {page_scripts::charts()},
                                  .style = std::string{report::page_file("calibration.css")},
                                  .before_main = {}};
    const std::string reason = reason_against(judgement, calibration.state);
    const std::string far = far_in_words(calibration, far_alone(calibration));
    report::begin_page(out, frame);
    out << report::filled_template(
        "calibration_page.html",
        {{"head", report::page_head(calibration.scenario.report, about)},
         {"calibrated", judgement.is_calibrated},
         {"fitted", grouped(number_of(calibration.observations, &Observation::fit))},
         {"held_out", grouped(judgement.held_out)},
         {"reason", reason.empty() ? std::string{} : report::message_text(reason)},
         {"warnings_link", report::link_to_first_warnings(calibration.warnings)},
         {"first_warnings", report::first_warnings(calibration.warnings)},
         {"is_far_alone", !far.empty()},
         {"far_alone", far},
         {"tried", grouped(calibration.state.tried())},
         {"rounds", std::to_string(calibration.state.waves.size())},
         {"kept", grouped(calibration.state.population.size())},
         {"effective", grouped(static_cast<std::uint64_t>(std::llround(judgement.effective_sets)))},
         {"rocks", grouped(calibration.plan.rocks)},
         {"fit_as_far", share_or_dash(judgement.fit_as_far)},
         {"held_out_as_far", share_or_dash(judgement.held_out_as_far)},
         {"version", calibration.version},
         {"sites", site_fields(calibration)},
         {"is_counted", is_coverage_counted(calibration)},
         {"sides", sides_of(calibration)},
         {"map", stop_map(calibration)},
         {"curves", curve_charts(calibration)},
         {"parameters", parameters_of(calibration)},
         {"factors", factor_chart(calibration)},
         {"sensitivities", sensitivities_of(calibration)},
         {"emulator", emulator_fields(calibration)},
         {"warnings", report::list_of_warnings(calibration.warnings)},
         {"settings",
          report::settings_section(calibration.scenario, [](const std::string&) { return true; })},
         {"inputs", report::table_of_inputs(calibration.inputs)},
         {"files", report::table_of_files("", files)},
         {"citation", report::citation(calibration.version, calibration.scenario)}});
    report::end_page(out, frame);
}

}  // namespace coupling::calibrate
