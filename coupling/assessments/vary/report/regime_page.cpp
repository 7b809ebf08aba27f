#include "coupling/assessments/vary/report/regime_page.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/vary/report/page.hpp"
#include "coupling/assessments/vary/report/tornado.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::vary::report {
namespace {

using config::joined;
using coupling::report::element;
using coupling::report::escaped;
using coupling::report::fixed;
using coupling::report::page_text;
using coupling::report::PageFields;

std::string name_in(const RegimeOutcome& regime, const RegimeRun& base) {
    const auto several = [&](auto member) {
        return std::any_of(base.regimes.begin(), base.regimes.end(), [&](const RegimeOutcome& other) {
            return other.*member != base.regimes.front().*member;
        });
    };
    return joined(regime.regime, several(&RegimeOutcome::climate) ? joined(", ", regime.climate) : "",
                  several(&RegimeOutcome::target) ? joined(", ", regime.target) : "");
}

/// The settings that change the ranking; nothing without any.
std::optional<PageFields> ranking_changes(const std::vector<Factor>& factors,
                                          const std::vector<RegimeRun>& runs) {
    std::vector<std::string> changing;
    for (const RegimeRun& run : runs) {
        if (std::any_of(run.regimes.begin(), run.regimes.end(),
                        [](const RegimeOutcome& regime) { return regime.changes_rank; })) {
            for (const std::string& one : run.combination.overrides(factors)) {
                changing.push_back(element("code", {}, escaped(one)));
            }
        }
    }
    if (changing.empty()) {
        return std::nullopt;
    }
    return PageFields{{"settings_html", coupling::report::join_with_commas(changing)}};
}

std::vector<PageFields> rows_of_runs(const std::vector<Factor>& factors, const std::vector<RegimeRun>& runs) {
    std::vector<PageFields> rows;
    for (const RegimeRun& run : runs) {
        std::optional<PageFields> cheapest, first;
        if (!run.cheapest.empty()) {
            cheapest = {{"regime", run.cheapest}};
        }
        first = {{"settings", rows_of_settings(factors, run.combination)}, {"cheapest", cheapest}};
        for (const RegimeOutcome& regime : run.regimes) {
            std::optional<PageFields> paired;
            if (const auto& d = regime.difference) {
                paired = {
                    {"mean", fixed(d->mean, 1)}, {"low", fixed(d->low, 1)}, {"high", fixed(d->high, 1)}};
            }
            rows.push_back({{"first", first},
                            {"name", name_in(regime, runs.front())},
                            {"protection", fixed(regime.protection_percent, 1)},
                            {"rank", std::to_string(regime.rank)},
                            {"changes_rank", regime.changes_rank},
                            {"paired", paired}});
            first.reset();
        }
    }
    return rows;
}

/// The difference of a regime (place in RegimeRun::regimes) to the first one in each run, as a share.
std::vector<Answer> differences_of(std::size_t regime, const std::vector<RegimeRun>& runs) {
    std::vector<Answer> answers;
    for (const RegimeRun& run : runs) {
        const bool known = regime < run.regimes.size() && run.regimes[regime].difference;
        answers.push_back({run.combination, known ? 0.01 * run.regimes[regime].difference->mean : NAN});
    }
    return answers;
}

/// The regimes that are compared with the first one.
std::vector<PageFields> compared(const std::vector<Factor>& factors, const std::vector<RegimeRun>& runs) {
    std::vector<PageFields> all;
    const RegimeRun& base = runs.front();
    for (std::size_t place = 0; place < base.regimes.size(); ++place) {
        const RegimeOutcome& regime = base.regimes[place];
        const std::vector<Answer> answers = differences_of(place, runs);
        const std::vector<Sway> sways = sways_of(factors, answers);
        if (!sways.empty()) {
            all.push_back(
                {{"name", name_in(regime, base)},
                 {"regime", regime.regime},
                 {"reference", base.regimes.front().regime},
                 {"difference", fixed(regime.difference->mean, 1)},
                 {"tornado",
                  tornado(sways, answers.front().value,
                          page_text("Protection minus that of the first regime, percentage points"))}});
        }
    }
    return all;
}

}  // namespace

void write_regime_page(std::ostream& out, const std::string& scenario, const std::vector<Factor>& factors,
                       const std::vector<RegimeRun>& runs) {
    const coupling::report::PageFrame frame{
        .title = page_text("Settings varied: {name}", {{"name", escaped(scenario)}}),
        .version = config::version(),
        .scripts = {},
        .style = std::string{coupling::report::page_file("vary.css")},
        .before_main = {}};
    coupling::report::begin_page(out, frame);
    out << coupling::report::filled_template("regime_page.html",
                                             {{"name", scenario},
                                              {"runs", std::to_string(runs.size())},
                                              {"ranking_changes", ranking_changes(factors, runs)},
                                              {"compared", compared(factors, runs)},
                                              {"rows", rows_of_runs(factors, runs)}});
    coupling::report::end_page(out, frame);
}

}  // namespace coupling::vary::report
