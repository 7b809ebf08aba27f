#include "config/text/reading.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace config {

std::string read_text(std::istream& in, const std::string& file, ExitCode code) {
    const std::string text{std::istreambuf_iterator<char>{in}, {}};
    return std::string{checked_text(text, file, code)};
}

std::string_view checked_text(std::string_view text, const std::string& file, ExitCode code) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        fail(code, {file}, "UTF-16 text", "UTF-8 text: save the file as UTF-8");
    }
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        fail(code, place_in(text, zero, {file}), "a byte of zero", "a text file");
    }
    return without_byte_order_mark(text);
}

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_lower_case(std::string_view text) {
    std::string lower{text};
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

}  // namespace config
