#include "coupling/assessments/vary/vary.hpp"

#include <omp.h>

#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <utility>

#include "config/errors/warnings.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/vary/regime_study.hpp"
#include "coupling/assessments/vary/report/page.hpp"
#include "coupling/assessments/vary/study/outcomes.hpp"
#include "coupling/assessments/vary/write_table.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/inputs/site_falls.hpp"
#include "coupling/results/figures/fall_doubts.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/run/fall_rocks.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/progress.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling::vary {

namespace {

using config::joined;

/// A scenario with the settings of a combination. Throws InputError for what is wrong with them.
std::unique_ptr<Scenario> scenario_of(const VaryRequest& request, const std::vector<std::string>& overrides) {
    std::vector<std::string> all{request.overrides};
    all.insert(all.end(), overrides.begin(), overrides.end());
    std::unique_ptr<Scenario> scenario = read_scenario(request.scenario, all);
    if (scenario->run.years != 0 || !scenario->terrain.profile.empty() || wants_hazard_map(*scenario)) {
        config::fail(config::ExitCode::settings, {request.scenario.string()},
                     scenario->run.years != 0            ? "run.years above 0"
                     : scenario->terrain.profile.empty() ? "a hazard map"
                                                         : "terrain.profile",
                     "an assessment of today on a map",
                     scenario->run.years == 0 && scenario->terrain.profile.empty()
                         ? "vary one return period of it: --set hazard.return_period_years=YEARS"
                         : "");
    }
    return scenario;
}

/// All rocks of one combination; nothing if interrupted.
std::optional<Outcome> outcome_of(const VaryRequest& request, const Combination& combination,
                                  const std::vector<Factor>& factors, Progress& progress) {
    const std::unique_ptr<Scenario> scenario = scenario_of(request, combination.overrides(factors));
    config::Warnings warnings;  // those of the scenario: `bannwald check` prints them
    const Site site = open_site(*scenario, warnings);
    const config::GridFrame frame = site.map_frame_on_terrain();
    const SiteFalls falls{*scenario, site, frame};
    const rockfall::Assessment& assessment = falls.assessment;
    std::vector<std::uint8_t> gone;
    if (scenario->rockfall.fall.tree.remove_broken && !assessment.only_bare()) {
        gone.assign(falls.stems.placed().size() + falls.logs.count(), 0);
    }
    rockfall::EnsembleTally total{frame, site.targets.size(), falls.stems.placed().size(),
                                  falls.logs.count()};
    SourcesUnderWay under_way{frame.size()};
    const std::vector<rockfall::Chunk> chunks =
        rockfall::plan_chunks(site.sources, rockfall::rocks_of_chunk(scenario->rockfall.fall.motion.model));
    const int threads = request.threads > 0 ? request.threads : omp_get_max_threads();
    const std::size_t fallen =
        fall_rocks(assessment, chunks, under_way, {nullptr, nullptr}, gone, threads, total,
                   [&](const rockfall::ChunkRows& rows) {
                       progress.add(rows.rocks[index_of(Cover::bare)].size() + rows.not_started);
                   });
    if (fallen < chunks.size()) {
        return std::nullopt;
    }
    Outcome outcome;
    outcome.combination = combination;
    outcome.with_forest = !assessment.only_bare();
    const rockfall::RunTally& run = total.runs[index_of(outcome.with_forest ? Cover::forest : Cover::bare)];
    outcome.rocks = total.runs[index_of(Cover::bare)].rocks;
    const SlopeFigures slope = figures_of(run);
    outcome.run_out_mean_m = slope.run_out_m.mean;
    outcome.left_terrain = slope.by_reason[static_cast<std::size_t>(rockfall::StopReason::left_terrain)];
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        const rockfall::TargetTally& tally = total.targets[i];
        TargetOutcome target;
        target.id = site.targets[i].id;
        target.name = site.targets[i].name;
        target.bare = figures_of(tally.by_cover[index_of(Cover::bare)], outcome.rocks);
        if (outcome.with_forest) {
            target.forest = figures_of(tally.by_cover[index_of(Cover::forest)], outcome.rocks);
            const PairedCounts paired = paired_counts(tally);
            target.protection = protection_at(total, i);
            target.too_few = too_few_for_protection(paired);
        }
        outcome.targets.push_back(std::move(target));
    }
    return outcome;
}

std::vector<Factor> factors_of(const VaryRequest& request) {
    const FileBytes bytes = open_file(request.factors, {request.factors.string()}, "a table of settings");
    std::istringstream in{std::string{bytes.text()}};
    return read_factors(config::Table::read(in, request.factors.string()));
}

/// Rocks of all combinations. Reads every scenario, so that nothing falls where one of them is wrong.
std::uint64_t check_all(const VaryRequest& request, const std::vector<Factor>& factors,
                        const std::vector<Combination>& combinations) {
    std::uint64_t rocks = 0;
    IdleFactors idle{factors};
    for (const Combination& combination : combinations) {
        const std::unique_ptr<Scenario> scenario = scenario_of(request, combination.overrides(factors));
        idle.see(combination, *scenario->options);
        config::Warnings ignored;
        const Site site = open_site(*scenario, ignored);
        if (site.targets.empty()) {
            config::fail(config::ExitCode::settings, scenario->options->place_of("targets.file"),
                         "no targets", "what is to be protected: the study is about it");
        }
        rocks += site.rocks();
    }
    idle.refuse();
    return rocks;
}

void print_overview(const std::vector<Factor>& factors, const std::vector<Outcome>& outcomes,
                    std::ostream& screen) {
    const Outcome& base = outcomes.front();
    for (std::size_t i = 0; i < base.targets.size(); ++i) {
        const auto answer = [&](const Outcome& outcome) {
            const double value = outcome.targets[i].answer(outcome.with_forest);
            return std::isnan(value) ? std::string{"too few rocks arrive"} : coupling::report::percent(value);
        };
        screen << base.targets[i].name << ": "
               << (base.with_forest ? "stopped by the forest: " : "rocks that arrive: ") << answer(base)
               << '\n';
        for (const Outcome& outcome : outcomes) {
            std::string text;
            for (const std::string& one : outcome.combination.overrides(factors)) {
                text += joined(text.empty() ? "" : " ", one);
            }
            if (!text.empty()) {
                screen << "  " << text << ": " << answer(outcome) << '\n';
            }
        }
    }
}

}  // namespace

ShortSummary summary_of(const VaryRequest& request, const Scenario& scenario, std::size_t runs) {
    config::Warnings of_inputs;
    const Site site = open_site(scenario, of_inputs);
    return {.kind = "vary",
            .run = {{"scenario", request.scenario.filename().string()},
                    {"factors", request.factors.filename().string()},
                    {"overrides", scenario.shown_overrides()},
                    {"seed", scenario.run.seed}},
            .figures = {{"runs", runs}},
            .inputs = site.inputs,
            .warnings = of_inputs.warnings(),
            .excel_decimal = scenario.output.gis.csv == CsvForm::excel
                                 ? std::optional{config::decimal_sign(scenario.report.language)}
                                 : std::nullopt};
}

int vary_scenario(const VaryRequest& request, std::ostream& screen) {
    ShortRun::look_at(request.out, "vary", {"vary.csv", "report.html"}, request.overwrite);
    const std::vector<Factor> factors = factors_of(request);
    const std::vector<Combination> combinations = combinations_of(factors);
    if (read_scenario(request.scenario, request.overrides)->run.years > 0) {
        return vary_regimes(request, factors, combinations, screen);
    }
    const std::uint64_t rocks = check_all(request, factors, combinations);

    const InterruptGuard guard;
    ShortRun results{request.out};  // before the work: a folder that cannot be written is known at once
    Progress progress{"falling", rocks, 0, request.quiet};
    std::vector<Outcome> outcomes;
    for (const Combination& combination : combinations) {
        std::optional<Outcome> outcome = outcome_of(request, combination, factors, progress);
        if (!outcome) {
            progress.finish();
            return static_cast<int>(config::ExitCode::interrupted);
        }
        outcomes.push_back(std::move(*outcome));
    }
    progress.finish();

    const std::unique_ptr<Scenario> scenario = scenario_of(request, {});
    results.add("vary.csv", "Each run and target: what reaches it, what the forest stops.",
                [&](std::ostream& rows) { write_table(rows, factors, outcomes); });
    results.add("report.html", "The study as a page with a tornado chart for each target.",
                [&](std::ostream& page) { report::write_page(page, *scenario, factors, outcomes); });
    results.publish(summary_of(request, *scenario, outcomes.size()), target_layouts(factors));
    if (!request.quiet) {
        print_overview(factors, outcomes, screen);
        screen << "Results in " << request.out.string() << ": vary.csv, report.html\n";
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling::vary
