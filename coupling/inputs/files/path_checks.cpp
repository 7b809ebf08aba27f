#include "coupling/inputs/files/path_checks.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>

#include "config/errors/input_error.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

/// What the user can do about it.
const char* expected_instead_of(const std::error_code& error) {
    if (error == std::errc::filename_too_long) {
        return "a shorter name";
    }
    if (error == std::errc::too_many_symbolic_link_levels) {
        return "a name whose symbolic links lead to a file or folder";
    }
    if (error == std::errc::permission_denied) {
        return "a name in folders that you may enter and read";
    }
    return "a file or folder that can be read; check the disk and its connection";
}

[[noreturn]] void fail_to_look_up(const fs::path& path, const std::string& what,
                                  const std::error_code& error) {
    config::fail(config::ExitCode::file, {.file = path.string()}, what + ": " + error.message(),
                 expected_instead_of(error));
}

/// The type in an answer of the file system, unless there was none.
fs::file_type answered_type(const fs::path& path, const fs::file_status& status,
                            const std::error_code& error) {
    if (status.type() == fs::file_type::none || status.type() == fs::file_type::unknown) {
        fail_to_look_up(path, "a name that cannot be looked up", error);
    }
    return status.type();
}

fs::file_type type_behind_links(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return answered_type(path, status, error);
}

}  // namespace

bool path_exists(const fs::path& path) {
    return type_behind_links(path) != fs::file_type::not_found;
}

bool is_there(const fs::path& entry) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(entry, error);
    return answered_type(entry, status, error) != fs::file_type::not_found;
}

bool is_folder(const fs::path& path) {
    return type_behind_links(path) == fs::file_type::directory;
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

bool is_empty_folder(const fs::path& folder) {
    return entries_of(folder).empty();
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
        entries.push_back(entry->path());
    }
    if (error) {
        fail_to_look_up(folder, "a folder that cannot be read", error);
    }
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::uintmax_t bytes_of_file(const fs::path& file) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (error) {
        fail_to_look_up(file, "a file whose length cannot be read", error);
    }
    return bytes;
}

void cut_file(const fs::path& file, std::uintmax_t bytes) {
    std::error_code error;
    fs::resize_file(file, bytes, error);
    if (error) {
        config::fail(config::ExitCode::file, {.file = file.string()}, "cannot be cut: " + error.message(),
                     "a file that can be written");
    }
}

std::string path_in_quotes(const fs::path& path) {
    std::string shown = "'" + path.string() + "'";
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char byte) { return byte < 0x20 || byte == 0x7F; }, '?');
    return shown;
}

std::string advice_on_missing(const std::filesystem::path& path) {
    std::string text = path.string();
    // "a.gpkg,b.gpkg": a name before the comma and one behind it.
    if (const std::size_t comma = text.find(',');
        comma != std::string::npos && comma + 1 < text.size() && text[comma + 1] != ' ' &&
        std::filesystem::path{text.substr(0, comma)}.has_extension() &&
        std::filesystem::path{text.substr(comma + 1)}.has_extension()) {
        return "if these are several files, write a blank behind each comma";
    }
    const auto is_letter = [&](std::size_t place) {
        return std::isalpha(static_cast<unsigned char>(text[place])) != 0;
    };
    for (std::size_t colon = text.find(':'); colon != std::string::npos; colon = text.find(':', colon + 1)) {
        const bool is_drive = colon > 0 && is_letter(colon - 1) && (colon == 1 || text[colon - 2] == '/') &&
                              colon + 1 < text.size() && (text[colon + 1] == '\\' || text[colon + 1] == '/');
        if (is_drive) {
            std::string here = text.substr(colon - 1);
            std::replace(here.begin(), here.end(), '\\', '/');
            here[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(here[0])));
            return "this is a path of Windows: write it as this system has it, under WSL /mnt/" +
                   here.substr(0, 1) + here.substr(2);
        }
    }
    if (text.find('\\') == std::string::npos) {
        return "";
    }
    return "this is a path of Windows: write / instead of \\";
}

}  // namespace coupling
