#include "coupling/assessments/decades/report/plan_page.hpp"

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/decades/report/area_maps.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/tables/intervention_areas.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;
using report::page_text;

/// Every row of every regime, those without ground of their own too.
std::string table_of_rows(const Management& management) {
    report::HtmlTable table{page_text("All rows of the regimes. Those without a ground of their own act on "
                                      "the whole forest, or where another row has cut."),
                            {page_text("Row"), page_text("Treatment"), page_text("Where"),
                             page_text("first year of the run"), page_text("every, years")}};
    table.text_columns({1, 2});
    for (const Regime& regime : management.regimes) {
        table.group(escaped(regime.name()));
        for (const Intervention& row : regime.interventions()) {
            const bool has_calendar = row.after.empty() && !row.has_condition();
            table.row({escaped(row.name), name_of(row.treatment), name_of(row.ground.where),
                       has_calendar ? std::to_string(row.first_year) : page_text("when its condition holds"),
                       row.every_years ? std::to_string(*row.every_years) : "–"});
        }
    }
    table.text_columns({1, 2, 3});
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace

void write_plan_page(std::ostream& out, const Scenario& scenario, const Site& site,
                     const Management& management, const config::Warnings& warnings) {
    const report::WritingLanguage language{scenario.report.language};
    const report::PageFrame frame{page_text("Where the regimes of {scenario} act",
                                            {{"scenario", escaped(scenario.file.stem().string())}}),
                                  config::version(),
                                  {},
                                  page_style(),
                                  ""};
    report::begin_page(out, frame);
    out << "<h1>" << frame.title << "</h1>\n<p>"
        << page_text("As the regimes are written, before anything is simulated.") << "</p>\n"
        << report::first_warnings(warnings);
    out << area_maps(site, management, intervention_areas(management, *site.forest, scenario.run.seed),
                     report::whole_of(site.map_frame), {});
    out << table_of_rows(management) << "<h2>" << page_text("Warnings") << "</h2>\n"
        << report::list_of_warnings(warnings);
    report::end_page(out, frame);
}

}  // namespace coupling::decades
