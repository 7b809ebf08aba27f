#include <algorithm>
#include <array>
#include <sstream>

#include "config/options/ini.hpp"
#include "config/options/options.hpp"
#include "config/options/parameter.hpp"
#include "config/text/numbers.hpp"

namespace config {

namespace {

constexpr std::size_t page_width = 100;

/// Columns that a text takes on the screen.
std::size_t width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Words broken into lines; a word wider than the line stands alone.
std::vector<std::string> wrapped(const std::string& text, std::size_t line_width) {
    std::vector<std::string> lines;
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        if (lines.empty() || width(lines.back()) + 1 + width(word) > line_width) {
            lines.push_back(word);
        } else {
            lines.back().append(" ").append(word);
        }
    }
    return lines;
}

std::string name_of(const ParameterRow& row) {
    const std::size_t dot = row.key.rfind('.');
    return dot == std::string::npos ? row.key : row.key.substr(dot + 1);
}

std::string section_of(const ParameterRow& row) {
    const std::size_t dot = row.key.rfind('.');
    return dot == std::string::npos ? "" : row.key.substr(0, dot);
}

bool has_unit(const ParameterRow& row) {
    return !row.unit.empty() && row.unit != "-";
}

/// "rolling friction; strict: 0.4 (Azzoni et al. 1995)": what there is to say beside the columns.
std::string description(const ParameterRow& row) {
    std::string text = row.meaning;
    if (row.kind.starts_with("one of") || row.kind == "yes/no" || row.kind.starts_with("list of")) {
        text.append(text.empty() ? "" : "; ").append(row.kind);
    }
    for (const Preset& preset : row.presets) {
        text.append("; ").append(preset.name).append(": ").append(preset.value);
    }
    if (!row.source.empty()) {
        text.append(" (").append(row.source).append(")");
    }
    return text;
}

std::string comment_of(const ParameterRow& row) {
    std::string facts = has_unit(row) ? std::string{" ["}.append(row.unit).append("]") : "";
    if (!row.range.empty()) {
        facts.append(" in ").append(row.range);
    }
    return description(row)
        .append(facts)
        .append(", default ")
        .append(row.default_text.empty() ? "empty" : row.default_text);
}

using TableLine = std::array<std::string, 4>;

TableLine columns_of(const ParameterRow& row) {
    return {name_of(row), row.default_text.empty() ? "empty" : row.default_text, row.unit, row.range};
}

void write_help_row(std::ostream& out, const ParameterRow& row, const std::array<std::size_t, 4>& widths) {
    std::string line{"  "};
    std::size_t indent = 2;
    const TableLine cells = columns_of(row);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        indent += widths[i] + 2;
        line.append(cells[i]).append("  ");
        line.append(indent > width(line) ? indent - width(line) : 0, ' ');
    }
    const std::vector<std::string> meaning = wrapped(description(row), page_width - indent);
    std::size_t next = 0;
    if (width(line) <= indent && !meaning.empty()) {
        line.append(meaning[next++]);
    }
    out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
    for (; next < meaning.size(); ++next) {
        out << std::string(indent, ' ') << meaning[next] << '\n';
    }
}

}  // namespace

std::vector<ParameterRow> Options::rows() const {
    std::vector<ParameterRow> rows;
    for (const Parameter& parameter : parameters_) {
        const ParameterInfo& info = parameter.info;
        ParameterRow row;
        row.key = parameter.key;
        row.kind = parameter.kind;
        row.unit = info.unit;
        row.range = to_string(NumberRange{info.low, info.high});
        row.default_text = parameter.default_text;
        row.value_text = parameter.get();
        row.meaning = info.meaning;
        row.source = info.source;
        row.presets = info.presets;
        row.changed = row.value_text != row.default_text;
        row.files = info.files;
        row.needs = info.needs;
        rows.push_back(std::move(row));
    }
    return rows;
}

void Options::write_ini(std::ostream& out, bool with_comments) const {
    const std::vector<ParameterRow> all = rows();
    std::vector<std::string> sections = section_names();
    // Keys of no section can only stand before the first section.
    std::stable_partition(sections.begin(), sections.end(),
                          [](const std::string& name) { return name.empty(); });
    const char* gap = "";
    for (const std::string& section : sections) {
        if (!section.empty()) {
            out << gap << '[' << section << "]\n";
        }
        gap = "\n";
        for (const ParameterRow& row : all) {
            if (section_of(row) != section) {
                continue;
            }
            if (with_comments) {
                for (const std::string& line : wrapped(comment_of(row), page_width - 2)) {
                    out << "# " << line << '\n';
                }
            }
            out << name_of(row) << " = " << ini_value(row.value_text) << '\n';
        }
    }
    std::string section;
    for (const FreeEntry& entry : free_entries_) {
        if (entry.section != section) {
            out << gap << '[' << entry.section << "]\n";
            section = entry.section;
        }
        out << entry.key << " = " << ini_value(entry.value) << '\n';
    }
}

void Options::write_help(std::ostream& out, const std::string& section_filter) const {
    constexpr std::array<std::size_t, 4> widest{30, 12, 8, 12};
    const std::vector<ParameterRow> all = rows();
    std::array<std::size_t, 4> widths{};
    for (const ParameterRow& row : all) {
        const TableLine cells = columns_of(row);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            widths[i] = std::max(widths[i], std::min(width(cells[i]), widest[i]));
        }
    }
    const char* gap = "";
    for (const std::string& section : section_names()) {
        if (!section_filter.empty() && section != section_filter) {
            continue;
        }
        out << gap << '[' << section << "]\n";
        gap = "\n";
        for (const ParameterRow& row : all) {
            if (section_of(row) == section) {
                write_help_row(out, row, widths);
            }
        }
    }
}

}  // namespace config
