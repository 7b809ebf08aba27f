#include "config/table/preamble.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

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

/// Whether a line may be a header: words, no numbers.
bool are_names(std::vector<std::string_view> fields) {
    while (!fields.empty() && fields.back().empty()) {
        fields.pop_back();  // a separator at the end of the line names no column
    }
    return std::none_of(fields.begin(), fields.end(), [](std::string_view field) {
        return field.empty() ||
               std::string_view{"+-.0123456789"}.find(field.front()) != std::string_view::npos;
    });
}

/// The first of the lines at the end that have as many fields as the last one, if fields are separated so.
/// Nothing where these are no table.
std::optional<std::size_t> first_of_table(const std::vector<std::string_view>& lines,
                                          const std::vector<bool>& begins_block, char separator) {
    std::vector<std::size_t> counts;
    for (const std::string_view line : lines) {
        counts.push_back(fields_of(line, separator).size());
    }
    const std::size_t usual = counts.back();
    std::size_t first = counts.size() - 1;
    while (first > 0 && counts[first - 1] == usual) {
        --first;
    }
    const bool fewer_above = std::all_of(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(first),
                                         [&](std::size_t count) { return count < usual; });
    const bool has_rows = first + 1 < counts.size();
    const std::size_t least = first == 0 ? 2 : least_fields;
    return usual >= least && has_rows && (fewer_above || begins_block[first]) &&
                   are_names(fields_of(lines[first], separator))
               ? std::optional{first}
               : std::nullopt;
}

}  // namespace

std::size_t lines_above_header(std::string_view text) {
    std::vector<std::string_view> lines;
    std::vector<std::size_t> numbers;
    std::vector<bool> begins_block;  // an empty line stands before it
    bool after_empty = false;
    for (std::size_t number = 0; !text.empty() && lines.size() < most_lines_seen; ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        // A comment may be the header, as the Dutch service has it.
        const bool is_comment = line.starts_with('#');
        const std::string_view fields = is_comment ? trimmed(line.substr(1)) : line;
        if (!fields.empty() && (!is_comment || fields.find_first_of(";\t,") != std::string_view::npos)) {
            lines.push_back(fields);
            numbers.push_back(number);
            begins_block.push_back(after_empty);
        }
        after_empty = fields.empty();
    }
    if (lines.size() < 3 || lines.front().starts_with("sep=")) {
        return 0;
    }
    std::optional<std::size_t> header;
    for (const char separator : {';', '\t', ','}) {
        const auto first = first_of_table(lines, begins_block, separator);
        header = first && (!header || *first < *header) ? first : header;
    }
    return header && *header > 0 ? numbers[*header] : 0;
}

}  // namespace config
