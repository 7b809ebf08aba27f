#include "validation/engine/result_folder.hpp"

#include "config/errors/input_error.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "validation/engine/write_results.hpp"

namespace coupling::validation {

namespace {

namespace fs = std::filesystem;

/// Says that a validation keeps the folder: without it nothing in there is ours to delete.
constexpr const char* mark_name = ".bannwald-validation";

}  // namespace

ResultFolder::ResultFolder(fs::path folder, bool overwrite)
    : folder_{std::move(folder)}, existed_{path_exists(folder_)} {
    if (existed_ && !is_folder(folder_)) {
        config::fail(config::ExitCode::settings, {folder_.string()}, "the output folder is a file",
                     "a folder");
    }
    was_ours_ = path_exists(folder_ / mark_name);
    for (const std::string& name : result_names()) {
        if (!path_exists(folder_ / name)) {
            continue;
        }
        if (!was_ours_) {
            config::fail(config::ExitCode::settings, {(folder_ / name).string()},
                         "the output folder holds something of this name that no validation wrote",
                         "another folder by --out");
        }
        if (!overwrite) {
            config::fail(config::ExitCode::settings, {folder_.string()},
                         "the output folder holds results of a validation",
                         "another folder by --out, or --overwrite to replace them");
        }
    }
    make_folder(folder_);
    OutFile mark{folder_ / mark_name};
    mark.stream() << "Results of bannwald validate, which may replace them.\n";
    mark.close();
    delete_entry(staging());  // left by a validation that was killed while it wrote
    make_folder(staging());
}

ResultFolder::~ResultFolder() {
    std::error_code ignored;
    fs::remove_all(staging(), ignored);
    if (!published_ && !was_ours_) {
        fs::remove(folder_ / mark_name, ignored);
        if (!existed_) {
            fs::remove(folder_, ignored);  // removes an empty folder only
        }
    }
}

void ResultFolder::publish() {
    for (const std::string& name : result_names()) {
        delete_entry(folder_ / name);
    }
    for (const std::string& name : result_names()) {
        if (!path_exists(staging() / name)) {
            continue;
        }
        std::error_code error;
        fs::rename(staging() / name, folder_ / name, error);
        if (error) {
            config::fail(config::ExitCode::file, {(folder_ / name).string()},
                         "cannot be moved to its place: " + error.message());
        }
    }
    published_ = true;
}

}  // namespace coupling::validation
