#include "coupling/results/pack/manifest.hpp"

#include <algorithm>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"

namespace coupling::pack {

std::string manifest_text(const std::vector<ListedFile>& files) {
    std::string text;
    for (const ListedFile& file : files) {
        text += config::joined(file.sha256, "  ", file.name, "\n");
    }
    return text;
}

std::vector<ListedFile> read_manifest(std::string_view text, const std::string& file) {
    constexpr std::size_t digits = 64;
    std::vector<ListedFile> files;
    std::size_t line = 0;
    while (!text.empty()) {
        ++line;
        const std::size_t end = text.find('\n');
        const std::string_view row = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
        if (row.size() < digits + 3 || row.substr(digits, 2) != "  " ||
            !std::all_of(row.begin(), row.begin() + digits, is_digit)) {
            config::fail(config::ExitCode::data,
                         {.file = config::joined(file, ", ", manifest_name), .line = line},
                         config::in_quotes(row), "64 hexadecimal digits, two blanks and a name");
        }
        files.push_back({std::string{row.substr(digits + 2)}, std::string{row.substr(0, digits)}});
    }
    return files;
}

}  // namespace coupling::pack
