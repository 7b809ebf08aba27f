#include "config/table/preamble.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace config {
namespace {

constexpr std::size_t most_lines_seen = 80;  ///< no service explains more than half of that [choice]
constexpr std::size_t least_fields = 3;      ///< two may well be in a sentence

/// The fields of a line, cut outside quotes.
std::vector<std::string_view> fields_of(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    bool is_quoted = false;
    std::size_t start = 0;
    for (std::size_t at = 0; at <= line.size(); ++at) {
        if (at == line.size() || (line[at] == separator && !is_quoted)) {
            fields.push_back(trimmed(line.substr(start, at - start)));
            start = at + 1;
        } else if (line[at] == '"') {
            is_quoted = !is_quoted;
        }
    }
    return fields;
}

/// Whether a line may be a header: names, no numbers.
bool are_names(std::vector<std::string_view> fields) {
    while (!fields.empty() && fields.back().empty()) {
        fields.pop_back();  // a separator at the end of the line names no column
    }
    return std::none_of(fields.begin(), fields.end(), [](std::string_view field) {
        return field.empty() || parse_number(std::string{field}).has_value();
    });
}

/// The lines above the header if fields are separated so; 0 for none.
std::size_t lines_above(const std::vector<std::string_view>& lines, char separator) {
    std::vector<std::size_t> counts;
    for (const std::string_view line : lines) {
        counts.push_back(fields_of(line, separator).size());
    }
    const std::size_t usual = counts.back();
    std::size_t header = counts.size() - 1;
    while (header > 0 && counts[header - 1] == usual) {
        --header;
    }
    const bool has_rows = header + 1 < counts.size();
    const bool fewer_above = std::all_of(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(header),
                                         [&](std::size_t count) { return count < usual; });
    const bool is_table = usual >= least_fields && has_rows && fewer_above;
    return is_table && are_names(fields_of(lines[header], separator)) ? header : 0;
}

}  // namespace

std::size_t lines_above_header(std::string_view text) {
    std::vector<std::string_view> lines;
    std::vector<std::size_t> numbers;
    for (std::size_t number = 0; !text.empty() && lines.size() < most_lines_seen; ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty() && line.front() != '#') {
            lines.push_back(line);
            numbers.push_back(number);
        }
    }
    if (lines.size() < 3 || lines.front().starts_with("sep=")) {
        return 0;
    }
    for (const char separator : {';', '\t', ','}) {
        if (const std::size_t above = lines_above(lines, separator); above > 0) {
            return numbers[above];
        }
    }
    return 0;
}

}  // namespace config
