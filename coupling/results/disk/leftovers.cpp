#include "coupling/results/disk/leftovers.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <string>
#include <string_view>

#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

/// Whether a process of this machine has ended. One with the number of this process has: this one has made
/// nothing yet.
bool has_ended(pid_t process) {
    return process == getpid() || (::kill(process, 0) != 0 && errno == ESRCH);
}

}  // namespace

std::vector<fs::path> leftovers_of(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
    std::vector<fs::path> found;
    if (!is_folder(folder)) {
        return found;
    }
    constexpr std::string_view ending = ".tmp";
    const std::string own = temporary_beside(file).filename().string();
    const std::string begin = own.substr(0, own.rfind('.', own.size() - ending.size() - 1) + 1);
    for (const fs::path& entry : entries_of(folder)) {
        const std::string name = entry.filename().string();
        if (!name.starts_with(begin)) {
            continue;
        }
        // Libraries add letters of their own behind the ending.
        pid_t process = 0;
        const char* const last = name.data() + name.size();
        const auto [end, error] = std::from_chars(name.data() + begin.size(), last, process);
        if (error == std::errc{} && process > 0 &&
            std::string_view{end, static_cast<std::size_t>(last - end)}.starts_with(ending) &&
            has_ended(process)) {
            found.push_back(entry);
        }
    }
    return found;
}

void delete_leftovers_of(const fs::path& file) {
    for (const fs::path& left : leftovers_of(file)) {
        delete_entry(left);
    }
}

}  // namespace coupling
