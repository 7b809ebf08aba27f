#include "coupling/assessments/decades/report/decade_page.hpp"

#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::decades {
namespace {

using report::PageField;
using report::PageFields;

/// A part of the page that may be missing.
PageField part(std::string name, const std::string& html) {
    return {std::move(name), html.empty() ? std::nullopt : std::optional{PageFields{{"html", html}}}};
}

std::vector<PageFields> first_sections(const PageContent& content) {
    std::vector<PageFields> sections;
    for (const Section& section : content.first) {
        if (!section.html.empty()) {
            sections.push_back(
                {{"heading", section.heading}, {"html", section.html}, {"on_screen", !section.on_paper}});
        }
    }
    return sections;
}

/// Storms, beetles and dry seasons that the scenario asks for.
PageFields events_of(const Scenario& scenario) {
    const auto listed = [](const std::vector<double>& years) {
        std::vector<std::string> texts;
        for (const double year : years) {
            texts.push_back(config::to_text(year));
        }
        return report::join_with_and(texts);
    };
    const forest::DisturbanceLaw& law = scenario.forest.parameters.disturbance;
    const ForestSettings& forest = scenario.forest;
    return {{"storms_asked_for",
             law.storm_years.empty()
                 ? std::nullopt
                 : std::optional{PageFields{{"storm_years", listed(law.storm_years)},
                                            {"intensity", report::exact(law.intensity_asked_for)}}}},
            {"beetles_asked_for",
             law.beetle_years.empty() || !law.beetle
                 ? std::nullopt
                 : std::optional{PageFields{{"beetle_years", listed(law.beetle_years)},
                                            {"chance", report::exact(law.beetle_years_pha)}}}},
            {"dry_seasons_asked_for",
             forest.dry_years.empty()
                 ? std::nullopt
                 : std::optional{PageFields{{"dry_years", listed(forest.dry_years)},
                                            {"warmer_k", report::exact(forest.dry_season_k)},
                                            {"rain", report::exact(forest.dry_season_precipitation)}}}}};
}

PageFields fields_of(const PageContent& content, const RunView& run) {
    PageFields fields = page_opening(content, run);
    const PageFields events = events_of(content.scenario);
    fields.insert(fields.end(), events.begin(), events.end());
    const PageFields answers = answers_of(run);
    fields.insert(fields.end(), answers.begin(), answers.end());
    const auto shows = [&](const std::string& key) {
        return !content.shows_setting || content.shows_setting(key);
    };
    fields.insert(
        fields.end(),
        {{"first", first_sections(content)},
         {"rocks_fall", has_rocks(content.scenario)},  // without rocks the forest is the whole answer
         part("areas", content.areas),
         part("view", view_of_years(content, run)),
         {"falls", maps_of_falls(content, run)},
         {"curves", charts_of_regimes(run)},
         {"by_regime", charts_by_regime(content, run)},
         {"pictures", pictures(content, run)},
         {"warnings", report::list_of_warnings(content.warnings)},
         {"settings", report::settings_section(content.scenario, shows)},
         {"inputs", report::table_of_inputs(content.inputs)},
         {"files", report::table_of_files("", content.files)},
         {"citation", report::citation(content.version, content.scenario)}});
    return fields;
}

}  // namespace

void write_decade_page(std::ostream& out, const PageContent& content) {
    const report::WritingLanguage language{content.scenario.report.language};
    const report::NamesOfScenario names_of_scenario{content.scenario};
    RunView run = view_of(content.names, content.members, content.grid.area_ha());
    run.disturbance = content.scenario.forest.parameters.disturbance;
    run.disturbance.wind = run.disturbance.has_storms();
    const report::PageFrame frame{
        .title = report::page_title(
            content.scenario.report,
            report::page_text("A forest over years: {name}",
                              {{"name", report::escaped(content.scenario.file.stem().string())}})),
        .version = content.version,
        .scripts = {page_scripts::charts(), page_scripts::slope()},
        .style = page_style(),
        .before_main = fill_definitions()};
    report::begin_page(out, frame);
    out << report::filled_template("decade_page.html", fields_of(content, run));
    report::end_page(out, frame);
}

}  // namespace coupling::decades
