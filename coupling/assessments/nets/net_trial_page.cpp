#include "coupling/assessments/nets/net_trial_page.hpp"

#include "config/version.hpp"
#include "coupling/assessments/nets/figures/net_summary.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/nets/figures/site_for_maps.hpp"
#include "coupling/assessments/nets/moving/moving_nets.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling {

void write_net_trial_page(std::ostream& out, const NetTrial& trial, NetPathsReader& paths,
                          const ReportSettings& head, const std::vector<WrittenFile>& files) {
    using report::page_text;
    const report::WritingLanguage language{head.language};
    const std::string title = title_with_period(page_text("Other nets"), paths.head());
    const report::PageFrame frame{.title = report::page_title(head, title),
                                  .version = config::version(),
                                  .scripts = {page_scripts::nets()},
                                  .style = std::string{report::page_file("moving_nets.css")},
                                  .before_main = {}};
    const rockfall::Terrain& terrain = paths.terrain();
    const Site site =
        site_for_maps(terrain, map_frame_of(terrain), {}, {trial.nets.begin(), trial.nets.end()});
    const report::MapSheet sheet{site};
    std::vector<report::PageFields> answers;
    for (const NetFigures& of : trial.figures) {
        answers.push_back({{"answer", in_words(trial.nets[of.net], of, paths.head().design)}});
    }
    std::vector<report::PageFields> remarks;
    for (const std::string& remark : trial.remarks) {
        remarks.push_back({{"remark", report::message_html(remark)}});
    }
    report::begin_page(out, frame);
    out << report::filled_template(
        "net_trial_page.html",
        {{"head", report::page_head(head, title)},
         {"answers", answers},
         {"rule", design_rule_in_words(paths.head().design)},
         {"remarked", !remarks.empty()},
         {"remarks", remarks},
         {"map_definitions", sheet.definitions()},
         {"moving", moving::moving_nets(paths, trial.nets, sheet)},
         {"files", report::table_of_files(page_text("All files stand beside this page."), files)}});
    report::end_page(out, frame);
}

}  // namespace coupling
