#include "coupling/inputs/files/files_beside.hpp"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "config/text/reading.hpp"
#include "coupling/inputs/files/path_checks.hpp"

namespace coupling {

namespace {

namespace fs = std::filesystem;

/// The name itself, in capitals where the ending of the file is.
fs::path written_beside(fs::path file, std::string ending) {
    if (ending.starts_with('-')) {
        return file += ending;
    }
    if (config::in_lower_case(file.extension().string()) == ".gz") {
        file.replace_extension();
    }
    const std::string own = file.extension().string();
    if (own.size() > 1 && std::isupper(static_cast<unsigned char>(own[1])) != 0) {
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
    return file.replace_extension(ending);
}

}  // namespace

fs::path path_beside(const fs::path& file, const std::string& ending) {
    fs::path wanted = written_beside(file, ending);
    if (ending.starts_with('-') || path_exists(wanted)) {
        return wanted;  // the log of a database has its very name
    }
    const std::string name = config::in_lower_case(wanted.filename().string());
    const fs::path folder = wanted.parent_path();
    std::error_code unreadable;  // a folder that may not be listed can still be read from
    fs::path found;
    for (fs::directory_iterator entry{folder.empty() ? fs::path{"."} : folder, unreadable};
         !unreadable && entry != fs::directory_iterator{}; entry.increment(unreadable)) {
        const fs::path other = entry->path().filename();
        if (config::in_lower_case(other.string()) == name && (found.empty() || other < found)) {
            found = other;
        }
    }
    return found.empty() ? wanted : folder / found;
}

formats::BytesBeside FilesBeside::bytes() {
    return [this](const std::string& ending) -> std::string_view {
        const fs::path wanted = path(ending);
        if (!path_exists(wanted)) {
            return {};
        }
        open_.push_back(open_file(wanted, {}, "a readable file"));
        return open_.back().text();
    };
}

}  // namespace coupling
