#include "coupling/run/output_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/file_sums.hpp"

namespace coupling {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// Says that a run of this program keeps the folder: without it nothing in there is ours to delete.
constexpr const char* mark_of_a_run = ".bannwald";

/// Comes to its place last, so its presence says that results are whole.
constexpr const char* mark_of_results = "summary.json";

/// Everything else that a run puts into its folder.
constexpr std::array run_writes{"report.html",   "results.gpkg", "results.qlr",  "trajectories.vtp",
                                "rasters",       "tables",       "shapefiles",   "results.kmz",
                                "net_paths.bin", "results.gpx",  "results.xlsx", name_of_sums};
constexpr std::array run_works_in{"parts", "members", ".writing", ".complete", ".deleted"};

std::string mark_text(const std::string& settings_hash) {
    return joined("Results of a run of bannwald; bannwald may replace them.\nsettings ", settings_hash, "\n");
}

std::vector<fs::path> names_in(const fs::path& folder) {
    std::vector<fs::path> names;
    std::error_code error;
    for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
        names.push_back(entry->path().filename());
    }
    if (error) {
        config::fail(config::ExitCode::file, {folder.string()}, "cannot be read: " + error.message());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// False where that cannot be found out: what may be there is kept.
bool surely_missing(const fs::path& entry) noexcept {
    std::error_code ignored;
    return fs::symlink_status(entry, ignored).type() == fs::file_type::not_found;
}

/// A file that summary.json lists and that is not there, in words; "" if there is none.
std::string missing_file(const fs::path& folder) {
    const fs::path summary = folder / mark_of_results;
    const std::string text = text_of_file(summary);
    try {
        for (const std::string& file : files_in_summary(text, summary.string())) {
            if (!is_there(folder / file)) {
                return joined(file, " is missing");
            }
        }
    } catch (const config::InputError&) {
        return joined(mark_of_results, " has changed");
    }
    return "";
}

[[noreturn]] void refuse_finished(const fs::path& folder) {
    const std::string missing = missing_file(folder);
    config::fail(config::ExitCode::settings, {folder.string()},
                 missing.empty() ? "the output folder holds finished results"
                                 : joined("the output folder holds results of which ", missing),
                 "another folder by --out, or --overwrite to replace them");
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, const std::string& settings_hash, bool overwrite,
                           FolderLock::Use use)
    : folder_{std::move(folder)}, existed_{is_there(folder_)} {
    refuse_foreign(folder_);
    make_folder(folder_);
    try {
        lock_.emplace(folder_ / mark_of_a_run, use);
        if (lock_->is_alone()) {
            prepare(settings_hash, overwrite);
        } else {
            join(settings_hash, overwrite);
        }
        if (use == FolderLock::Use::shared) {
            lock_->share();
        }
    } catch (...) {
        tidy_up();
        throw;
    }
}

OutputFolder::~OutputFolder() {
    tidy_up();
}

/// Deletes what is worth nothing. Reports no error: a later start meets what stays and answers it.
void OutputFolder::tidy_up() noexcept {
    std::error_code ignored;
    if (lock_ && lock_->try_alone()) {
        fs::remove_all(staging(), ignored);
        if (surely_missing(checkpoint()) && surely_missing(folder_ / mark_of_results) &&
            surely_missing(complete())) {
            fs::remove_all(parts(), ignored);
            const auto is_gone = [&](const char* name) { return surely_missing(folder_ / name); };
            if (std::all_of(run_writes.begin(), run_writes.end(), is_gone) &&
                std::all_of(run_works_in.begin(), run_works_in.end(), is_gone)) {
                lock_->remove_file();
            }
        }
    }
    if (!existed_) {
        fs::remove(folder_, ignored);  // removes an empty folder only
    }
}

void OutputFolder::refuse_foreign(const fs::path& folder) {
    if (is_there(folder) && !is_folder(folder)) {
        config::fail(config::ExitCode::settings, {folder.string()}, "the output folder is a file",
                     "a folder; choose another one by --out");
    }
    const auto refuse = [&](const char* name) {
        // The mark again: another process of the same run may have put it there in the meantime.
        if (is_there(folder / name) && !is_there(folder / mark_of_a_run)) {
            config::fail(config::ExitCode::settings, {(folder / name).string()},
                         "the output folder holds something of this name that no run wrote",
                         "another folder by --out");
        }
    };
    if (!is_there(folder / mark_of_a_run)) {
        refuse(mark_of_results);
        std::for_each(run_writes.begin(), run_writes.end(), refuse);
        std::for_each(run_works_in.begin(), run_works_in.end(), refuse);
    }
}

/// Alone in the folder.
void OutputFolder::prepare(const std::string& settings_hash, bool overwrite) {
    delete_set_aside();
    if (overwrite) {
        set_aside_results();
    } else if (is_there(complete())) {
        was_completed_ = lock_->text() == mark_text(settings_hash);
        move_results_to_their_place();
    }
    if (was_completed_) {
        return;
    }
    refuse_results_and_other_parts(settings_hash);
    take_over(settings_hash);
}

/// Beside other shards that are at work.
void OutputFolder::join(const std::string& settings_hash, bool overwrite) {
    if (overwrite) {
        config::fail(config::ExitCode::settings, {folder_.string()},
                     "other shards are at work in this folder; --overwrite would delete their parts",
                     "the same command without --overwrite, or another folder by --out");
    }
    if (lock_->text() != mark_text(settings_hash)) {
        config::fail(config::ExitCode::settings, {folder_.string()},
                     "shards of a run with other settings or inputs are at work in this folder",
                     "the same settings for all shards, or another folder by --out");
    }
    refuse_results_and_other_parts(settings_hash);
}

void OutputFolder::refuse_results_and_other_parts(const std::string& settings_hash) {
    if (is_there(folder_ / mark_of_results)) {
        refuse_finished(folder_);
    }
    const auto hash = checkpoint_hash(checkpoint());
    if (hash && *hash != settings_hash) {
        config::fail(config::ExitCode::settings, {folder_.string()},
                     "the output folder holds parts of a run with other settings or inputs",
                     "the same settings to go on with it, another folder by --out, or --overwrite to start "
                     "from the beginning");
    }
    has_parts_ = hash.has_value();
}

/// Makes the folder that of this run. What a killed run was writing, or an older program left half-moved,
/// goes.
void OutputFolder::take_over(const std::string& settings_hash) {
    delete_entry(staging());
    for (const char* name : run_writes) {
        set_aside(name);
    }
    delete_set_aside();
    if (const std::string mark = mark_text(settings_hash); lock_->text() != mark) {
        lock_->write_text(mark);
    }
    make_folder(parts());  // after the mark: a run that is killed here can still be repeated
    for (const fs::path& name : names_in(parts())) {
        if (name.extension() == ".tmp") {
            delete_entry(parts() / name);
        }
    }
    sync_folder(folder_);
    if (!existed_) {
        sync_folder(folder_.has_parent_path() ? folder_.parent_path() : fs::path{"."});
    }
}

/// One rename each, so that a kill leaves nothing half-deleted. First what would put results in their place,
/// then what says that they are whole.
void OutputFolder::set_aside_results() {
    set_aside(complete().filename());
    set_aside(mark_of_results);
    set_aside(parts().filename());
    for (const char* name : run_writes) {
        set_aside(name);
    }
    delete_set_aside();
}

void OutputFolder::set_aside(const fs::path& name) {
    if (is_there(folder_ / name)) {
        make_folder(deleted());
        move_entry(folder_ / name, deleted() / name);
    }
}

void OutputFolder::delete_set_aside() {
    delete_entry(deleted());
}

std::string OutputFolder::damage(const fs::path& folder) {
    const std::string missing = missing_file(folder);
    return missing.empty() ? changed_file(folder) : missing;
}

FolderState OutputFolder::state_of(const fs::path& folder, const std::string& settings_hash) {
    if (is_there(folder / ".complete")) {
        return FolderState::being_published;
    }
    if (!is_there(folder / mark_of_results)) {
        return FolderState::nothing;
    }
    if (!is_there(folder / mark_of_a_run) ||
        text_of_file(folder / mark_of_a_run) != mark_text(settings_hash)) {
        return FolderState::other_settings;
    }
    return damage(folder).empty() ? FolderState::finished : FolderState::incomplete;
}

void OutputFolder::publish() {
    write_sums(staging());
    sync_all_below(staging());
    move_entry(staging(), complete());
    sync_folder(folder_);
    move_results_to_their_place();
}

/// Each entry by one rename, so that this can be repeated from wherever it ended. While .complete is there it
/// is not through.
void OutputFolder::move_results_to_their_place() {
    const auto move = [&](const fs::path& name) {
        set_aside(name);
        move_entry(complete() / name, folder_ / name);
    };
    for (const fs::path& name : names_in(complete())) {
        if (name != mark_of_results) {
            move(name);
        }
    }
    if (is_there(complete() / mark_of_results)) {
        sync_folder(folder_);
        move(mark_of_results);
    }
    sync_folder(folder_);
    set_aside(parts().filename());
    delete_set_aside();
    delete_entry(complete());
}

void print_completed(const OutputFolder& folder) {
    std::printf("Results in %s: an earlier start had finished them, they are in their place now\n",
                folder.path().string().c_str());
}

}  // namespace coupling
