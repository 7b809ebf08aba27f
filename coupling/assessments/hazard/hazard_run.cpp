#include "coupling/assessments/hazard/hazard_run.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/hazard/hazard_screen.hpp"
#include "coupling/assessments/hazard/period_results.hpp"
#include "coupling/assessments/today/assess_today.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/release/zone_blocks.hpp"
#include "coupling/inputs/rock_count.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/messages.hpp"
#include "coupling/run/output_folder.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling::hazard {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// A return period, opened: its scenario and site, where its results go.
struct Period {
    double return_period_years = 0.0;
    std::unique_ptr<Scenario> scenario;
    Site site;
    fs::path folder;
};

constexpr const char* folder_prefix = "return_period_";

Period open_period(const RunRequest& request, double years, const fs::path& out, config::Warnings& warnings) {
    auto scenario = scenario_of(request.scenario, request.overrides, years, request.inputs_within);
    Site site = open_site(*scenario, warnings);
    return {years, std::move(scenario), std::move(site), out / period_folder(years)};
}

/// Leaves no folder behind that it did not find and that is empty at the end: a run may end before anything
/// is finished.
class NoEmptyFolder {
public:
    explicit NoEmptyFolder(fs::path folder) : folder_{std::move(folder)}, existed_{is_there(folder_)} {}
    ~NoEmptyFolder() {
        std::error_code ignored;
        if (!existed_) {
            fs::remove(folder_, ignored);  // removes an empty folder only
        }
    }
    NoEmptyFolder(const NoEmptyFolder&) = delete;
    NoEmptyFolder& operator=(const NoEmptyFolder&) = delete;

private:
    fs::path folder_;
    bool existed_;
};

/// One hazard run at a time in a folder; the runs of its return periods lock their own ones.
class HazardLock {
public:
    explicit HazardLock(const fs::path& out) : lock_{out / ".bannwald_hazard", FolderLock::Use::alone} {}
    ~HazardLock() { lock_.remove_file(); }
    HazardLock(const HazardLock&) = delete;
    HazardLock& operator=(const HazardLock&) = delete;

private:
    FolderLock lock_;
};

FolderState state_of(const Period& period) {
    return OutputFolder::state_of(period.folder, settings_hash(*period.scenario, period.site.inputs));
}

constexpr const char* replaced_map = ".hazard_replaced";

/// By one rename, so that a kill leaves a whole map or none.
void delete_map(const fs::path& out) {
    delete_entry(out / replaced_map);
    if (is_there(out / map_folder)) {
        move_entry(out / map_folder, out / replaced_map);
        delete_entry(out / replaced_map);
    }
}

void refuse_other_than_folder(const fs::path& out) {
    if (is_there(out) && !is_folder(out)) {
        config::fail(config::ExitCode::settings, {out.string()}, "the output folder is a file",
                     "a folder; choose another one by --out");
    }
}

/// Before any rock falls: what would be found wrong after the falls, and older results that must not lie
/// beside new ones. True if all rocks are simulated again: with --overwrite return periods that are finished
/// stay where others are not.
bool look_at_folders(const RunRequest& request, const HazardPlan& plan, const fs::path& out) {
    OutputFolder::refuse_foreign(out / map_folder);
    if (is_there(out / "summary.json")) {
        config::fail(config::ExitCode::settings, {out.string()},
                     "the output folder holds finished results of another run", "another folder by --out");
    }
    std::size_t finished_periods = 0;
    for (const double years : plan.return_periods_years) {
        config::Warnings repeated_later;
        const Period period = open_period(request, years, out, repeated_later);
        OutputFolder::refuse_foreign(period.folder);
        if (const fs::path without = risk::run_without(*period.scenario); !without.empty()) {
            risk::check_same_rocks(without / period_folder(years), *period.scenario, period.site);
        }
        const FolderState state = state_of(period);
        finished_periods += state == FolderState::finished ? 1 : 0;
        if (!request.overwrite && state == FolderState::other_settings) {
            config::fail(config::ExitCode::settings, {period.folder.string()},
                         "finished results of other settings or inputs",
                         "another folder by --out, or --overwrite to simulate it again");
        }
        if (!request.overwrite && state == FolderState::incomplete) {
            config::fail(config::ExitCode::settings, {period.folder.string()},
                         joined("results of which ", OutputFolder::damage(period.folder)),
                         "all files as the run wrote them; put it back, or --overwrite to simulate this "
                         "return period again");
        }
    }
    const bool all_finished = finished_periods == plan.return_periods_years.size();
    const bool all_anew = all_finished && request.overwrite;
    if (!all_finished || all_anew) {
        delete_map(out);  // it would show falls that are no longer there
    }
    return all_anew;
}

/// Folders of return periods that hazard.blocks no longer has.
std::vector<std::string> left_over(const HazardPlan& plan, const fs::path& out) {
    std::set<std::string> known;
    for (const double years : plan.return_periods_years) {
        known.insert(period_folder(years));
    }
    std::vector<std::string> found;
    std::error_code error;
    for (fs::directory_iterator entry{out, error}, end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(folder_prefix) && !known.contains(name) &&
            path_exists(entry->path() / "summary.json")) {
            found.push_back(name);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

Matrix read_matrix(Reading& reading) {
    const std::string& file = reading.hazard().matrix;
    return file.empty() ? Matrix::shipped() : Matrix::read(reading.table("hazard.matrix", "matrix", file));
}

/// Messages of several return periods, each sentence once with the periods that it came from.
class SharedMessages {
public:
    void add(double years, const std::string& sentence, config::Effect effect) {
        const auto known = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& entry) { return entry.sentence == sentence; });
        if (known == entries_.end()) {
            entries_.push_back({sentence, config::to_text(years), 1, effect});
        } else {
            known->years += joined(", ", config::to_text(years));
            ++known->periods;
        }
    }
    /// Calls `take` with each sentence and its effect.
    template <class Take>
    void hand_over(Take take) const {
        for (const Entry& entry : entries_) {
            take(joined(entry.sentence,
                        entry.periods == 1 ? " (return period: " : " (return periods: ", entry.years, ")"),
                 entry.effect);
        }
    }

private:
    struct Entry {
        std::string sentence;
        std::string years;
        std::size_t periods;
        config::Effect effect;
    };
    std::vector<Entry> entries_;
};

/// Warnings and notes of several return periods.
class SharedWarnings {
public:
    void add(double years, const config::Warnings& warnings) {
        for (std::size_t i = 0; i < warnings.warnings().size(); ++i) {
            warnings_.add(years, warnings.warnings()[i], warnings.effects()[i]);
        }
        for (const std::string& sentence : warnings.notes()) {
            notes_.add(years, sentence, config::Effect::detail);
        }
    }
    void add_to(config::Warnings& warnings) const {
        warnings_.hand_over(
            [&](std::string sentence, config::Effect effect) { warnings.add(std::move(sentence), effect); });
        notes_.hand_over(
            [&](std::string sentence, config::Effect) { warnings.add_note(std::move(sentence)); });
    }

private:
    SharedMessages warnings_;
    SharedMessages notes_;
};

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

int report_interruption() {
    std::fprintf(
        stderr,
        "bannwald: interrupted; return periods that are finished are kept, the same command continues "
        "after them\n");
    return static_cast<int>(config::ExitCode::interrupted);
}

/// Falls of a return period, unless they are finished. Returns the exit code.
int fall(const RunRequest& request, Period& period, bool again, config::Warnings& warnings) {
    const std::string years = config::to_text(period.return_period_years);
    if (!again && state_of(period) == FolderState::finished) {
        if (!request.quiet) {
            std::printf("return period of %s years: finished before\n", years.c_str());
        }
        return static_cast<int>(config::ExitCode::done);
    }
    if (!request.quiet) {
        std::printf("return period of %s years\n", years.c_str());
        std::fflush(stdout);
        print_warnings(warnings, request.verbose);
    }
    const int code = assess_today(request, *period.scenario, period.site, warnings, period.folder);
    if (code == static_cast<int>(config::ExitCode::interrupted)) {
        return report_interruption();
    }
    return code;
}

/// An older map stays until the new one is whole.
std::vector<WrittenFile> write_map(const HazardResults& results, const fs::path& out, bool quiet) {
    const fs::path fresh = out / ".hazard";
    std::vector<WrittenFile> written;
    {
        OutputFolder folder{fresh, settings_hash(results.scenario, results.inputs), true};
        written = publish_results(folder, results.scenario, quiet,
                                  [&](const fs::path& staging, const WriteWatch& watch) {
                                      return write_results(results, staging, watch);
                                  });
    }
    delete_entry(out / replaced_map);
    if (is_there(out / map_folder)) {
        move_entry(out / map_folder, out / replaced_map);
    }
    move_entry(fresh, out / map_folder);
    sync_folder(out);
    delete_entry(out / replaced_map);
    return written;
}

std::vector<Cover> covers_of(const HazardResults& results) {
    std::vector<Cover> covers;
    for (const SlopeHazard& slope : results.slopes) {
        covers.push_back(slope.cover);
    }
    return covers;
}

}  // namespace

std::string period_folder(double return_period_years) {
    return joined(folder_prefix, config::to_text(return_period_years));
}

HazardPlan read_plan(const Scenario& scenario) {
    config::Warnings ignored;  // the sites of the return periods print them
    Reading reading{scenario, ignored};
    return scenario.with_paths([&] {
        HazardPlan plan{return_periods_of(read_zone_blocks(reading)), read_matrix(reading), {}, {}};
        if (scenario.risk.assess) {
            plan.risk = consequences::read_risk_plan(reading, scenario.risk);
        }
        reading.finish();
        plan.inputs = reading.inputs();
        return plan;
    });
}

std::unique_ptr<Scenario> scenario_of(const fs::path& file, std::vector<std::string> overrides,
                                      double return_period_years, const fs::path& inputs_within) {
    overrides.push_back(joined("hazard.return_period_years=", config::to_text(return_period_years)));
    return read_scenario(file, overrides, inputs_within);
}

int run_hazard(const RunRequest& request, const Scenario& scenario) {
    const InterruptGuard guard;
    const HazardPlan plan = read_plan(scenario);
    const fs::path out = output_folder_of(request, scenario);
    const NoEmptyFolder tidy{out};
    refuse_other_than_folder(out);
    make_folder(out);
    const HazardLock lock{out};
    const bool all_anew = look_at_folders(request, plan, out);
    config::Warnings of_map;
    for (const std::string& folder : left_over(plan, out)) {
        of_map.add(joined(folder,
                          ": a return period that hazard.blocks no longer has; it is "
                          "left as it is and not part of the map"));
    }
    print_warnings(of_map, request.verbose);

    std::optional<Period> longest;
    std::vector<FinishedPeriod> periods;
    std::vector<ZoneRocks> rocks;
    std::vector<InputFile> inputs = plan.inputs;
    SharedWarnings shared;
    std::optional<risk::RiskOfPeriods> risk;
    for (const double each : plan.return_periods_years) {
        config::Warnings warnings;
        Period period = open_period(request, each, out, warnings);
        if (plan.risk && !risk) {
            risk.emplace(consequences::on_site(*plan.risk, period.site.targets), risk::run_without(scenario));
        }
        plausible::warn_of_rocks(*period.scenario, period.site, warnings);
        config::Warnings of_inputs = warnings;
        if (InterruptGuard::requested()) {
            return report_interruption();
        }
        if (const int code = fall(request, period, all_anew, warnings); code != 0) {
            return code;
        }
        const ResultsOfPeriod of_results = results_in(period.folder);
        add_unknown(of_results.warnings, of_inputs);
        shared.add(each, of_inputs);
        for (const InputFile& input : period.site.inputs) {
            const bool known = std::any_of(inputs.begin(), inputs.end(),
                                           [&](const InputFile& other) { return other.name == input.name; });
            if (!known) {
                inputs.push_back(input);
            }
        }
        const hits::BlockRows blocks{period.site.sources, start_law(period.scenario->release)};
        periods.push_back({each, period.folder, period.site.rocks(),
                           rockfall::diameter_range(start_law(period.scenario->release), period.site.sources),
                           of_results.departures,
                           hits_of(period.folder, period.site, blocks, plan.matrix, scenario.hazard.energy)});
        if (risk) {
            risk->add(period.folder, each, period.site, blocks);
        }
        add_rocks(period, rocks);
        longest = std::move(period);
    }

    config::Warnings all_warnings = of_map;
    shared.add_to(all_warnings);
    if (plan.risk && plan.risk->settings.curves.empty()) {
        all_warnings.add(consequences::shipped_curves_warning, config::Effect::answer);
    }
    HazardResults results{.scenario = scenario,
                          .site = longest->site,
                          .matrix = plan.matrix,
                          .periods = periods,
                          .rocks = rocks,
                          .slopes = {},
                          .arrivals = {},
                          .designs = {},
                          .barriers = barriers_of(periods, longest->site),
                          .risk = {},
                          .inputs = inputs,
                          .warnings = all_warnings,
                          .version = config::version()};
    for (const Cover cover : all_covers) {
        if (cover == Cover::bare || !longest->site.trees.empty() || !longest->site.logs.empty()) {
            results.slopes.push_back(slope_hazard(cover, periods, scenario, longest->site, plan.matrix));
        }
    }
    results.arrivals = arrivals_of(periods, longest->site);
    warn_of_few_rocks(results, all_warnings);
    results.designs = designs_of(periods, longest->site, scenario.design);
    if (risk) {
        results.risk = risk->results(longest->site, covers_of(results));
    }
    std::vector<WrittenFile> written;
    try {
        written = write_map(results, out, request.quiet);
    } catch (const Interrupted&) {
        return report_interruption();
    }
    if (!request.quiet) {
        print_summary(results);
        print_files(out / map_folder, written, request.verbose);
    }
    repeat_warnings(all_warnings, request.verbose);
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling::hazard
