#include "coupling/assessments/compare/runs/run_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/encoding.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/climate_input.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/results/geopackage/column_types.hpp"
#include "coupling/run/file_sums.hpp"

namespace coupling::compare {

using config::joined;

namespace {

/// No figure of a run comes near it: the largest are counts of rocks and energies in kJ [choice].
constexpr double largest_figure = 1e12;

/// In tables for Excel, the columns whose numbers have the decimal sign of the country: all but names.
std::vector<bool> numbers_for_excel(const OwnRows& rows) {
    std::vector<bool> is_number;
    for (const std::string& column : rows.columns()) {
        is_number.push_back(rows.separator() == ';' && !geopackage::is_key(column));
    }
    return is_number;
}

/// A field as this program reads it elsewhere: numbers with a decimal point.
std::string cell_of(std::string_view field, bool is_number) {
    std::string text{field};
    if (is_number && std::count(text.begin(), text.end(), ',') == 1) {
        std::string plain = text;
        std::replace(plain.begin(), plain.end(), ',', '.');
        return config::parse_number(plain) ? plain : text;
    }
    return text;
}

[[noreturn]] void refuse(const config::Table& table, std::size_t row, const std::string& column,
                         const char* expected) {
    config::fail(config::ExitCode::data, table.place(row, column), config::in_quotes(table.text(row, column)),
                 expected, "put the table back as it was, or run the scenario again with --overwrite");
}

}  // namespace

config::Table read_table(const std::filesystem::path& folder, const std::string& name,
                         const std::vector<std::string>& wanted) {
    refuse_changed(folder, joined("tables/", name));
    OwnRows rows{folder / "tables" / name, std::nullopt, config::ExitCode::data};
    const std::vector<bool> is_number = numbers_for_excel(rows);
    config::Features read{
        .file = (folder / "tables" / name).string(), .columns = rows.columns(), .cells = {}, .numbers = {}};
    while (rows.next()) {
        std::vector<std::string>& cells = read.cells.emplace_back();
        for (std::size_t i = 0; i < rows.fields().size(); ++i) {
            cells.push_back(cell_of(rows.fields()[i], is_number[i]));
            if (!config::is_utf8(cells.back())) {
                rows.refuse("text that is not UTF-8");
            }
        }
        read.numbers.push_back(static_cast<std::uint32_t>(rows.line()));
    }
    config::Table table = config::Table::of(std::move(read));
    config::Problems problems;
    table.require(wanted, problems);
    problems.throw_if_any();
    return table;
}

bool has_table(const std::filesystem::path& folder, const std::string& name) {
    refuse_changed(folder, joined("tables/", name));
    std::error_code error;
    return std::filesystem::exists(folder / "tables" / name, error);
}

double number(const config::Table& table, std::size_t row, const std::string& column) {
    const std::string& field = table.text(row, column);
    if (field.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const auto value = config::parse_number(field);
    if (!value || std::abs(*value) > largest_figure) {
        refuse(table, row, column, "a number that a run can give, or nothing");
    }
    return *value;
}

double size(const config::Table& table, std::size_t row, const std::string& column) {
    const double value = number(table, row, column);
    if (value < 0.0) {
        refuse(table, row, column, "a number from 0 on, or nothing");
    }
    return value;
}

double count(const config::Table& table, std::size_t row, const std::string& column) {
    const double value = number(table, row, column);
    if (!(value >= 0.0) || value != std::floor(value)) {
        refuse(table, row, column, "a whole number from 0 on");
    }
    return value;
}

std::string climate_of(const config::Table& table, std::size_t row) {
    return table.has("climate") ? table.text(row, "climate") : only_climate;
}

std::string course_name(const std::string& regime, const std::string& climate) {
    return climate.empty() || climate == only_climate ? regime : joined(regime, ", climate ", climate);
}

}  // namespace coupling::compare
