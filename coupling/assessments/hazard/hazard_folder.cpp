#include "coupling/assessments/hazard/hazard_folder.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/run/assessment.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
namespace fs = std::filesystem;

constexpr const char* replaced_map = ".hazard_replaced";

void refuse_other_than_folder(const fs::path& out) {
    if (is_there(out) && !is_folder(out)) {
        config::fail(config::ExitCode::settings, {out.string()}, "the output folder is a file",
                     "a folder; choose another one by --out");
    }
}

}  // namespace

Period open_period(const RunRequest& request, double years, const fs::path& out, config::Warnings& warnings) {
    auto scenario = scenario_of(request.scenario, request.overrides, years, request.inputs_within);
    Site site = open_site(*scenario, warnings);
    return {years, std::move(scenario), std::move(site), out / period_folder(years)};
}

FolderState state_of(const Period& period) {
    return OutputFolder::state_of(period.folder, settings_hash(*period.scenario, period.site.inputs));
}

HazardFolder::Made::Made(fs::path folder) : folder_{std::move(folder)}, existed_{is_there(folder_)} {}

HazardFolder::Made::~Made() {
    std::error_code ignored;
    if (!existed_) {
        fs::remove(folder_, ignored);  // removes an empty folder only
    }
}

HazardFolder::Lock::Lock(const fs::path& out, FolderLock::Use use) : lock_{out / ".bannwald_hazard", use} {}

HazardFolder::Lock::~Lock() {
    if (lock_.try_alone()) {
        lock_.remove_file();
    }
}

HazardFolder::HazardFolder(const RunRequest& request, const HazardPlan& plan, fs::path out)
    : plan_{plan}, out_{std::move(out)}, made_{out_} {
    const bool is_shard = request.shard.count > 1;
    refuse_other_than_folder(out_);
    make_folder(out_);
    lock_.emplace(out_, is_shard ? FolderLock::Use::shared : FolderLock::Use::alone);
    if (is_shard && request.overwrite && !lock_->is_alone()) {
        config::fail(config::ExitCode::settings, {out_.string()},
                     "other shards are at work in this folder; --overwrite would delete their parts",
                     "the same command without --overwrite, or another folder by --out");
    }
    OutputFolder::refuse_foreign(out_ / map_folder);
    if (is_there(out_ / "summary.json")) {
        config::fail(config::ExitCode::settings, {out_.string()},
                     "the output folder holds finished results of another run", "another folder by --out");
    }
    starts_again_ = look_at_periods(request);
    if (is_shard) {
        lock_->share();
    }
}

/// Whether all rocks are simulated again.
bool HazardFolder::look_at_periods(const RunRequest& request) {
    std::size_t finished_periods = 0;
    for (const double years : plan_.return_periods_years) {
        config::Warnings repeated_later;
        const Period period = open_period(request, years, out_, repeated_later);
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
    const bool all_finished = finished_periods == plan_.return_periods_years.size();
    const bool all_again = all_finished && request.overwrite;
    if (!all_finished || all_again) {
        delete_map();  // it would show falls that are no longer there
    }
    return all_again;
}

/// By one rename, so that a kill leaves a whole map or none.
void HazardFolder::delete_map() const {
    delete_entry(out_ / replaced_map);
    if (is_there(out_ / map_folder)) {
        move_entry(out_ / map_folder, out_ / replaced_map);
        delete_entry(out_ / replaced_map);
    }
}

std::vector<std::string> HazardFolder::left_over() const {
    std::set<std::string> known;
    for (const double years : plan_.return_periods_years) {
        known.insert(period_folder(years));
    }
    std::vector<std::string> found;
    std::error_code error;
    for (fs::directory_iterator entry{out_, error}, end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(period_prefix) && !known.contains(name) &&
            path_exists(entry->path() / "summary.json")) {
            found.push_back(name);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<WrittenFile> HazardFolder::write_map(const HazardResults& results, bool quiet) {
    const fs::path fresh = out_ / ".hazard";
    std::vector<WrittenFile> written;
    {
        OutputFolder folder{fresh, settings_hash(results.scenario, results.inputs), true};
        written = publish_results(folder, results.scenario, quiet,
                                  [&](const fs::path& staging, const WriteWatch& watch) {
                                      return write_results(results, staging, watch);
                                  });
    }
    delete_entry(out_ / replaced_map);
    if (is_there(out_ / map_folder)) {
        move_entry(out_ / map_folder, out_ / replaced_map);
    }
    move_entry(fresh, out_ / map_folder);
    sync_folder(out_);
    delete_entry(out_ / replaced_map);
    return written;
}

}  // namespace coupling::hazard
