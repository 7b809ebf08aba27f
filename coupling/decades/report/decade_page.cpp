#include "coupling/decades/report/decade_page.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/decades/report/page_parts.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/report/page_text.hpp"
#include "coupling/results/report/writing_language.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;

std::vector<Section> sections_of(const PageContent& content, const RunView& run) {
    std::vector<Section> sections = content.first;
    sections.push_back({report::page_text("decades.decade_page.the_forest_at_the_start_half"), answers(run)});
    sections.push_back(
        {report::page_text("common.the_slope_in_three_dimensions"), view_of_years(content, run)});
    sections.push_back(
        {report::page_text("decades.decade_page.maps_of_the_rocks"), maps_of_falls(content, run)});
    sections.push_back(
        {report::page_text("decades.decade_page.the_forest_over_the_years"), charts_of_regimes(run)});
    sections.push_back({report::page_text("decades.decade_page.species_losses_and_diameters"),
                        charts_by_regime(content, run)});
    sections.push_back(
        {report::page_text("decades.decade_page.the_stand_seen_from_above_and"), pictures(content, run)});
    sections.push_back({report::page_text("common.warnings"), report::list_of_warnings(content.warnings)});
    sections.push_back({"", report::settings_section(content.scenario, [&](const std::string& key) {
                            return !content.shows_setting || content.shows_setting(key);
                        })});
    sections.push_back(
        {report::page_text("common.data"),
         joined("<section class=\"card\"><p>", report::page_text("common.input_files_named_as_in_the"),
                "</p>", report::table_of_inputs(content.inputs), "</section>\n")});
    sections.push_back(
        {report::page_text("common.files_of_this_run"),
         joined("<section class=\"card\">", report::table_of_files("", content.files), "</section>\n")});
    return sections;
}

}  // namespace

void write_decade_page(std::ostream& out, const PageContent& content) {
    const report::WritingLanguage language{content.scenario.report.language};
    const RunView run = view_of(content.names, content.members, content.grid.area_ha());
    const report::PageFrame frame{
        .title = report::page_title(content.scenario.report,
                                    joined(report::page_text("decades.decade_page.a_forest_over_years"),
                                           escaped(content.scenario.file.stem().string()))),
        .version = content.version,
        .scripts = {page_scripts::charts(), page_scripts::slope()},
        .style = page_style(),
        .before_main = fill_definitions()};
    report::begin_page(out, frame);
    out << report::first_warnings(content.warnings) << page_opening(content, run);
    for (const Section& section : sections_of(content, run)) {
        if (section.html.empty()) {
            continue;
        }
        if (!section.heading.empty()) {
            out << "<h2>" << section.heading << "</h2>\n";
        }
        out << section.html;
    }
    out << report::citation(content.version, content.scenario);
    report::end_page(out, frame);
}

}  // namespace coupling::decades
