#include "coupling/assessments/decades/report/plan_page.hpp"

#include "config/version.hpp"
#include "coupling/assessments/decades/report/areas/area_maps.hpp"
#include "coupling/assessments/decades/report/areas/area_years.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/tables/intervention_areas.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::decades {
namespace {

using report::escaped;
using report::page_text;
using report::PageFields;

/// Every row of every regime, those without ground of their own too.
std::vector<PageFields> rows_of_regimes(const Management& management, const ForestSite& forest) {
    std::vector<PageFields> regimes;
    for (const Regime& regime : management.regimes) {
        std::vector<PageFields> rows;
        for (std::size_t i = 0; i < regime.interventions().size(); ++i) {
            const Intervention& row = regime.interventions()[i];
            const PlannedYears planned = planned_years(regime, i, std::nullopt, forest.run_years);
            rows.push_back({{"row", row.name},
                            {"treatment", std::string{name_of(row.treatment)}},
                            {"ground", std::string{name_of(row.ground.where)}},
                            {"when", when_in_words(planned, regime, i, forest.first_year() - 1)}});
        }
        regimes.push_back({{"regime", regime.name()}, {"rows", rows}});
    }
    return regimes;
}

}  // namespace

void write_plan_page(std::ostream& out, const Scenario& scenario, const Site& site,
                     const Management& management, const config::Warnings& warnings) {
    const report::WritingLanguage language{scenario.report.language};
    const report::NamesOfScenario names_of_scenario{scenario};
    const std::string about = page_text("Where the regimes of {scenario} act",
                                        {{"scenario", escaped(scenario.file.stem().string())}});
    const report::PageFrame frame{
        report::page_title(scenario.report, about), config::version(), {}, page_style(), ""};
    report::begin_page(out, frame);
    out << report::filled_template(
        "plan_page.html",
        {{"head", report::page_head(scenario.report, about)},
         {"warnings_link", report::link_to_first_warnings(warnings)},
         {"first_warnings", report::first_warnings(warnings)},
         {"areas",
          area_maps(site, management, intervention_areas(management, *site.forest, scenario.run.seed),
                    report::whole_of(site.map_frame), {})},
         {"regimes", rows_of_regimes(management, *site.forest)},
         {"warnings", report::list_of_warnings(warnings)}});
    report::end_page(out, frame);
}

}  // namespace coupling::decades
