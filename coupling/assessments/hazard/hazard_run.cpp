#include "coupling/assessments/hazard/hazard_run.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/hazard/hazard_folder.hpp"
#include "coupling/assessments/hazard/hazard_plan.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/hazard/hazard_screen.hpp"
#include "coupling/assessments/hazard/period_results.hpp"
#include "coupling/assessments/hazard/shared_warnings.hpp"
#include "coupling/assessments/hazard/unreached_hazard.hpp"
#include "coupling/assessments/today/assess_today.hpp"
#include "coupling/inputs/rock_count.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/messages.hpp"

namespace coupling::hazard {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// Zones with the same start share a row of hazard.blocks.
void add_rocks(const Period& period, std::vector<ZoneRocks>& list) {
    const rockfall::StartLaw common = start_law(period.scenario->release);
    std::map<const rockfall::StartLaw*, std::pair<std::set<std::uint32_t>, std::uint64_t>> of_start;
    for (const rockfall::ReleaseSource& source : period.site.sources) {
        auto& [zones, rocks] = of_start[source.own_start.get()];
        zones.insert(source.zone);
        rocks += source.rocks;
    }
    std::vector<std::pair<std::uint32_t, ZoneRocks>> by_zone;
    for (const auto& [own, entry] : of_start) {
        const auto& [zones, rocks] = entry;
        const rockfall::StartLaw& law = own != nullptr ? *own : common;
        const double diameter_m = law.diameter.mean_m();
        const bool several = zones.size() > 1;
        const std::string name =
            several ? (of_start.size() > 1 ? "others" : "all") : std::to_string(*zones.begin());
        by_zone.emplace_back(several ? std::numeric_limits<std::uint32_t>::max() : *zones.begin(),
                             ZoneRocks{.zone = name,
                                       .return_period_years = period.return_period_years,
                                       .diameter_m = diameter_m,
                                       .mass_kg = law.density_kgpm3 * std::numbers::pi / 6.0 * diameter_m *
                                                  diameter_m * diameter_m,
                                       .rocks = rocks});
    }
    std::sort(by_zone.begin(), by_zone.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [zone, rocks] : by_zone) {
        list.push_back(std::move(rocks));
    }
}

/// On the process that says for all of them that the user ended the run.
int leave_interrupted(RankGroup& ranks) {
    if (ranks.fail(true)) {
        std::fprintf(stderr,
                     "bannwald: interrupted; return periods that are finished are kept, the same command "
                     "continues after them\n");
    }
    return static_cast<int>(config::ExitCode::interrupted);
}

/// On all ranks the answer of the first one, which keeps the folder.
bool is_finished(const Period& period, const HazardFolder* folder, RankGroup& ranks) {
    const bool here =
        folder != nullptr && !folder->starts_again() && state_of(period) == FolderState::finished;
    return ranks.from_first({here ? 1U : 0U}).front() == 1;
}

/// Falls of a return period, unless they are finished. Returns the exit code.
int fall(const RunRequest& request, const Period& period, const HazardFolder* folder,
         config::Warnings& warnings, RankGroup& ranks) {
    const std::string years = config::to_text(period.return_period_years);
    if (is_finished(period, folder, ranks)) {
        if (!request.quiet) {
            std::printf("return period of %s years: finished before\n", years.c_str());
        }
        return static_cast<int>(config::ExitCode::done);
    }
    if (!request.quiet) {
        std::printf("return period of %s years\n", years.c_str());
        std::fflush(stdout);
        print_warnings(warnings, request.verbose, period.scenario->names.get());
    }
    RunRequest of_period = request;
    for (fs::path& shard : of_period.shards) {
        shard /= period.folder.filename();
    }
    const int code = assess_today(of_period, *period.scenario, period.site, warnings, period.folder, ranks);
    return code == static_cast<int>(config::ExitCode::interrupted) ? leave_interrupted(ranks) : code;
}

/// What the return periods leave for the map.
struct Gathered {
    std::optional<Period> longest;
    std::vector<FinishedPeriod> periods;
    std::vector<ZoneRocks> rocks;
    std::vector<InputFile> inputs;
    SharedWarnings warnings;
    std::optional<risk::RiskOfPeriods> risk;
};

/// Adds a return period whose results are in their place.
void gather(Gathered& gathered, Period&& period, config::Warnings of_inputs, const HazardPlan& plan,
            const Scenario& scenario) {
    const ResultsOfPeriod of_results = results_in(period.folder, scenario);
    add_unknown(of_results.warnings, of_inputs);
    warn_of_page(of_results, of_inputs);
    gathered.warnings.add(period.return_period_years, of_inputs);
    for (const InputFile& input : period.site.inputs) {
        const bool known = std::any_of(gathered.inputs.begin(), gathered.inputs.end(),
                                       [&](const InputFile& other) { return other.name == input.name; });
        if (!known) {
            gathered.inputs.push_back(input);
        }
    }
    const rockfall::StartLaw start = start_law(period.scenario->release);
    const hits::BlockRows blocks{period.site.sources, start};
    const auto hits_in = [&](const fs::path& folder) {
        return hits_of(folder, period.site, blocks, plan.matrix, scenario.hazard.energy);
    };
    const fs::path without = risk::run_without(scenario);
    gathered.periods.push_back(
        {period.return_period_years, period.folder, period.site.rocks(),
         rockfall::diameter_range(start, period.site.sources), of_results.departures, hits_in(period.folder),
         without.empty() ? HitsOfTargets{} : hits_in(without / period.folder.filename())});
    if (gathered.risk) {
        gathered.risk->add(period.folder, period.return_period_years, period.site, blocks,
                           period.scenario->run.seed);
    }
    add_rocks(period, gathered.rocks);
    gathered.longest = std::move(period);
}

std::vector<Cover> covers_of(const HazardResults& results) {
    std::vector<Cover> covers;
    for (const SlopeHazard& slope : results.slopes) {
        covers.push_back(slope.cover);
    }
    return covers;
}

/// The map of all return periods, written and printed. Throws Interrupted.
void make_map(const RunRequest& request, const Scenario& scenario, const HazardPlan& plan,
              const Gathered& gathered, const config::Warnings& of_map, HazardFolder& folder) {
    config::Warnings warnings = of_map;
    gathered.warnings.add_to(warnings);
    if (plan.risk && plan.risk->settings.curves.empty()) {
        warnings.add(consequences::shipped_curves_warning, config::Effect::answer);
    }
    const Site& site = gathered.longest->site;
    HazardResults results{.scenario = scenario,
                          .site = site,
                          .matrix = plan.matrix,
                          .periods = gathered.periods,
                          .rocks = gathered.rocks,
                          .slopes = {},
                          .arrivals = {},
                          .designs = {},
                          .barriers = barriers_of(gathered.periods, site),
                          .risk = {},
                          .inputs = gathered.inputs,
                          .warnings = warnings,
                          .version = config::version()};
    for (const Cover cover : all_covers) {
        if (cover == Cover::bare || !site.trees.empty() || !site.logs.empty()) {
            results.slopes.push_back(slope_hazard(cover, gathered.periods, scenario, site, plan.matrix));
        }
    }
    results.arrivals = arrivals_of(gathered.periods, site);
    warn_of_few_rocks(results, warnings);
    warn_of_unreached(results, warnings);
    results.designs = designs_of(gathered.periods, site, scenario.design);
    if (gathered.risk) {
        results.risk = gathered.risk->results(site, covers_of(results));
    }
    const std::vector<WrittenFile> written = folder.write_map(results, request.quiet);
    if (!request.quiet) {
        print_summary(results);
        print_files(folder.map(), written, request.verbose);
    }
    repeat_warnings(warnings, request.verbose, scenario.names.get());
}

}  // namespace

int run_hazard(const RunRequest& request, const Scenario& scenario, RankGroup& ranks) {
    const InterruptGuard guard;
    const HazardPlan plan = read_plan(scenario);
    const fs::path out = output_folder_of(request, scenario);
    std::optional<HazardFolder> kept;
    config::Warnings of_map;
    if (ranks.first()) {
        kept.emplace(request, plan, out);
        for (const std::string& left : kept->left_over()) {
            of_map.add(joined(left,
                              ": a return period that hazard.blocks no longer has; it is "
                              "left as it is and not part of the map"));
        }
        print_warnings(of_map, request.verbose, scenario.names.get());
    }
    const bool makes_map = kept && request.shard.count == 1;
    Gathered gathered;
    gathered.inputs = plan.inputs;
    for (const double each : plan.return_periods_years) {
        config::Warnings warnings;
        Period period = open_period(request, each, out, warnings);
        if (plan.risk && !gathered.risk) {
            gathered.risk.emplace(consequences::on_site(*plan.risk, period.site.targets),
                                  risk::run_without(scenario));
        }
        plausible::warn_of_rocks(*period.scenario, period.site, warnings);
        const config::Warnings of_inputs = warnings;
        if (InterruptGuard::requested()) {
            return leave_interrupted(ranks);
        }
        if (const int code = fall(request, period, kept ? &*kept : nullptr, warnings, ranks); code != 0) {
            return code;
        }
        if (makes_map) {
            gather(gathered, std::move(period), of_inputs, plan, scenario);
        }
    }
    if (makes_map) {
        try {
            make_map(request, scenario, plan, gathered, of_map, *kept);
        } catch (const Interrupted&) {
            return leave_interrupted(ranks);
        }
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling::hazard
