#include "coupling/assessments/vary/report/page.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/vary/report/style.hpp"
#include "coupling/assessments/vary/report/tornado.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::vary::report {
namespace {

using config::joined;
using coupling::report::escaped;
using coupling::report::page_text;
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

std::string table_of(const std::vector<Factor>& factors, const std::vector<Outcome>& outcomes,
                     std::size_t target) {
    const bool with_forest = outcomes.front().with_forest;
    std::vector<std::string> head{page_text("Run")};
    head.push_back(page_text("Settings"));
    if (with_forest) {
        head.push_back(page_text("the forest stops"));
    }
    head.insert(head.end(), {page_text("arrive, bare slope"), page_text("mean energy, bare slope, kJ")});
    if (with_forest) {
        head.insert(head.end(),
                    {page_text("arrive, with forest"), page_text("mean energy, with forest, kJ")});
    }
    coupling::report::HtmlTable table{page_text("All runs, with 95 % intervals of the chance of the rocks."),
                                      head};
    table.text_columns({1});
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Outcome& outcome = outcomes[i];
        const TargetOutcome& found = outcome.targets[target];
        std::string settings;
        for (const std::string& one : outcome.combination.overrides(factors)) {
            settings += joined(settings.empty() ? "" : "<br>", "<code>", escaped(one), "</code>");
        }
        std::vector<std::string> cells{std::to_string(i),
                                       i == 0 ? page_text("as in the scenario") : settings};
        if (with_forest) {
            cells.push_back(protection_of(found));
        }
        cells.push_back(with_interval(found.bare.share.value, found.bare.share.interval));
        cells.push_back(coupling::report::fixed(found.bare.energy_kj.mean, 1));
        if (with_forest) {
            cells.push_back(with_interval(found.forest.share.value, found.forest.share.interval));
            cells.push_back(coupling::report::fixed(found.forest.energy_kj.mean, 1));
        }
        table.row(cells);
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

std::string part_of(const std::vector<Factor>& factors, const std::vector<Outcome>& outcomes,
                    std::size_t target) {
    const Outcome& base = outcomes.front();
    const double answer = base.targets[target].answer(base.with_forest);
    const std::vector<Sway> sways = sways_of(factors, outcomes, target);
    std::string html = joined("<h2>", escaped(base.targets[target].name), "</h2>\n");
    if (std::isnan(answer)) {
        html += joined(
            "<p>",
            page_text("Too few rocks of the scenario arrive here to compare shares: let more rocks fall."),
            "</p>\n");
    } else if (!sways.empty()) {
        html += joined(
            "<section class=\"card\"><p>",
            page_text(base.with_forest
                          ? "In the scenario the forest stops {answer} of the rocks that would arrive "
                            "(line). Each bar shows how far that share moves when one setting takes other "
                            "values and all else stays; at its ends, the values."
                          : "Of the rocks of the scenario {answer} arrive (line). Each bar shows how far "
                            "that share moves when one setting takes other values and all else stays; at its "
                            "ends, the values.",
                      {{"answer", percent(answer)}}),
            "</p>",
            tornado(sways, answer,
                    page_text(base.with_forest ? "Rocks that the forest stops, %" : "Rocks that arrive, %")),
            "</section>\n");
    }
    return joined(html, table_of(factors, outcomes, target));
}

}  // namespace

void write_page(std::ostream& out, const Scenario& scenario, const std::vector<Factor>& factors,
                const std::vector<Outcome>& outcomes) {
    const coupling::report::WritingLanguage language{scenario.report.language};
    const std::string about =
        joined(page_text("Settings varied:"), " ", escaped(scenario.file.stem().string()));
    const coupling::report::PageFrame frame{.title = coupling::report::page_title(scenario.report, about),
                                            .version = config::version(),
                                            .scripts = {},
                                            .style = std::string{page_style()},
                                            .before_main = {}};
    coupling::report::begin_page(out, frame);
    out << coupling::report::page_head(scenario.report, about) << "<p>"
        << page_text(
               "{runs} runs of {rocks} rocks. Rocks and trees are the same in all of them, as far as the "
               "settings leave them the same: differences come from the settings.",
               {{"runs", coupling::report::grouped(outcomes.size())},
                {"rocks", coupling::report::grouped(outcomes.front().rocks)}})
        << "</p>\n";
    for (std::size_t target = 0; target < outcomes.front().targets.size(); ++target) {
        out << part_of(factors, outcomes, target);
    }
    coupling::report::end_page(out, frame);
}

}  // namespace coupling::vary::report
