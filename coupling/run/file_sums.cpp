#include "coupling/run/file_sums.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"
#include "coupling/results/disk/checksum.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling {
namespace {

using config::joined;

namespace fs = std::filesystem;

void find_files(const fs::path& folder, const fs::path& below, std::vector<fs::path>& files) {
    for (const fs::path& entry : entries_of(folder / below)) {
        const fs::path name = below / entry.filename();
        if (name.filename().string().starts_with('.')) {
            continue;
        }
        is_folder(entry) ? find_files(folder, name, files) : files.push_back(name);
    }
}

/// "0123456789abcdef 1234": checksum and length.
std::string mark_of(const fs::path& file) {
    FileReader in{file};
    constexpr std::string_view digits = "0123456789abcdef";
    std::uint64_t sum = checksum_of(in, in.bytes()).value();
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, sum >>= 4U) {
        *digit = digits[sum & 0xFU];
    }
    return joined(text, " ", std::to_string(in.bytes()));
}

/// What `.checksums` says, by name. A line without the blanks between its parts is passed over: the file that
/// it belongs to counts as one that is not listed.
std::map<std::string, std::string> listed_marks(const fs::path& folder) {
    const std::string text = text_of_file(folder / name_of_sums);
    std::map<std::string, std::string> marks;
    for (std::string_view rest{text}; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, end);
        const std::size_t length = line.find(' ');
        const std::size_t name = length == std::string_view::npos ? length : line.find(' ', length + 1);
        if (name != std::string_view::npos) {
            marks.emplace(line.substr(name + 1), line.substr(0, name));
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return marks;
}

}  // namespace

void write_sums(const fs::path& folder) {
    std::vector<fs::path> files;
    find_files(folder, "", files);
    std::sort(files.begin(), files.end());
    OutFile out{folder / name_of_sums};
    for (const fs::path& name : files) {
        out.stream() << mark_of(folder / name) << ' ' << name.generic_string() << '\n';
    }
    out.close();
}

std::string changed_file(const fs::path& folder) {
    if (!is_there(folder / name_of_sums)) {
        return joined(name_of_sums, " is missing");
    }
    for (const auto& [name, mark] : listed_marks(folder)) {
        if (!is_there(folder / name)) {
            return joined(name, " is missing");
        }
        if (mark_of(folder / name) != mark) {
            return joined(name, " has changed");
        }
    }
    return "";
}

void refuse_changed(const fs::path& folder, const std::string& name) {
    if (!is_there(folder / name_of_sums)) {
        return;
    }
    const std::map<std::string, std::string> marks = listed_marks(folder);
    const auto mark = marks.find(name);
    if (!is_there(folder / name)) {
        if (mark != marks.end()) {
            config::fail(config::ExitCode::file, {(folder / name).string()},
                         "a file missing that its run wrote", "the results as the run wrote them",
                         "put the file back, or run the scenario again with --overwrite");
        }
        return;
    }
    if (mark == marks.end() || mark_of(folder / name) != mark->second) {
        config::fail(config::ExitCode::data, {(folder / name).string()}, "a file that changed since its run",
                     "the results as the run wrote them",
                     "put the file back as it was, or run the scenario again with --overwrite");
    }
}

}  // namespace coupling
