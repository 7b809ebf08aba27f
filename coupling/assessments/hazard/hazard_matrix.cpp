#include "coupling/assessments/hazard/hazard_matrix.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::hazard {
namespace {

using config::joined;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr config::NumberRange energy_range{.low = 0.0, .high = 1e6};
constexpr config::NumberRange period_range{.low = 0.0, .high = 1e6, .low_excluded = true};

/// A row of the table.
struct Field {
    double energy_from_kj = 0.0;
    double return_period_to_years = endless;
    Level level = Level::none;
    std::size_t row = 0;
};

std::optional<Level> level_of(const config::Table& table, std::size_t row, config::Problems& problems) {
    const std::string& name = table.text(row, "level");
    const auto found = std::find(level_names.begin(), level_names.end(), name);
    if (found == level_names.end()) {
        problems.add(config::ExitCode::data, table.place(row, "level"), config::in_quotes(name),
                     "none, residual, low, moderate or high");
        return std::nullopt;
    }
    return static_cast<Level>(found - level_names.begin());
}

std::vector<Field> read_fields(const config::Table& table) {
    config::Problems problems;
    table.require({"energy_from_kj", "return_period_to_years", "level"}, problems);
    problems.throw_if_any();
    std::vector<Field> fields;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const bool open = table.text(row, "return_period_to_years").empty();
        const auto energy = table.number(row, "energy_from_kj", energy_range, problems);
        const auto period = open ? std::optional{endless}
                                 : table.number(row, "return_period_to_years", period_range, problems);
        const auto level = level_of(table, row, problems);
        if (energy && period && level) {
            fields.push_back({*energy, *period, *level, row});
        }
    }
    problems.throw_if_any();
    return fields;
}

std::vector<double> sorted_without_doubles(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t place_of(double value, const std::vector<double>& values) {
    return static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

}  // namespace

Matrix Matrix::read(const config::Table& table) {
    const std::vector<Field> fields = read_fields(table);
    Matrix matrix;
    for (const Field& field : fields) {
        matrix.energy_from_kj_.push_back(field.energy_from_kj);
        matrix.return_period_to_years_.push_back(field.return_period_to_years);
    }
    matrix.energy_from_kj_ = sorted_without_doubles(std::move(matrix.energy_from_kj_));
    matrix.return_period_to_years_ = sorted_without_doubles(std::move(matrix.return_period_to_years_));

    config::Problems problems;
    const auto refuse = [&](config::Place place, std::string found, std::string expected) {
        problems.add(config::ExitCode::data, std::move(place), std::move(found), std::move(expected));
    };
    if (fields.empty() || matrix.energy_from_kj_.front() != 0.0) {
        refuse({table.file()}, "no class of energy that begins with 0 kJ", "energy_from_kj 0 in some rows");
    }
    if (fields.empty() || matrix.return_period_to_years_.back() != endless) {
        refuse({table.file()}, "no class of return periods without end",
               "an empty return_period_to_years in some rows");
    }
    problems.throw_if_any();

    std::vector<std::optional<Level>> found(matrix.intensities() * matrix.frequencies());
    for (const Field& field : fields) {
        std::optional<Level>& level =
            found[place_of(field.energy_from_kj, matrix.energy_from_kj_) * matrix.frequencies() +
                  place_of(field.return_period_to_years, matrix.return_period_to_years_)];
        if (level) {
            refuse(table.place(field.row, "energy_from_kj"), "the same pair of classes as above",
                   "one level for each pair");
        }
        level = field.level;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i]) {
            refuse({table.file()},
                   joined("no level for ", matrix.intensity_name(i / matrix.frequencies()), " and ",
                          matrix.frequency_name(i % matrix.frequencies())),
                   "a row for each pair of classes");
        }
        matrix.levels_.push_back(found[i].value_or(Level::none));
    }
    problems.throw_if_any();
    return matrix;
}

Matrix Matrix::shipped() {
    std::istringstream in{std::string{config::shipped_table("hazard_matrix.csv")}};
    return read(config::Table::read(in, "hazard_matrix.csv"));
}

std::size_t Matrix::intensity_of(double energy_kj) const {
    const auto above = std::upper_bound(energy_from_kj_.begin(), energy_from_kj_.end(), energy_kj);
    return static_cast<std::size_t>(above - energy_from_kj_.begin()) - 1;
}

std::size_t Matrix::frequency_of(double return_period_years) const {
    const auto first =
        std::lower_bound(return_period_to_years_.begin(), return_period_to_years_.end(), return_period_years);
    return static_cast<std::size_t>(first - return_period_to_years_.begin());
}

std::string Matrix::intensity_name(std::size_t intensity) const {
    const std::string from = config::to_text(energy_from_kj_[intensity]);
    if (intensity + 1 == intensities()) {
        return joined("from ", from, " kJ");
    }
    const std::string to = config::to_text(energy_from_kj_[intensity + 1]);
    return intensity == 0 ? joined("below ", to, " kJ") : joined(from, " to ", to, " kJ");
}

std::string Matrix::frequency_name(std::size_t frequency) const {
    const std::string to = config::to_text(return_period_to_years_[frequency]);
    if (frequency == 0) {
        return frequencies() == 1 ? "any return period" : joined("up to ", to, " years");
    }
    const std::string from = config::to_text(return_period_to_years_[frequency - 1]);
    return frequency + 1 == frequencies() ? joined("over ", from, " years")
                                          : joined(from, " to ", to, " years");
}

}  // namespace coupling::hazard
