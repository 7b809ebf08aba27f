#include "coupling/assessments/vary/report/page.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/vary/report/tornado.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::vary::report {
namespace {

using config::joined;
using coupling::report::escaped;
using coupling::report::fixed;
using coupling::report::grouped;
using coupling::report::page_text;
using coupling::report::PageFields;
using coupling::report::percent;

std::string with_interval(double value, const Interval& interval) {
    return std::isnan(value) ? "–"
                             : joined(percent(value), " (",
                                      page_text("{low} to {high}", {{"low", percent(interval.low)},
                                                                    {"high", percent(interval.high)}}),
                                      ")");
}

std::string protection_of(const TargetOutcome& target) {
    return target.protection && !target.too_few
               ? with_interval(target.protection->value, target.protection->interval)
               : "–";
}

std::vector<PageFields> rows_of(const std::vector<Factor>& factors, const std::vector<Outcome>& outcomes,
                                std::size_t target) {
    std::vector<PageFields> rows;
    for (const Outcome& outcome : outcomes) {
        const TargetOutcome& found = outcome.targets[target];
        rows.push_back({{"run", std::to_string(rows.size())},
                        {"settings", rows_of_settings(factors, outcome.combination)},
                        {"protection", protection_of(found)},
                        {"bare", with_interval(found.bare.share.value, found.bare.share.interval)},
                        {"bare_kj", fixed(found.bare.energy_kj.mean, 1)},
                        {"bare_m", fixed(found.bare.top_height_m.p95, 1)},
                        {"forest", with_interval(found.forest.share.value, found.forest.share.interval)},
                        {"forest_kj", fixed(found.forest.energy_kj.mean, 1)},
                        {"forest_m", fixed(found.forest.top_height_m.p95, 1)}});
    }
    return rows;
}

PageFields part_of(const std::vector<Factor>& factors, const std::vector<Outcome>& outcomes,
                   std::size_t target) {
    const Outcome& base = outcomes.front();
    std::vector<Answer> answers;
    for (const Outcome& outcome : outcomes) {
        answers.push_back({outcome.combination, outcome.targets[target].answer(outcome.with_forest)});
    }
    const double answer = answers.front().value;
    const std::vector<Sway> sways = sways_of(factors, answers);
    std::optional<PageFields> swayed;
    if (!sways.empty()) {
        const std::string axis =
            page_text(base.with_forest ? "Rocks that the forest stops, %" : "Rocks that arrive, %");
        swayed = {{"answer", percent(answer)}, {"tornado", tornado(sways, answer, axis)}};
    }
    return {{"target", base.targets[target].name},
            {"too_few", std::isnan(answer)},
            {"swayed", swayed},
            {"rows", rows_of(factors, outcomes, target)}};
}

}  // namespace

std::vector<PageFields> rows_of_settings(const std::vector<Factor>& factors, const Combination& combination) {
    std::vector<PageFields> rows;
    for (const std::string& setting : combination.overrides(factors)) {
        rows.push_back({{"setting", setting}});
    }
    return rows;
}

void write_page(std::ostream& out, const Scenario& scenario, const std::vector<Factor>& factors,
                const std::vector<Outcome>& outcomes) {
    const coupling::report::WritingLanguage language{scenario.report.language};
    const coupling::report::NamesOfScenario names_of_scenario{scenario};
    const std::string about =
        page_text("Settings varied: {name}", {{"name", escaped(scenario.file.stem().string())}});
    const coupling::report::PageFrame frame{.title = coupling::report::page_title(scenario.report, about),
                                            .version = config::version(),
                                            .scripts = {},
                                            .style = std::string{coupling::report::page_file("vary.css")},
                                            .before_main = {}};
    coupling::report::begin_page(out, frame);
    std::vector<PageFields> targets;
    for (std::size_t target = 0; target < outcomes.front().targets.size(); ++target) {
        targets.push_back(part_of(factors, outcomes, target));
    }
    out << coupling::report::filled_template("vary_page.html",
                                             {{"head", coupling::report::page_head(scenario.report, about)},
                                              {"runs", grouped(outcomes.size())},
                                              {"rocks", grouped(outcomes.front().rocks)},
                                              {"with_forest", outcomes.front().with_forest},
                                              {"targets", targets}});
    coupling::report::end_page(out, frame);
}

}  // namespace coupling::vary::report
