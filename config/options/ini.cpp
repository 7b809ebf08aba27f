#include "config/options/ini.hpp"

#include <algorithm>
#include <boost/program_options/errors.hpp>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <optional>
#include <sstream>

#include "config/text/reading.hpp"

namespace config {

namespace {

/// Program_options ends a line at every '#', even one in quotes; this stands in for it.
constexpr char hash_stand_in = '\x01';

/// A line up to its comment.
std::string_view without_comment(std::string_view line) {
    const std::size_t equals = line.find('=');
    const std::size_t value =
        equals == std::string_view::npos ? equals : line.find_first_not_of(" \t", equals + 1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && (i == value || quoted)) {
            quoted = i == value || (i + 1 < line.size() && line[i + 1] == '"' && ++i != 0);
        } else if (!quoted && (line[i] == '#' || line[i] == ';') && (i == 0 || is_blank(line[i - 1]))) {
            return line.substr(0, i);
        }
    }
    return line;
}

/// What stands behind the sign of a comment.
std::string_view comment_in(std::string_view line) {
    const std::size_t end = without_comment(line).size();
    return end == line.size() ? std::string_view{} : trimmed(line.substr(end + 1));
}

/// The value itself; nothing if its quotes are not in order.
std::optional<std::string> unquoted(std::string_view text) {
    if (!text.starts_with('"')) {
        return std::string{text};
    }
    std::string value;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] != '"') {
            value += text[i];
        } else if (i + 1 == text.size()) {
            return value;
        } else if (text[++i] == '"') {
            value += '"';
        } else {
            break;
        }
    }
    return std::nullopt;
}

/// Program_options on one line, which distinguishes it from the others: its own messages know no lines.
std::optional<std::pair<std::string, std::string>> parse_assignment(std::string line) {
    namespace po = boost::program_options;
    std::replace(line.begin(), line.end(), '#', hash_stand_in);
    std::istringstream in{line};
    try {
        const po::options_description any;
        const po::parsed_options parsed = po::parse_config_file(in, any, true);
        if (parsed.options.size() != 1 || parsed.options[0].string_key.empty()) {
            return std::nullopt;
        }
        std::string value = parsed.options[0].value.at(0);
        std::replace(value.begin(), value.end(), hash_stand_in, '#');
        return {{parsed.options[0].string_key, std::move(value)}};
    } catch (const po::error&) {
        return std::nullopt;
    }
}

void add_assignment(std::string_view line, const std::string& section, const Place& place,
                    std::vector<IniEntry>& entries, Problems& problems) {
    const std::size_t equals = line.find('=');
    const auto assignment = parse_assignment(std::string{line});
    if (!assignment) {
        problems.add(ExitCode::settings, place, in_quotes(line), "[section] or key = value");
        return;
    }
    const std::size_t value_at = std::min(line.find_first_not_of(" \t", equals + 1), line.size());
    const Place value_place = place_in(line, value_at, place);
    const std::optional<std::string> value = unquoted(assignment->second);
    if (!value) {
        problems.add(ExitCode::settings, value_place, in_quotes(assignment->second),
                     "quotes around the whole value");
        return;
    }
    entries.push_back({section, assignment->first, *value, place, value_place});
}

}  // namespace

std::vector<IniEntry> read_ini(std::istream& in, const std::string& file, Problems& problems) {
    std::string text = read_text(in, file, ExitCode::settings);
    if (text.size() > longest_ini_bytes) {
        fail(ExitCode::settings, {file},
             std::to_string(text.size()) + " bytes, more than " + std::to_string(longest_ini_bytes),
             "a file of settings: is this the file that was meant?");
    }
    std::vector<IniEntry> entries;
    std::string section;
    std::istringstream lines{std::move(text)};
    std::string whole_line;
    // A file of another kind is wrong on every line: after so many problems the rest says nothing new.
    for (std::size_t number = 1;
         problems.list().size() < most_ini_problems && std::getline(lines, whole_line); ++number) {
        const std::string_view line = trimmed(without_comment(whole_line));
        if (line.empty()) {
            continue;
        }
        const auto start = static_cast<std::size_t>(line.data() - whole_line.data());
        const Place place = place_in(whole_line, start, {file, number, 1});
        if (!line.starts_with('[')) {
            const std::size_t before = entries.size();
            add_assignment(line, section, place, entries, problems);
            if (entries.size() > before) {
                entries.back().comment = comment_in(whole_line);
            }
        } else if (line.ends_with(']') && !trimmed(line.substr(1, line.size() - 2)).empty()) {
            section = trimmed(line.substr(1, line.size() - 2));
        } else {
            problems.add(ExitCode::settings, place, in_quotes(line), "a section name between [ and ]");
        }
    }
    return entries;
}

std::vector<IniEntry> read_override(const std::string& text, Problems& problems) {
    const Place place{.file = std::string{"--set "}.append(text)};
    const std::size_t equals = text.find('=');
    const std::string key{trimmed(std::string_view{text}.substr(0, equals))};
    const std::size_t dot = key.rfind('.');
    if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 == key.size()) {
        problems.add(ExitCode::settings, place, in_quotes(text), "section.key=value");
        return {};
    }
    const std::string_view value = trimmed(std::string_view{text}.substr(equals + 1));
    return {{key.substr(0, dot), key.substr(dot + 1), unquoted(value).value_or(std::string{value}), place,
             place}};
}

std::string ini_value(std::string_view value) {
    const bool plain = trimmed(value) == value && !value.starts_with('"') && !value.starts_with('#') &&
                       !value.starts_with(';') && value.find(" #") == std::string_view::npos &&
                       value.find(" ;") == std::string_view::npos &&
                       value.find('\t') == std::string_view::npos;
    if (plain) {
        return std::string{value};
    }
    std::string quoted{"\""};
    for (const char c : value) {
        quoted += c;
        if (c == '"') {
            quoted += c;
        }
    }
    return quoted + '"';
}

}  // namespace config
