#include "coupling/assessments/today/report/page.hpp"

#include "coupling/assessments/nets/net_page.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {

void write_page(std::ostream& out, const RunResults& results, const Figures& figures,
                const std::vector<WrittenFile>& files) {
    const WritingLanguage language{results.scenario.report.language};
    const PageFrame frame{
        .title = page_title(results.scenario.report,
                            page_text("Rockfall with and without forest: {name}",
                                      {{"name", escaped(results.scenario.file.stem().string())}})),
        .version = results.version,
        .scripts = {page_scripts::charts(), page_scripts::slope()},
        .style = {},
        .before_main = {}};
    begin_page(out, frame);
    out << first_screen(results, figures) << along_lines(results) << release_groups(results)
        << forest_of_today(results) << nets(results) << slope_view(results) << "<div class=\"appendix\">\n"
        << answers_in_detail(results, figures) << maps(results) << charts(results, figures)
        << observed_stops(results.observed_stops) << observed_events(results.observed_events)
        << along_paths(results) << key_figures(results, figures) << grounds(results) << warnings(results)
        << settings(results) << sources_and_files(results, files) << "</div>\n";
    end_page(out, frame);
}

}  // namespace coupling::report
