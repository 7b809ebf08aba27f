#include "coupling/inputs/tables/meant_columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/column_names.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling {
namespace {

constexpr std::array known_units{"m",      "cm",      "mm",  "km",    "ft",      "mps",    "kmh",   "kph",
                                 "kg",     "t",       "to",  "ton",   "tons",    "tonnes", "kgpm3", "deg",
                                 "degree", "degrees", "rad", "gon",   "percent", "pct",    "j",     "kj",
                                 "m3",     "l",       "s",   "years", "year",    "yr",     "a",     "per_m"};

/// Words that other programs and people use for the quantities here.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> other_words{
    {{"velocity", "speed"},
     {"weight", "mass"},
     {"aspect", "azimuth"},
     {"direction", "azimuth"},
     {"size", "diameter"},
     {"drop_height", "fall_height"}}};

/// A name without the unit at its end.
std::string quantity_of(const std::string& name) {
    const std::string low = config::in_lower_case(name);
    std::string stem = low;
    for (const std::string_view unit : known_units) {
        if (low.size() > unit.size() + 1 && low.ends_with(unit) && low[low.size() - unit.size() - 1] == '_') {
            const std::string shorter = low.substr(0, low.size() - unit.size() - 1);
            stem = shorter.size() < stem.size() ? shorter : stem;
        }
    }
    for (const auto& [other, ours] : other_words) {
        if (stem == other) {
            return std::string{ours};
        }
    }
    return stem;
}

std::string letters_of(const std::string& name) {
    std::string letters = config::in_lower_case(name);
    std::erase_if(letters, [](char c) { return c == '_' || c == '-' || c == ' '; });
    return letters;
}

/// Whether a spreadsheet computes a text: `=1+1`, `+A1`, `@SUM(A1)`, but not `-3.5` and not a lone dash.
bool is_formula(std::string_view text) {
    constexpr std::string_view beginnings = "=+-@";
    return text.size() > 1 && beginnings.find(text.front()) != std::string_view::npos &&
           !config::parse_number(text);
}

}  // namespace

bool names_things(std::string_view column) {
    return column == "name" || column == "label" || column == "code" || column.ends_with("_id");
}

std::vector<config::Problem> formula_warnings(const config::Table& table) {
    std::vector<config::Problem> found;
    for (const std::string& column : table.columns()) {
        if (!names_things(column)) {
            continue;
        }
        std::size_t count = 0;
        std::size_t first = 0;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (is_formula(table.text(row, column))) {
                first = count++ == 0 ? row : first;
            }
        }
        if (count > 0) {
            found.push_back(
                {config::ExitCode::data, table.place(first, column),
                 column + " " + config::in_quotes(table.text(first, column)) +
                     (count > 1 ? " and " + counted(count - 1, "more such text") : "") +
                     ", which a spreadsheet takes for a formula when it opens the results",
                 "texts that do not begin with =, +, - or @: rename them, or import the results as "
                 "text"});
        }
    }
    return found;
}

std::string meant_column(const std::string& name, const std::vector<std::string>& known) {
    if (letters_of(name) == "share") {  // a word of its own, one letter from "shape"
        return {};
    }
    const std::string quantity = config::form_of(name).quantity;  // also of "r_n [%]"
    for (const std::string& column : known) {
        // A name of ours may end like a unit: r_t has none, and r_t_percent has one more.
        if (letters_of(name) == letters_of(column) || quantity_of(name) == quantity_of(column) ||
            quantity == letters_of(column)) {
            return column;
        }
    }
    return config::nearest_word(name, known);
}

std::vector<config::Problem> misspelt_columns(const config::Table& table,
                                              const std::vector<std::string>& known, std::string_view role) {
    std::vector<config::Problem> found;
    std::set<std::string> named;
    const auto pass_over = [&](const std::string& column, const std::string& meant) {
        named.insert(column);
        found.push_back({config::ExitCode::data,
                         {table.file()},
                         "column " + config::in_quotes(column) + ", which is passed over",
                         meant + ", if that is what is meant"});
        table.count_as_named(column);
    };
    for (const std::string& column : table.columns_beside(known)) {
        const std::string meant = meant_column(column, known);
        // A column in another unit is an error, which comes when all has been read.
        if (!meant.empty() && !table.has(meant) &&
            !config::is_other_unit(config::form_of(column), config::form_of(meant))) {
            pass_over(column, meant);
        }
    }
    for (const std::string& name : known) {
        const bool is_measured = !config::form_of(name).unit.empty();
        if (role.empty() || !is_measured || table.find(name)) {
            continue;
        }
        const std::vector<std::string> columns = formats::columns_by_part(table, role, name, true);
        const auto other = std::find_if(columns.begin(), columns.end(),
                                        [&](const std::string& column) { return !named.contains(column); });
        if (other != columns.end()) {
            pass_over(*other, name);
        }
    }
    return found;
}

}  // namespace coupling
