#include "coupling/run/staged_folder.hpp"

#include <utility>

#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/results/disk/leftovers.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

constexpr const char* staged_name = ".staged";       ///< with machine and process behind it
constexpr const char* whole_name = ".staged_whole";  ///< on the way to its place

void move_whole(const fs::path& folder) {
    for (const fs::path& entry : entries_of(folder / whole_name)) {
        move_entry(entry, folder / entry.filename());
    }
    sync_folder(folder);
    delete_entry(folder / whole_name);
}

}  // namespace

StagedFolder::StagedFolder(fs::path folder)
    : folder_{std::move(folder)},
      stage_{temporary_beside(folder_ / staged_name)},
      existed_{path_exists(folder_)} {
    make_folder(folder_);
    tidy(folder_);
    make_folder(stage_);
}

StagedFolder::~StagedFolder() {
    std::error_code ignored;
    fs::remove_all(stage_, ignored);
    if (!existed_) {
        fs::remove(folder_, ignored);  // removes an empty folder only
    }
}

void StagedFolder::publish() {
    sync_all_below(stage_);
    move_entry(stage_, folder_ / whole_name);
    sync_folder(folder_);
    move_whole(folder_);
}

void StagedFolder::tidy(const fs::path& folder) {
    if (!is_folder(folder)) {
        return;
    }
    if (is_there(folder / whole_name)) {
        move_whole(folder);
    }
    delete_leftovers_of(folder / staged_name);
}

}  // namespace coupling
