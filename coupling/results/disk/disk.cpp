#include "coupling/results/disk/disk.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/own_files/system_calls.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_at(const fs::path& entry, const char* what, const std::error_code& error) {
    config::fail(config::ExitCode::file, {entry.string()}, std::string{what} + ": " + error.message());
}

std::error_code last_error() {
    return {errno, std::generic_category()};
}

void sync_entry(const fs::path& entry, int kind) {
    const int descriptor = repeated([&] { return ::open(entry.c_str(), O_RDONLY | O_CLOEXEC | kind); });
    if (descriptor < 0 && errno == EACCES && kind == O_DIRECTORY) {
        return;
    }
    if (descriptor < 0) {
        fail_at(entry, "cannot be opened", last_error());
    }
    const bool failed = repeated([&] { return ::fsync(descriptor); }) != 0;
    const std::error_code error = last_error();
    ::close(descriptor);
    // Some file systems cannot do it for folders, and say so by EINVAL.
    if (failed && error.value() != EINVAL && error.value() != ENOTSUP) {
        fail_at(entry, "cannot be written to the disk", error);
    }
}

/// How file systems without second names answer.
bool offers_no_links(const std::error_code& error) {
    constexpr std::array answers{EPERM, ENOTSUP, EOPNOTSUPP, ENOSYS, EMLINK, EXDEV};
    return std::find(answers.begin(), answers.end(), error.value()) != answers.end();
}

}  // namespace

void sync_file(const fs::path& file) {
    sync_entry(file, 0);
}

void sync_folder(const fs::path& folder) {
    sync_entry(folder, O_DIRECTORY);
}

void sync_all_below(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
        const fs::file_status status = entry->symlink_status(error);
        if (error) {
            fail_at(entry->path(), "cannot be examined", error);
        }
        if (status.type() == fs::file_type::directory) {
            sync_all_below(entry->path());
        } else if (status.type() == fs::file_type::regular) {
            sync_file(entry->path());
        }
    }
    if (error) {
        fail_at(folder, "cannot be read", error);
    }
    sync_folder(folder);
}

void move_entry(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) {
        fail_at(to, "cannot be moved to its place", error);
    }
}

void link_or_copy(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::create_hard_link(from, to, error);
    if (error && offers_no_links(error)) {
        error.clear();
        fs::copy_file(from, to, error);
    }
    if (error) {
        fail_at(to, "cannot be made", error);
    }
}

}  // namespace coupling
