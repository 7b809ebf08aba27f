#include "coupling/compare/run_tables.hpp"

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
    return *value;
}

std::string climate_of(const config::Table& table, std::size_t row) {
    return table.has("climate") ? table.text(row, "climate") : only_climate;
}

std::string course_name(const std::string& regime, const std::string& climate) {
    return climate.empty() || climate == only_climate ? regime : joined(regime, ", climate ", climate);
}

}  // namespace coupling::compare
