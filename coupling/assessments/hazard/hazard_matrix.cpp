#include "coupling/assessments/hazard/hazard_matrix.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "config/data/shipped_tables.hpp"
#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::hazard {

namespace {
constexpr double endless = std::numeric_limits<double>::infinity();
}  // namespace

struct MatrixRow {
    double energy_from_kj = 0.0;
    double return_period_to_years = endless;
    Level level = Level::none;
};

namespace {

using config::joined;

std::vector<double> sorted_without_doubles(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t place_of(double value, const std::vector<double>& values) {
    return static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

}  // namespace

const config::Schema<MatrixRow>& matrix_columns() {
    using R = MatrixRow;
    using config::above;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "matrix", .setting = "hazard.matrix", .row = "pair of classes"},
        {{"energy_from_kj", &R::energy_from_kj, "from here up to the next class", {.range = {0.0, 1e6}}},
         {"return_period_to_years", &R::return_period_to_years, "the class ends here; empty: without end", {.range = {0.0, 1e6, above}, .may_be_empty = true}},
         {"level", &R::level, "of the hazard", {.words = {level_names.begin(), level_names.end()}}}}};
    // clang-format on
    return columns;
}

Matrix Matrix::read(const config::Table& table) {
    const std::vector<config::Read<MatrixRow>> fields = matrix_columns().all(table);
    Matrix matrix;
    for (const MatrixRow& field : fields) {
        matrix.energy_from_kj_.push_back(field.energy_from_kj);
        matrix.return_period_to_years_.push_back(field.return_period_to_years);
    }
    matrix.energy_from_kj_ = sorted_without_doubles(std::move(matrix.energy_from_kj_));
    matrix.return_period_to_years_ = sorted_without_doubles(std::move(matrix.return_period_to_years_));

    config::RowProblems wrong{table};
    if (fields.empty() || matrix.energy_from_kj_.front() != 0.0) {
        wrong.refuse("no class of energy that begins with 0 kJ", "energy_from_kj 0 in some rows");
    }
    if (fields.empty() || matrix.return_period_to_years_.back() != endless) {
        wrong.refuse("no class of return periods without end",
                     "an empty return_period_to_years in some rows");
    }
    wrong.throw_first();

    std::vector<std::optional<Level>> found(matrix.intensities() * matrix.frequencies());
    for (const config::Read<MatrixRow>& field : fields) {
        std::optional<Level>& level =
            found[place_of(field.energy_from_kj, matrix.energy_from_kj_) * matrix.frequencies() +
                  place_of(field.return_period_to_years, matrix.return_period_to_years_)];
        if (level) {
            wrong.refuse(field.row, "energy_from_kj", "the same pair of classes as above",
                         "one level for each pair");
        }
        level = field.level;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i]) {
            wrong.refuse(joined("no level for ", matrix.intensity_name(i / matrix.frequencies()), " and ",
                                matrix.frequency_name(i % matrix.frequencies())),
                         "a row for each pair of classes");
        }
        matrix.levels_.push_back(found[i].value_or(Level::none));
    }
    wrong.throw_first();
    return matrix;
}

Matrix Matrix::shipped() {
    return read(config::read_shipped_table("hazard_matrix.csv"));
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
