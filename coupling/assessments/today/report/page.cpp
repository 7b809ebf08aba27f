#include "coupling/assessments/today/report/page.hpp"

#include "config/text/joined.hpp"
#include "coupling/assessments/nets/net_page.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/assessments/today/report/shown_window.hpp"
#include "coupling/assessments/works/work_page.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

std::string projection_name(const std::string& text) {
    const std::size_t first = text.find('"');
    const std::size_t last = text.find('"', first + 1);
    return first == std::string::npos || last == std::string::npos
               ? page_text("none: the DEM has no .prj file, so the grids have none either")
               : text.substr(first + 1, last - first - 1);
}

PageFields settings_and_files(const RunResults& results, const std::vector<WrittenFile>& files) {
    return {
        {"warnings", list_of_warnings(results.warnings)},
        {"settings", settings_section(results.scenario, [](const std::string&) { return true; })},
        {"projection_name_projection", projection_name(results.site.projection)},
        {"inputs", table_of_inputs(results.site.inputs)},
        {"files",
         table_of_files(page_text("Grids have their projection (.prj) and a QGIS style (.qml) beside them."),
                        files)},
        {"citation", citation(results.version, results.scenario)}};
}

std::vector<page_scripts::Script> scripts_of(const RunResults& results) {
    std::vector<page_scripts::Script> scripts{page_scripts::charts(), page_scripts::slope()};
    if (has_moving_nets(results)) {
        scripts.push_back(page_scripts::nets());
    }
    return scripts;
}

}  // namespace

void write_page(std::ostream& out, const RunResults& results, const Figures& figures,
                const std::vector<WrittenFile>& files) {
    const WritingLanguage language{results.scenario.report.language};
    const NamesOfScenario names_of_scenario{results.scenario};
    const PageFrame frame{
        .title = with_return_period(
            page_title(results.scenario.report,
                       page_text("Rockfall with and without forest: {name}",
                                 {{"name", escaped(results.scenario.file.stem().string())}})),
            results.scenario),
        .version = results.version,
        .scripts = scripts_of(results),
        .style = config::joined(has_moving_nets(results) ? page_file("moving_nets.css") : "",
                                page_file("short_print.css")),
        .before_main = {}};
    PageFields fields{{"with_forest", results.with_forest},
                      {"energies", in_page_language(rockfall::what_energies_count())},
                      {"two_intervals", two_intervals(results, figures)},
                      {"along_lines", along_lines(results)},
                      {"target_barriers", target_barriers(results)},
                      {"forest", forest_of_today(results)},
                      {"nets", nets(results, shown_window(results))},
                      {"works", works(results)},
                      {"slope_view", slope_view(results)},
                      {"in_detail", answers_in_detail(results, figures)},
                      {"observed_stops", observed_stops(results.observed_stops)},
                      {"observed_events", observed_events(results.observed_events)},
                      {"single_paths", single_paths(results)},
                      {"paths_over_time", paths_over_time(results)}};
    for (const PageFields& part :
         {opening(results), answers(results, figures), maps(results), release_groups(results),
          charts(results, figures), key_figures(results, figures), grounds(results),
          settings_and_files(results, files)}) {
        fields.insert(fields.end(), part.begin(), part.end());
    }
    begin_page(out, frame);
    out << filled_template("today_page.html", fields);
    end_page(out, frame);
}

}  // namespace coupling::report
