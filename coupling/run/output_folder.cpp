#include "coupling/run/output_folder.hpp"

#include <array>
#include <fstream>
#include <iterator>

#include "config/errors/input_error.hpp"
#include "coupling/results/joined.hpp"
#include "coupling/results/out_file.hpp"
#include "coupling/run/checkpoint.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

/// Everything that a run puts into its folder.
constexpr std::array run_writes{"report.html",      "summary.json", "results.gpkg", "results.qlr",
                                "trajectories.vtp", "rasters",      "tables",       "parts",
                                "net_paths.bin",    ".writing"};

/// Says that a run of this program keeps the folder: without it nothing in there is ours to delete.
constexpr const char* mark_of_a_run = ".bannwald";

/// Written last, so its presence says that results are whole.
constexpr const char* mark_of_results = "summary.json";

std::string mark_text(const std::string& settings_hash) {
    return joined("Results of a run of bannwald; bannwald may replace them.\nsettings ", settings_hash, "\n");
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, const std::string& settings_hash, bool overwrite)
    : folder_{std::move(folder)}, existed_{fs::exists(folder_)} {
    refuse_foreign(folder_);
    if (overwrite) {
        delete_results();
    }
    if (fs::exists(folder_ / mark_of_results)) {
        config::fail(config::ExitCode::settings, {folder_.string()},
                     "the output folder holds finished results",
                     "another folder by --out, or --overwrite to replace them");
    }
    const auto hash = checkpoint_hash(checkpoint());
    if (hash && *hash != settings_hash) {
        config::fail(
            config::ExitCode::settings, {folder_.string()},
            "the output folder holds parts of a run with other settings or inputs",
            "the same settings to go on with it, another folder by --out, or --overwrite to begin anew");
    }
    has_parts_ = hash.has_value();
    delete_entry(staging());  // left by a run that was killed while it wrote
    make_folder(folder_);
    OutFile mark{folder_ / mark_of_a_run};
    mark.stream() << mark_text(settings_hash);
    mark.close();
    make_folder(parts());  // after the mark: a run that is killed here can still be repeated
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    fs::remove_all(staging(), ignored);
    if (published_ || !fs::exists(checkpoint(), ignored)) {
        fs::remove_all(parts(), ignored);
        if (!published_) {
            fs::remove(folder_ / mark_of_a_run, ignored);
        }
        if (!existed_ && !published_) {
            fs::remove(folder_, ignored);  // removes an empty folder only
        }
    }
}

void OutputFolder::refuse_foreign(const fs::path& folder) {
    if (fs::exists(folder) && !fs::is_directory(folder)) {
        config::fail(config::ExitCode::settings, {folder.string()}, "the output folder is a file",
                     "a folder");
    }
    if (fs::exists(folder / mark_of_a_run)) {
        return;
    }
    for (const char* name : run_writes) {
        // The mark again: another process of the same run may have put it there in the meantime.
        if (fs::exists(folder / name) && !fs::exists(folder / mark_of_a_run)) {
            config::fail(config::ExitCode::settings, {(folder / name).string()},
                         "the output folder holds something of this name that no run wrote",
                         "another folder by --out");
        }
    }
}

void OutputFolder::delete_results() const {
    for (const char* name : run_writes) {
        delete_entry(folder_ / name);
    }
}

bool OutputFolder::is_finished(const fs::path& folder, const std::string& settings_hash) {
    std::ifstream mark{folder / mark_of_a_run};
    const std::string text{std::istreambuf_iterator<char>{mark}, {}};
    return text == mark_text(settings_hash) && fs::exists(folder / mark_of_results);
}

void OutputFolder::publish() {
    const auto move = [&](const fs::path& name) {
        std::error_code error;
        fs::remove_all(folder_ / name, error);
        fs::rename(staging() / name, folder_ / name, error);
        if (error) {
            config::fail(config::ExitCode::file, {(folder_ / name).string()},
                         "cannot be moved to its place: " + error.message());
        }
    };
    for (const fs::directory_entry& entry : fs::directory_iterator{staging()}) {
        if (entry.path().filename() != mark_of_results) {
            move(entry.path().filename());
        }
    }
    move(mark_of_results);
    published_ = true;
}

}  // namespace coupling
