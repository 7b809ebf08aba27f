#include "coupling/inputs/formats/column_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/geometry/wkt.hpp"
#include "config/table/missing_words.hpp"
#include "config/text/numbers.hpp"
#include "config/text/plain_letters.hpp"
#include "config/text/reading.hpp"
#include "config/text/words_of_list.hpp"

namespace coupling::formats {
namespace {

constexpr std::string_view every_role = "*";

/// A column of ours in tables of a role and other words for it, the likelier first.
struct ColumnWords {
    std::string role;
    std::string column;
    std::vector<std::string> words;      ///< their letters, as forms have them
    std::vector<std::string> with_unit;  ///< the same of words that count only beside a unit
    std::vector<std::string> parts;      ///< the same of words that are too general to be more than proposed

    [[nodiscard]] bool is_for(std::string_view wanted) const {
        // Roles of several files of a kind have a name behind them: "climate warm".
        return role == every_role || role == wanted.substr(0, wanted.find_first_of(" ,"));
    }
};

std::vector<std::string> letters_of_words(const std::string& list) {
    std::vector<std::string> letters;
    for (const std::string& word : config::words_between_blanks(list)) {
        letters.push_back(config::form_of(word).letters);
    }
    return letters;
}

const std::vector<ColumnWords>& shipped_words() {
    static const std::vector<ColumnWords> shipped = [] {
        std::vector<ColumnWords> rows;
        const config::Table table = config::read_shipped_table("column_names.csv");
        for (std::size_t row = 0; row < table.rows(); ++row) {
            rows.push_back({table.text(row, "role"), table.text(row, "column"),
                            letters_of_words(table.text(row, "words")),
                            letters_of_words(table.text(row, "with_unit")),
                            letters_of_words(table.text(row, "proposed"))});
        }
        return rows;
    }();
    return shipped;
}

/// The column that has the first ten letters of `wanted`, all that a Shapefile keeps.
std::optional<std::string> cut_off(const config::Table& table, const std::string& wanted) {
    constexpr std::size_t longest_of_shapefiles = 10;
    for (const std::string& column : table.columns()) {
        const std::string lower = config::in_lower_case(column);
        if (lower.size() == longest_of_shapefiles && wanted.starts_with(lower)) {
            return column;
        }
    }
    return std::nullopt;
}

/// How a header fits a word: not, or in another unit than wanted, or well.
enum class Fit : std::uint8_t { none, other_unit, good };

Fit fit_of(const config::ColumnForm& header, const std::string& word, bool needs_unit,
           const config::ColumnForm& wanted) {
    if (!header.unit.empty() && header.quantity == word) {
        return header.unit == wanted.unit ? Fit::good : Fit::other_unit;
    }
    return header.letters == word && !needs_unit ? Fit::good : Fit::none;
}

/// The likeliest column that is called by a word; a column of ours keeps its name.
struct ByWord {
    std::optional<std::string> column;
    Fit fit = Fit::none;
};

ByWord by_word(const config::Table& table, std::string_view role, const ColumnWords& entry) {
    std::vector<config::ColumnForm> ours;
    for (const ColumnWords& other : shipped_words()) {
        if (other.is_for(role)) {
            ours.push_back(config::form_of(other.column));
        }
    }
    std::vector<std::pair<std::string, config::ColumnForm>> headers;
    for (const std::string& column : table.columns()) {
        config::ColumnForm form = config::form_of(column);
        const bool is_ours = std::any_of(ours.begin(), ours.end(), [&](const config::ColumnForm& other) {
            return config::is_same_column(form, other);
        });
        if (!is_ours) {
            headers.emplace_back(column, std::move(form));
        }
    }
    const config::ColumnForm wanted = config::form_of(entry.column);
    ByWord other_unit;
    for (const auto& [words, needs_unit] : {std::pair{&entry.words, false}, {&entry.with_unit, true}}) {
        for (const std::string& word : *words) {
            for (const auto& [column, form] : headers) {
                const Fit fit = fit_of(form, word, needs_unit, wanted);
                if (fit == Fit::good) {
                    return {column, fit};
                }
                if (fit == Fit::other_unit && !other_unit.column && !wanted.unit.empty()) {
                    other_unit = {column, fit};
                }
            }
        }
    }
    return other_unit;
}

/// The words of a name in plain letters: "treeHeight_m" as "tree", "height", "m"; "BlockID" as "block", "id".
std::vector<std::string> parts_of(std::string_view name) {
    const auto is_lower = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
    const auto is_upper = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
    std::vector<std::string> parts(1);
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0;
        const bool begins = is_upper(c) && i > 0 &&
                            (is_lower(name[i - 1]) ||
                             (is_upper(name[i - 1]) && i + 1 < name.size() && is_lower(name[i + 1])));
        if (!is_word || begins) {
            parts.emplace_back();
        }
        if (is_word) {
            parts.back() += c;
        }
    }
    std::erase_if(parts, [](const std::string& part) { return part.empty(); });
    for (std::string& part : parts) {
        part = config::plain_letters(part);
    }
    return parts;
}

/// Whether some parts of a name that stand side by side are a word.
bool has_word(const std::vector<std::string>& parts, const std::string& word) {
    for (std::size_t first = 0; first < parts.size(); ++first) {
        std::string run;
        for (std::size_t i = first; i < parts.size() && run.size() < word.size(); ++i) {
            run += parts[i];
        }
        if (run == word) {
            return true;
        }
    }
    return false;
}

bool letters_begin_with(const std::vector<std::string>& parts, const std::string& word) {
    std::string letters;
    for (const std::string& part : parts) {
        letters += part;
    }
    return letters.starts_with(word);
}

/// All words for a column of ours in a role, itself among them.
std::vector<std::string> words_for(std::string_view role, std::string_view wanted) {
    std::vector<std::string> words{config::form_of(wanted).quantity};
    for (const ColumnWords& entry : shipped_words()) {
        if (entry.column == wanted && entry.is_for(role)) {
            for (const auto* list : {&entry.words, &entry.with_unit, &entry.parts}) {
                words.insert(words.end(), list->begin(), list->end());
            }
        }
    }
    return words;
}

/// Whether a column is one of ours in a role, whatever it is called in the file.
bool is_of_role(const std::string& column, std::string_view role) {
    return std::any_of(shipped_words().begin(), shipped_words().end(), [&](const ColumnWords& entry) {
        return entry.is_for(role) && entry.column == column;
    });
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

std::vector<config::Problem> name_columns(config::Table& table, std::string_view role) {
    std::vector<config::Problem> in_other_units;
    if (!table.use()) {
        table.watch();
    }
    // First what is only written differently, so that no word takes a column that has its name.
    for (const ColumnWords& entry : shipped_words()) {
        if (!entry.is_for(role)) {
            continue;
        }
        if (const auto place = table.find(entry.column)) {
            const std::string form = table.columns()[*place];
            if (form != entry.column) {
                table.rename(form, entry.column);
            }
        } else if (const auto cut = cut_off(table, entry.column)) {
            table.rename(*cut, entry.column);
        }
    }
    for (const ColumnWords& entry : shipped_words()) {
        if (!entry.is_for(role) || table.find(entry.column)) {
            continue;
        }
        const ByWord other = by_word(table, role, entry);
        if (other.fit == Fit::other_unit) {
            in_other_units.push_back(config::other_unit_problem(table.file(), *other.column, entry.column));
        }
        if (other.column) {
            table.rename(*other.column, entry.column);
        }
    }
    return in_other_units;
}

namespace {

/// The whole number that a factor divides by, such as 10 for 0.1.
std::optional<double> divisor_of(double factor) {
    constexpr double same = 1e-12;
    const double divisor = factor > 0.0 && factor < 1.0 ? std::round(1.0 / factor) : 0.0;
    return divisor > 1.0 && std::abs(divisor * factor - 1.0) < same ? std::optional{divisor} : std::nullopt;
}

/// The column that holds a quantity of ours in another unit, if the table lacks it in ours.
std::optional<std::string> in_other_unit(const config::Table& table, std::string_view role,
                                         const ColumnWords& entry, const config::ColumnForm& wanted) {
    for (const std::string& column : table.columns()) {
        if (config::is_other_unit(config::form_of(column), wanted)) {
            return column;
        }
    }
    const ByWord other = by_word(table, role, entry);
    return other.fit == Fit::other_unit ? other.column : std::nullopt;
}

/// The fields of a column in our unit; nothing where one that holds something is no number.
std::optional<std::vector<std::string>> in_our_unit(const config::Table& table, const std::string& column,
                                                    double factor) {
    constexpr double of_places = 1e9;  // 188.3 / 10 is 18.83, not 18.830000000000002
    const std::optional<double> divisor = divisor_of(factor);
    std::vector<std::string> fields;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& field = table.seen_text(row, column);
        const auto number = config::parse_number(field);
        if (!number && !field.empty() && !config::says_no_value(field)) {
            return std::nullopt;
        }
        const double ours = number ? (divisor ? *number / *divisor : *number * factor) : 0.0;
        fields.push_back(number ? config::to_text(std::round(ours * of_places) / of_places) : field);
    }
    return fields;
}

}  // namespace

std::string times_in_words(double factor) {
    const auto divisor = divisor_of(factor);
    return divisor ? " / " + config::to_text(*divisor) : " * " + config::to_text(factor);
}

std::vector<UnitChange> take_other_units(config::Table& table, std::string_view role) {
    if (!table.use()) {
        table.watch();
    }
    std::vector<UnitChange> changes;
    for (const ColumnWords& entry : shipped_words()) {
        const config::ColumnForm wanted = config::form_of(entry.column);
        if (!entry.is_for(role) || wanted.unit.empty() || table.find(entry.column) ||
            by_word(table, role, entry).fit == Fit::good) {
            continue;
        }
        const auto column = in_other_unit(table, role, entry, wanted);
        const double factor = column ? config::unit_factor(config::form_of(*column).unit, wanted.unit) : 0.0;
        auto fields = factor > 0.0 ? in_our_unit(table, *column, factor) : std::nullopt;
        if (!fields) {
            continue;
        }
        changes.push_back(
            {table.found_columns()[*table.find(*column)], entry.column, times_in_words(factor)});
        for (std::size_t row = 0; row < table.rows(); ++row) {
            table.set_text(row, *column, std::move((*fields)[row]));
        }
        table.rename(*column, entry.column);
    }
    return changes;
}

std::vector<std::string> columns_by_part(const config::Table& table, std::string_view role,
                                         std::string_view wanted, bool whole_words) {
    constexpr std::size_t shortest_word = 2;       // single letters are parts of anything
    constexpr std::size_t shortest_beginning = 3;  // "bhd_klasse", but not "identity" for an id
    std::vector<std::pair<std::string, std::vector<std::string>>> columns;  // with the parts of their names
    for (std::size_t i = 0; i < table.columns().size(); ++i) {
        const std::string& column = table.found_columns()[i];
        if (column.size() <= config::longest_column_bytes && !is_of_role(table.columns()[i], role)) {
            columns.emplace_back(column, parts_of(column));
        }
    }
    const std::vector<std::string> words = words_for(role, wanted);
    std::vector<std::string> found;
    const auto find = [&](std::size_t shortest, const auto& fits) {
        for (const std::string& word : words) {
            for (const auto& [column, parts] : columns) {
                if (word.size() >= shortest && fits(parts, word) &&
                    std::find(found.begin(), found.end(), column) == found.end()) {
                    found.push_back(column);
                }
            }
        }
    };
    find(shortest_word, has_word);
    if (!whole_words) {
        find(shortest_beginning, letters_begin_with);
    }
    return found;
}

std::size_t take_coordinates(config::Table& table, std::string_view role, bool shapes_win) {
    constexpr std::array<const char*, 2> of_point{"x_m", "y_m"};
    constexpr std::array<const char*, 4> of_line{"x1_m", "y1_m", "x2_m", "y2_m"};
    const bool has_places = table.find("x_m") || table.find("x1_m");
    if (!table.find("wkt") || table.rows() == 0 || (!shapes_win && has_places)) {
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
                table.find(names[i]) ? config::parse_number(table.text(row, names[i])) : std::nullopt;
            constexpr double far_m = 1.0;
            has_moved = has_moved || (before && std::abs(*before - (*found)[i]) > far_m);
        }
        moved += has_moved ? 1U : 0U;
        for (std::size_t i = 0; !found && i < names.size(); ++i) {
            columns[i][row] = table.find(names[i]) ? table.text(row, names[i]) : "";
        }
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (table.find(names[i])) {
            table.rename(names[i], names[i] + std::string{superseded_by_shape});
        }
        table.add_column(names[i], std::move(columns[i]), "wkt");
    }
    return moved;
}

}  // namespace coupling::formats
