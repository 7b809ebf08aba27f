#include "coupling/assessments/vary/report/regime_page.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/vary/report/style.hpp"
#include "coupling/assessments/vary/report/tornado.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::vary::report {
namespace {

using config::joined;
using coupling::report::escaped;
using coupling::report::fixed;
using coupling::report::page_text;

std::string name_in(const RegimeOutcome& regime, const RegimeRun& base) {
    const auto several = [&](auto member) {
        return std::any_of(base.regimes.begin(), base.regimes.end(), [&](const RegimeOutcome& other) {
            return other.*member != base.regimes.front().*member;
        });
    };
    return joined(escaped(regime.regime),
                  several(&RegimeOutcome::climate) ? joined(", ", escaped(regime.climate)) : "",
                  several(&RegimeOutcome::target) ? joined(", ", escaped(regime.target)) : "");
}

std::string settings_of(const std::vector<Factor>& factors, const RegimeRun& run) {
    std::string settings;
    for (const std::string& one : run.combination.overrides(factors)) {
        settings += joined(settings.empty() ? "" : "<br>", "<code>", escaped(one), "</code>");
    }
    return settings.empty() ? page_text("as in the scenario") : settings;
}

/// What changes the ranking, in a sentence.
std::string flips(const std::vector<Factor>& factors, const std::vector<RegimeRun>& runs) {
    std::string changing;
    for (const RegimeRun& run : runs) {
        if (std::any_of(run.regimes.begin(), run.regimes.end(),
                        [](const RegimeOutcome& regime) { return regime.changes_rank; })) {
            for (const std::string& one : run.combination.overrides(factors)) {
                changing += joined(changing.empty() ? "" : ", ", "<code>", escaped(one), "</code>");
            }
        }
    }
    return changing.empty()
               ? page_text("No setting of this study changes the ranking of the regimes.")
               : page_text("The ranking of the regimes changes with {settings}.", {{"settings", changing}});
}

std::string table_of_runs(const std::vector<Factor>& factors, const std::vector<RegimeRun>& runs) {
    coupling::report::HtmlTable table{
        page_text("All runs: protection is the mean of the years with rocks after the start. Differences to "
                  "the first regime are paired by replicate, with 95 % intervals. A star: the order with "
                  "another regime is not that of the scenario."),
        {page_text("Settings"), page_text("regime"), page_text("protection, %"), page_text("rank"),
         page_text("difference, percentage points"), page_text("cheapest that keeps what is asked for")}};
    table.text_columns({1, 5});
    for (const RegimeRun& run : runs) {
        bool first = true;
        for (const RegimeOutcome& regime : run.regimes) {
            const auto& d = regime.difference;
            table.row(
                {first ? settings_of(factors, run) : "", name_in(regime, runs.front()),
                 fixed(regime.protection_percent, 1),
                 joined(std::to_string(regime.rank), regime.changes_rank ? " *" : ""),
                 d ? joined(fixed(d->mean, 1), " <small>(", fixed(d->low, 1), " – ", fixed(d->high, 1),
                            ")</small>")
                   : "–",
                 first ? (run.cheapest.empty() ? page_text("none, or not decided") : escaped(run.cheapest))
                       : ""});
            first = false;
        }
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace

std::vector<Sway> sways_of_regime(const std::vector<Factor>& factors, const std::vector<RegimeRun>& runs,
                                  std::size_t regime) {
    const double base = 0.01 * runs.front().regimes[regime].difference->mean;
    std::vector<Sway> sways;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (factors[i].crossed) {
            continue;
        }
        Sway sway{factors[i].setting, "", "", base, base};
        for (const RegimeRun& run : runs) {
            if (run.combination.alone != factors[i].setting || regime >= run.regimes.size() ||
                !run.regimes[regime].difference) {
                continue;
            }
            const double moved = 0.01 * run.regimes[regime].difference->mean;
            if (moved < sway.low) {
                sway.low = moved;
                sway.low_value = run.combination.values[i];
            }
            if (moved > sway.high) {
                sway.high = moved;
                sway.high_value = run.combination.values[i];
            }
        }
        sways.push_back(std::move(sway));
    }
    std::stable_sort(sways.begin(), sways.end(),
                     [](const Sway& a, const Sway& b) { return a.width() > b.width(); });
    return sways;
}

void write_regime_page(std::ostream& out, const std::string& scenario, const std::vector<Factor>& factors,
                       const std::vector<RegimeRun>& runs) {
    const std::string title = joined(page_text("Settings varied:"), " ", escaped(scenario));
    const coupling::report::PageFrame frame{title, config::version(), {}, std::string{page_style()}, {}};
    coupling::report::begin_page(out, frame);
    const RegimeRun& base = runs.front();
    out << "<h1>" << title << "</h1>\n<p>"
        << page_text(
               "{runs} runs with all regimes, climates and replicates of the scenario, with the same random "
               "numbers.",
               {{"runs", std::to_string(runs.size())}})
        << "</p>\n<p><b>" << flips(factors, runs) << "</b></p>\n";
    for (std::size_t regime = 0; regime < base.regimes.size(); ++regime) {
        if (!base.regimes[regime].difference) {
            continue;
        }
        const std::vector<Sway> sways = sways_of_regime(factors, runs, regime);
        if (sways.empty()) {
            continue;
        }
        out << "<h2>" << name_in(base.regimes[regime], base) << "</h2>\n<section class=\"card\"><p>"
            << page_text(
                   "In the scenario protection under {regime} is {difference} percentage points above that "
                   "under {reference} (line; below 0: less). Each bar shows how far this difference moves "
                   "when one setting takes other values and all else stays.",
                   {{"regime", escaped(base.regimes[regime].regime)},
                    {"reference", escaped(base.regimes.front().regime)},
                    {"difference", fixed(base.regimes[regime].difference->mean, 1)}})
            << "</p>"
            << tornado(sways, 0.01 * base.regimes[regime].difference->mean,
                       page_text("Protection minus that of the first regime, percentage points"))
            << "</section>\n";
    }
    out << table_of_runs(factors, runs);
    coupling::report::end_page(out, frame);
}

}  // namespace coupling::vary::report
