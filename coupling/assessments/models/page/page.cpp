#include "coupling/assessments/models/page/page.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "config/version.hpp"
#include "coupling/assessments/models/page/answers.hpp"
#include "coupling/assessments/models/page/figure_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::models {
namespace {

using report::escaped;
using report::page_text;
using report::PageFields;

const rockfall::ModelDescription& description_by_name(const std::string& name) {
    const auto& all = rockfall::all_models();
    return rockfall::description_of(*std::find_if(all.begin(), all.end(), [&](rockfall::MotionModel model) {
        return rockfall::description_of(model).name == name;
    }));
}

/// Which model for what: what its rocks do, what its energies count, what it is judged by, its caution.
std::vector<PageFields> rows_of_models(const Comparison& comparison, const PageContext& context) {
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < comparison.models.size(); ++i) {
        const rockfall::ModelDescription& model = description_by_name(comparison.models[i]);
        rows.push_back({{"model", comparison.models[i]},
                        {"file", context.runs[i].file},
                        {"title", report::in_page_language(model.title)},
                        {"energy", report::in_page_language(model.energy)},
                        {"verdicts_html", report::verdicts_on_page(model.name)},
                        {"has_caution", !model.caution.empty()},
                        {"caution_html", report::message_html(model.caution)}});
    }
    return rows;
}

std::vector<PageFields> links_to(const std::vector<LinkedPage>& pages) {
    std::vector<PageFields> links;
    for (const LinkedPage& page : pages) {
        links.push_back({{"file", page.file},
                         {"name", page.return_period_years > 0.0
                                      ? page_text("Return period of {years} years",
                                                  {{"years", report::exact(page.return_period_years)}})
                                      : page_text("Distributions and maps side by side")}});
    }
    return links;
}

/// The tables of figures by return period; one part without a period for a run of today.
std::vector<PageFields> parts_of_figures(const Comparison& comparison) {
    std::set<double> periods;
    for (const ModelFigure& figure : comparison.figures) {
        periods.insert(figure.key.return_period_years);
    }
    std::vector<PageFields> parts;
    for (const double period : periods) {
        parts.push_back({{"has_period", period > 0.0},
                         {"years", report::exact(period)},
                         {"tables", figure_tables(comparison, period)}});
    }
    return parts;
}

std::string list_of(const std::vector<std::string>& models) {
    std::string list;
    for (const std::string& model : models) {
        list += (list.empty() ? "" : ", ") + model;
    }
    return list;
}

}  // namespace

void write_page(std::ostream& out, const Comparison& comparison, const PageContext& context) {
    const report::WritingLanguage language{context.scenario.report.language};
    const report::NamesOfScenario names_of_scenario{context.scenario};
    const std::string about = page_text("Motion models side by side: {name}",
                                        {{"name", escaped(context.scenario.file.stem().string())}});
    const report::PageFrame frame{.title = report::page_title(context.scenario.report, about),
                                  .version = config::version(),
                                  .scripts = {},
                                  .style = std::string{report::page_file("models.css")},
                                  .before_main = {}};
    const std::size_t targets = targets_by_reach(comparison.figures).size();
    report::begin_page(out, frame);
    out << report::filled_template(
        "models_page.html",
        {{"head", report::page_head(context.scenario.report, about)},
         {"names", list_of(comparison.models)},
         {"answers", answers(comparison)},
         {"warnings_link", report::link_to_first_warnings(context.warnings)},
         {"first_warnings",
          report::first_warnings(context.warnings, page_text("the pages of the runs list all"))},
         {"models", rows_of_models(comparison, context)},
         {"details", links_to(context.details)},
         {"has_more_targets", targets > most_shown_targets},
         {"targets_shown", std::to_string(std::min(targets, most_shown_targets))},
         {"targets_all", report::grouped(targets)},
         {"parts", parts_of_figures(comparison)}});
    report::end_page(out, frame);
}

}  // namespace coupling::models
