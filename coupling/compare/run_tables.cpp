#include "coupling/compare/run_tables.hpp"

#include <cmath>
#include <limits>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/climate_input.hpp"
#include "coupling/inputs/file_bytes.hpp"

namespace coupling::compare {

using config::joined;

config::Table read_table(const std::filesystem::path& folder, const std::string& name,
                         const std::vector<std::string>& wanted) {
    const std::filesystem::path path = folder / "tables" / name;
    const FileBytes bytes = open_file(path, {}, "a table of the results");
    config::Table table = config::Table::read(bytes.text(), path.string());
    config::Problems problems;
    table.require(wanted, problems);
    problems.throw_if_any();
    return table;
}

namespace {

/// No figure of a run is larger [choice]; one that is comes from damage and would break every axis.
constexpr double largest_figure = 1e15;

double checked_figure(double value, const config::Table& table, std::size_t row, const std::string& column) {
    if (std::abs(value) > largest_figure) {
        config::fail(config::ExitCode::data, table.place(row, column),
                     config::in_quotes(table.text(row, column)), "a figure of a run, at most 1e15",
                     "run the scenario again: the table is damaged");
    }
    return value;
}

}  // namespace

bool has_table(const std::filesystem::path& folder, const std::string& name) {
    std::error_code error;
    return std::filesystem::exists(folder / "tables" / name, error);
}

double number(const config::Table& table, std::size_t row, const std::string& column) {
    const std::string& field = table.text(row, column);
    if (field.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const auto value = config::parse_number(field);
    if (!value) {
        config::fail(config::ExitCode::data, table.place(row, column), config::in_quotes(field),
                     "a number or nothing");
    }
    return checked_figure(*value, table, row, column);
}

double number_from_zero(const config::Table& table, std::size_t row, const std::string& column) {
    const double value = number(table, row, column);
    if (value < 0.0) {
        config::fail(config::ExitCode::data, table.place(row, column),
                     config::in_quotes(table.text(row, column)), "0 or more",
                     "run the scenario again: the table is damaged");
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
