#include "coupling/assessments/vary/regime_study.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "config/errors/warnings.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/whole_run.hpp"
#include "coupling/assessments/vary/report/regime_page.hpp"
#include "coupling/assessments/vary/write_table.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling::vary {
namespace {

using config::joined;
using decades::Series;

/// Mean protection of the years with rocks after the start; NaN where none is known.
double mean_after_start(const std::map<std::int32_t, double>& years) {
    double sum = 0.0;
    double count = 0.0;
    for (const auto& [year, value] : years) {
        sum += year > 0 ? value : 0.0;
        count += year > 0 ? 1.0 : 0.0;
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

double mean_of_known(const std::vector<double>& values) {
    double sum = 0.0;
    double count = 0.0;
    for (const double value : values) {
        sum += std::isnan(value) ? 0.0 : value;
        count += std::isnan(value) ? 0.0 : 1.0;
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// Of the replicates that both know.
std::optional<decades::PairedDifference> paired_difference(const std::vector<double>& a,
                                                           const std::vector<double>& b) {
    std::vector<double> differences;
    for (std::size_t r = 0; r < std::min(a.size(), b.size()); ++r) {
        if (const double difference = a[r] - b[r]; !std::isnan(difference)) {
            differences.push_back(difference);
        }
    }
    return differences.empty() ? std::nullopt : std::optional{decades::difference_of(differences)};
}

/// 1 or -1: protection under `a` is above or below that under `b` beyond chance (pairs of replicates, 95 %).
int known_order(const RegimeOutcome& a, const RegimeOutcome& b) {
    const auto difference = paired_difference(a.by_replicate, b.by_replicate);
    return !difference ? 0 : difference->low > 0.0 ? 1 : difference->high < 0.0 ? -1 : 0;
}

/// All regimes at a target in a climate, with their ranks.
void add_regimes(const decades::Names& names, const Series& series, std::size_t climate, RegimeRun& run) {
    const std::size_t first = run.regimes.size();
    std::vector<std::vector<double>> by_replicate;
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        by_replicate.emplace_back();
        for (const auto& years : series.values[names.course(regime, climate)]) {
            by_replicate.back().push_back(mean_after_start(years));
        }
        RegimeOutcome outcome;
        outcome.regime = names.regimes[regime];
        outcome.climate = names.climates[climate];
        outcome.target = series.target;
        outcome.protection_percent = mean_of_known(by_replicate.back());
        outcome.by_replicate = by_replicate.back();
        if (regime > 0) {
            outcome.difference = paired_difference(by_replicate.back(), by_replicate.front());
        }
        run.regimes.push_back(std::move(outcome));
    }
    for (std::size_t i = first; i < run.regimes.size(); ++i) {
        run.regimes[i].rank = 1;
        for (std::size_t j = first; j < run.regimes.size(); ++j) {
            run.regimes[i].rank +=
                run.regimes[j].protection_percent > run.regimes[i].protection_percent ? 1 : 0;
        }
    }
}

std::unique_ptr<Scenario> years_scenario(const VaryRequest& request, const std::vector<std::string>& moved) {
    std::vector<std::string> all{request.overrides};
    all.insert(all.end(), moved.begin(), moved.end());
    std::unique_ptr<Scenario> scenario = read_scenario(request.scenario, all);
    if (scenario->run.years == 0 || scenario->forest.rockfall_every == 0) {
        config::fail(config::ExitCode::settings, {request.scenario.string()},
                     scenario->run.years == 0 ? "run.years 0 in one of the runs" : "run.rockfall_every 0",
                     "years with rocks in all runs of the study");
    }
    return scenario;
}

std::vector<std::string> moved_in(const std::vector<Factor>& factors, const RegimeRun& run) {
    return run.combination.overrides(factors);
}

void print_study(const std::vector<Factor>& factors, const std::vector<RegimeRun>& runs,
                 std::ostream& screen) {
    for (const RegimeRun& run : runs) {
        std::string settings;
        for (const std::string& one : moved_in(factors, run)) {
            settings += joined(settings.empty() ? "" : " ", one);
        }
        const bool flips = std::any_of(run.regimes.begin(), run.regimes.end(),
                                       [](const RegimeOutcome& each) { return each.changes_rank; });
        screen << (settings.empty() ? "as in the scenario" : settings)
               << (flips ? ": the ranking of the regimes changes beyond chance" : "") << '\n';
        for (const RegimeOutcome& regime : run.regimes) {
            screen << "  " << regime.rank << ". " << regime.regime << ", " << regime.climate << ", "
                   << regime.target << ": " << coupling::report::fixed(regime.protection_percent, 1) << " %";
            if (regime.difference) {
                screen << ", difference " << coupling::report::fixed(regime.difference->mean, 1) << " ("
                       << coupling::report::fixed(regime.difference->low, 1) << " to "
                       << coupling::report::fixed(regime.difference->high, 1) << ")";
            }
            screen << '\n';
        }
    }
}

}  // namespace

RegimeRun outcome_of(const Combination& combination, const decades::Names& names, const Site& site,
                     std::span<const decades::MemberYears> members, const Scenario& scenario) {
    const std::vector<Series> all_series = decades::series_of(names, site, members, std::nullopt);
    RegimeRun run{combination, {}, {}};
    for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
        for (const Series& series : all_series) {
            if (series.quantity == "protection_percent") {
                add_regimes(names, decades::as_parts(series), climate, run);
            }
        }
    }
    const auto decision = decades::decide(names, all_series, members, scenario.forest.decision);
    if (decision && !decision->keeping(names).empty()) {
        run.cheapest = names.regimes[decision->keeping(names).front()];
    }
    return run;
}

void mark_rank_changes(std::vector<RegimeRun>& runs) {
    const std::vector<RegimeOutcome> base = runs.front().regimes;
    const auto in_base = [&base](const RegimeOutcome& wanted) {
        const auto found = std::find_if(base.begin(), base.end(), [&](const RegimeOutcome& each) {
            return each.regime == wanted.regime && each.climate == wanted.climate &&
                   each.target == wanted.target;
        });
        return found == base.end() ? RegimeOutcome{} : *found;
    };
    for (RegimeRun& run : runs) {
        for (RegimeOutcome& regime : run.regimes) {
            regime.changes_rank =
                std::any_of(run.regimes.begin(), run.regimes.end(), [&](const RegimeOutcome& other) {
                    // Neither a tie that is broken nor chance is a change of order.
                    return other.climate == regime.climate && other.target == regime.target &&
                           known_order(regime, other) * known_order(in_base(regime), in_base(other)) < 0;
                });
        }
    }
}

int vary_regimes(const VaryRequest& request, const std::vector<Factor>& factors,
                 const std::vector<Combination>& combinations, std::ostream& screen) {
    // Everything that is wrong with any run is said before the first one begins.
    IdleFactors idle{factors};
    for (const Combination& combination : combinations) {
        const auto scenario = years_scenario(request, combination.overrides(factors));
        idle.see(combination, *scenario->options);
        config::Warnings ignored;
        const Site site = open_site(*scenario, ignored);
        decades::read_management(*scenario, *site.forest, ignored, decades::mean_block_m(*scenario, site));
        if (site.targets.empty()) {
            config::fail(config::ExitCode::settings, scenario->options->place_of("targets.file"),
                         "no targets", "what is to be protected: the study is about it");
        }
    }
    idle.refuse();
    const InterruptGuard guard;
    ShortRun results{request.out};
    std::vector<RegimeRun> runs;
    try {
        for (const Combination& combination : combinations) {
            const auto scenario = years_scenario(request, combination.overrides(factors));
            config::Warnings warnings;  // those of the scenario: `bannwald check` prints them
            const Site site = open_site(*scenario, warnings);
            const decades::Management management = decades::read_management(
                *scenario, *site.forest, warnings, decades::mean_block_m(*scenario, site));
            RankGroup alone{RankGroup::Alone{}};
            const int threads = request.threads > 0 ? request.threads : omp_get_max_threads();
            const std::vector<decades::MemberYears> members =
                decades::simulate_whole(*scenario, site, management, {alone, threads, request.quiet});
            runs.push_back(outcome_of(combination, decades::names_of(management, *site.forest), site, members,
                                      *scenario));
        }
    } catch (const Interrupted&) {
        return static_cast<int>(config::ExitCode::interrupted);
    }
    mark_rank_changes(runs);
    results.add("vary.csv", "Each run, climate, target and regime: protection, rank, difference.",
                [&](std::ostream& rows) { write_regime_table(rows, factors, runs); });
    results.add("report.html", "The study as a page: differences of the regimes.", [&](std::ostream& page) {
        report::write_regime_page(page, request.scenario.stem().string(), factors, runs);
    });
    results.publish(summary_of(request, *read_scenario(request.scenario, request.overrides), runs.size()),
                    regime_layouts(factors));
    if (!request.quiet) {
        print_study(factors, runs, screen);
        screen << "Results in " << request.out.string() << ": vary.csv, report.html\n";
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling::vary
