#include "coupling/assessments/decades/report/decade_page.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;

/// Settings that differ from their defaults, in a paragraph: the table of all is too long for paper.
std::string settings_on_paper(const PageContent& content) {
    if (content.scenario.options == nullptr) {
        return "";
    }
    std::string settings;
    for (const config::ParameterRow& row : content.scenario.shown_settings()) {
        if (row.changed && (!content.shows_setting || content.shows_setting(row.key))) {
            settings +=
                joined(settings.empty() ? "" : "; ", escaped(row.key), " = ", escaped(row.value_text));
        }
    }
    return joined("<div class=\"paper-only\"><h2>", report::page_text("Settings"), "</h2><p><small>",
                  report::page_text("Changed from their defaults: {settings}.", {{"settings", settings}}),
                  "</small></p><p>",
                  report::page_text(
                      "On screen the page has more: stands in numbers, maps of the rocks, the slope in three "
                      "dimensions, species and diameters, pictures of the stand, all settings and files."),
                  "</p></div>\n");
}

std::vector<Section> sections_of(const PageContent& content, const RunView& run) {
    std::vector<Section> sections = content.first;
    constexpr bool only_on_screen = false;
    // On paper, too, where the forest is the whole answer.
    sections.push_back({report::page_text("The forest at the start, half-way and at the end"), answers(run),
                        !has_rocks(content.scenario)});
    sections.push_back({report::page_text("Where the regimes act"), content.areas});
    sections.push_back(
        {report::page_text("The slope in three dimensions"), view_of_years(content, run), only_on_screen});
    sections.push_back({report::page_text("Maps of the rocks"), maps_of_falls(content, run), only_on_screen});
    sections.push_back({report::page_text("The forest over the years"), charts_of_regimes(run)});
    sections.push_back(
        {report::page_text("Species, losses and diameters"), charts_by_regime(content, run), only_on_screen});
    sections.push_back({report::page_text("The stand seen from above and from the side"),
                        pictures(content, run), only_on_screen});
    sections.push_back({report::page_text("Warnings"), report::list_of_warnings(content.warnings)});
    sections.push_back({"",
                        report::settings_section(content.scenario,
                                                 [&](const std::string& key) {
                                                     return !content.shows_setting ||
                                                            content.shows_setting(key);
                                                 }),
                        only_on_screen});
    sections.push_back({"", settings_on_paper(content)});
    sections.push_back(
        {report::page_text("Data"),
         joined(
             "<section class=\"card\"><p>",
             report::page_text(
                 "Input files, named as in the scenario; please credit their owners as their licences ask."),
             "</p>", report::table_of_inputs(content.inputs), "</section>\n")});
    sections.push_back(
        {report::page_text("Files of this run"),
         joined("<section class=\"card\">", report::table_of_files("", content.files), "</section>\n"),
         only_on_screen});
    return sections;
}

}  // namespace

void write_decade_page(std::ostream& out, const PageContent& content) {
    const report::WritingLanguage language{content.scenario.report.language};
    RunView run = view_of(content.names, content.members, content.grid.area_ha());
    run.disturbance = content.scenario.forest.parameters.disturbance;
    const report::PageFrame frame{
        .title =
            report::page_title(content.scenario.report,
                               report::page_text("A forest over years: {name}",
                                                 {{"name", escaped(content.scenario.file.stem().string())}})),
        .version = content.version,
        .scripts = {page_scripts::charts(), page_scripts::slope()},
        .style = page_style(),
        .before_main = fill_definitions()};
    report::begin_page(out, frame);
    out << page_opening(content, run);
    for (const Section& section : sections_of(content, run)) {
        if (section.html.empty()) {
            continue;
        }
        out << (section.on_paper ? "" : "<div class=\"screen-only\">");
        if (!section.heading.empty()) {
            out << "<h2>" << section.heading << "</h2>\n";
        }
        out << section.html << (section.on_paper ? "" : "</div>\n");
    }
    out << report::citation(content.version, content.scenario);
    report::end_page(out, frame);
}

}  // namespace coupling::decades
