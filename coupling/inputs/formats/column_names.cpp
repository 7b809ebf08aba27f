#include "coupling/inputs/formats/column_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/geometry/wkt.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::formats {
namespace {

/// A column of ours in tables of a role and other words for it, the likelier first.
struct ColumnWords {
    std::string role;
    std::string column;
    std::vector<std::string> words;
};

const std::vector<ColumnWords>& shipped_words() {
    static const std::vector<ColumnWords> shipped = [] {
        std::vector<ColumnWords> rows;
        const config::Table table =
            config::Table::read(config::shipped_table("column_names.csv"), "column_names.csv");
        for (std::size_t row = 0; row < table.rows(); ++row) {
            ColumnWords& entry =
                rows.emplace_back(ColumnWords{table.text(row, "role"), table.text(row, "column"), {}});
            std::istringstream words{table.text(row, "words")};
            for (std::string word; words >> word;) {
                entry.words.push_back(word);
            }
        }
        return rows;
    }();
    return shipped;
}

/// The column that is `wanted` but for capitals, or its first ten letters in a Shapefile.
std::optional<std::string> same_but_for_form(const config::Table& table, const std::string& wanted) {
    constexpr std::size_t longest_of_shapefiles = 10;
    for (const std::string& column : table.columns()) {
        const std::string lower = config::in_lower_case(column);
        if (lower == wanted || (lower.size() == longest_of_shapefiles && wanted.starts_with(lower))) {
            return column;
        }
    }
    return std::nullopt;
}

/// The likeliest of the words that a column is called by; a column of ours keeps its name.
std::optional<std::string> by_word(const config::Table& table, const ColumnWords& entry) {
    const auto is_ours = [&](const std::string& column) {
        return std::any_of(shipped_words().begin(), shipped_words().end(), [&](const ColumnWords& other) {
            return other.role == entry.role && other.column == column;
        });
    };
    for (const std::string& word : entry.words) {
        for (const std::string& column : table.columns()) {
            if (config::in_lower_case(column) == word && !is_ours(column)) {
                return column;
            }
        }
    }
    return std::nullopt;
}

/// Coordinates of a place, or of both ends of a line; as many as `names` has.
std::optional<std::vector<double>> coordinates_of(const config::Table& table, std::size_t row,
                                                  std::size_t points) {
    if (table.text(row, "wkt").empty()) {
        return std::nullopt;
    }
    try {
        const config::Shape shape = config::read_wkt(table.text(row, "wkt"), {});
        const bool fits = shape.parts.size() == 1 && (points == 1 ? shape.kind == config::Shape::Kind::point
                                                                  : shape.kind == config::Shape::Kind::line);
        if (!fits) {
            return std::nullopt;
        }
        const auto& part = shape.parts.front();
        std::vector<double> found{part.front().x_m, part.front().y_m};
        if (points == 2) {
            found.insert(found.end(), {part.back().x_m, part.back().y_m});
        }
        return found;
    } catch (const config::InputError&) {
        return std::nullopt;  // the row lacks coordinates then, which its reader says
    }
}

}  // namespace

std::vector<NamedColumn> name_columns(config::Table& table, std::string_view role) {
    std::vector<NamedColumn> named;
    if (!table.has("wkt")) {
        if (const auto shapes = same_but_for_form(table, "wkt")) {
            table.rename(*shapes, "wkt");
        }
    }
    // First what is only written differently, so that no word takes a column that has its name.
    for (const ColumnWords& entry : shipped_words()) {
        if (entry.role == role && !table.has(entry.column)) {
            if (const auto same = same_but_for_form(table, entry.column)) {
                table.rename(*same, entry.column);
            }
        }
    }
    for (const ColumnWords& entry : shipped_words()) {
        if (entry.role == role && !table.has(entry.column)) {
            if (const auto other = by_word(table, entry)) {
                named.push_back({*other, entry.column});
                table.rename(*other, entry.column);
            }
        }
    }
    return named;
}

std::size_t take_coordinates(config::Table& table, std::string_view role, bool shapes_win) {
    constexpr std::array<const char*, 2> of_point{"x_m", "y_m"};
    constexpr std::array<const char*, 4> of_line{"x1_m", "y1_m", "x2_m", "y2_m"};
    if (!table.has("wkt") || table.rows() == 0 || (!shapes_win && (table.has("x_m") || table.has("x1_m")))) {
        return 0;
    }
    const bool are_lines =
        role == "logs" && config::in_lower_case(table.text(0, "wkt")).find("line") != std::string::npos;
    const std::vector<std::string> names = are_lines
                                               ? std::vector<std::string>{of_line.begin(), of_line.end()}
                                               : std::vector<std::string>{of_point.begin(), of_point.end()};
    std::vector<std::vector<std::string>> columns(names.size(), std::vector<std::string>(table.rows()));
    std::size_t moved = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto found = coordinates_of(table, row, names.size() / 2);
        bool has_moved = false;
        for (std::size_t i = 0; found && i < names.size(); ++i) {
            columns[i][row] = config::to_text((*found)[i]);
            const auto before =
                table.has(names[i]) ? config::parse_number(table.text(row, names[i])) : std::nullopt;
            constexpr double far_m = 1.0;
            has_moved = has_moved || (before && std::abs(*before - (*found)[i]) > far_m);
        }
        moved += has_moved ? 1U : 0U;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (table.has(names[i])) {
            table.rename(names[i], names[i] + "_attribute");
        }
        table.add_column(names[i], std::move(columns[i]), "wkt");
    }
    return moved;
}

}  // namespace coupling::formats
