#include "validation/engine/factors/factor_plan.hpp"

#include <algorithm>
#include <functional>
#include <numbers>
#include <optional>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::validation {
namespace {

using config::joined;

constexpr const char* factors_file = "factors.csv";
constexpr const char* directions_file = "directions.csv";
constexpr const char* dbh_mean = "stand.dbh_mean_cm";

/// The recipe's own value of a setting that is a number; nothing for any other.
std::optional<double> base_value_in(const Recipe& recipe, const std::string& setting) {
    for (const config::ParameterRow& row : recipe.options->rows()) {
        if (row.key == setting) {
            return config::parse_number(row.value_text);
        }
    }
    return std::nullopt;
}

struct VariedRow {
    std::string setting;
    std::vector<double> values;
    std::string how;
};

struct ExpectedRow {
    std::string figure;
    std::string setting;
    std::string expected;
    std::string source;
};

// clang-format off
config::Schema<VariedRow> factor_columns() {
    using R = VariedRow;
    return {{.setting = factors_file, .row = "factor"},
            {{"setting", &R::setting, "of case.ini"},
             {"values", &R::values, "that it takes, rising"},
             {"how", &R::how, "with all other crossed ones, or alone", {.words = {"crossed", "alone"}}}}};
}

config::Schema<ExpectedRow> direction_columns() {
    using R = ExpectedRow;
    return {{.setting = directions_file, .row = "direction"},
            {{"figure", &R::figure, "of the case", {.words = factor_figures()}},
             {"setting", &R::setting, "as it grows"},
             {"expected", &R::expected, "what the figure does", {.words = {"rises", "falls"}}},
             {"source", &R::source, "who says so", {.may_be_empty = true}}}};
}
// clang-format on

/// Reads both tables and collects what is wrong in them.
class PlanReader {
public:
    PlanReader(const CaseFiles& files, const Recipe& recipe) : files_{files}, recipe_{recipe} {}

    FactorPlan read() {
        table(factors_file, factor_columns(), &PlanReader::read_factor);
        table(directions_file, direction_columns(), &PlanReader::read_direction);
        problems_.throw_if_any();
        return std::move(plan_);
    }

private:
    template <class Row>
    void table(const std::string& file, const config::Schema<Row>& columns,
               void (PlanReader::*read_row)(const config::Table&, const config::Read<Row>&)) {
        try {
            const config::Table rows = files_.table(file);
            for (const config::Read<Row>& row : columns.rows(rows, problems_)) {
                (this->*read_row)(rows, row);
            }
        } catch (const config::InputError& error) {
            problems_.add(error);
        }
    }

    void refuse(const config::Table& table, std::size_t row, const std::string& column,
                std::string expected) {
        problems_.add(config::ExitCode::data, table.place(row, column),
                      config::in_quotes(table.text(row, column)), std::move(expected));
    }

    void read_factor(const config::Table& table, const config::Read<VariedRow>& row) {
        Factor factor{recipe_.options->present_name(row.setting), row.values, row.how == "crossed"};
        const std::optional<double> base = base_value_in(recipe_, factor.setting);
        if (!base || plan_.place_of(factor.setting) < plan_.factors.size()) {
            refuse(table, row.row, "setting", "a setting of case.ini that is a number, once");
        }
        const auto& values = factor.values;
        if (values.size() < 2 ||
            std::adjacent_find(values.begin(), values.end(), std::greater_equal<>{}) != values.end()) {
            refuse(table, row.row, "values", "two or more rising numbers with blanks between them");
        }
        plan_.base.push_back(base.value_or(0.0));
        plan_.factors.push_back(std::move(factor));
    }

    void read_direction(const config::Table& table, const config::Read<ExpectedRow>& row) {
        const std::string setting = recipe_.options->present_name(row.setting);
        if (setting != basal_area && plan_.place_of(setting) == plan_.factors.size()) {
            refuse(table, row.row, "setting", joined("a setting of ", factors_file, " or ", basal_area));
        }
        plan_.directions.push_back({row.figure, setting, row.expected == "rises", row.source});
    }

    const CaseFiles& files_;
    const Recipe& recipe_;
    FactorPlan plan_;
    config::Problems problems_;
};

}  // namespace

std::vector<Combination> FactorPlan::combinations() const {
    std::vector<Combination> all{base};
    for (std::size_t f = 0; f < factors.size(); ++f) {
        if (!factors[f].crossed) {
            continue;
        }
        std::vector<Combination> more;
        for (const Combination& combination : all) {
            for (const double value : factors[f].values) {
                more.push_back(combination);
                more.back()[f] = value;
            }
        }
        all = std::move(more);
    }
    for (std::size_t f = 0; f < factors.size(); ++f) {
        for (const double value : factors[f].values) {
            if (!factors[f].crossed) {
                all.push_back(base);
                all.back()[f] = value;
            }
        }
    }
    return all;
}

std::string FactorPlan::alone_at(std::size_t place) const {
    std::size_t first = 1;
    for (const Factor& factor : factors) {
        first *= factor.crossed ? factor.values.size() : 1;
    }
    for (const Factor& factor : factors) {
        first += factor.crossed ? 0 : factor.values.size();
        if (!factor.crossed && place < first && place + factor.values.size() >= first) {
            return factor.setting;
        }
    }
    return "";
}

bool FactorPlan::is_crossed(const Combination& combination) const {
    for (std::size_t f = 0; f < factors.size(); ++f) {
        const std::vector<double>& values = factors[f].values;
        const bool takes_value = std::find(values.begin(), values.end(), combination[f]) != values.end();
        if (factors[f].crossed ? !takes_value : combination[f] != base[f]) {
            return false;
        }
    }
    return true;
}

std::size_t FactorPlan::place_of(const std::string& setting) const {
    const auto found = std::find_if(factors.begin(), factors.end(),
                                    [&](const Factor& factor) { return factor.setting == setting; });
    return static_cast<std::size_t>(found - factors.begin());
}

std::vector<std::string> FactorPlan::overrides(const Combination& combination, const Recipe& recipe) const {
    std::vector<std::string> texts;
    for (std::size_t f = 0; f < factors.size(); ++f) {
        texts.push_back(joined(factors[f].setting, "=", config::to_text(combination[f])));
        if (factors[f].setting == dbh_mean) {
            const double deviation_cm = recipe.dbh_deviation_cm / recipe.dbh_mean_cm * combination[f];
            texts.push_back(joined("stand.dbh_deviation_cm=", config::to_text(deviation_cm)));
        }
    }
    return texts;
}

const std::vector<std::string>& factor_figures() {
    static const std::vector<std::string> names{"protection_effect", "energy_kept_share",
                                                "residual_energy_kj", "hits_per_rock", "free_path_m"};
    return names;
}

FactorPlan read_factor_plan(const CaseFiles& files, const Recipe& recipe) {
    return PlanReader{files, recipe}.read();
}

double basal_area_m2pha(double stems_per_ha, double dbh_mean_cm, double dbh_deviation_cm) {
    constexpr double m2_per_cm2 = 1e-4;
    return stems_per_ha * 0.25 * std::numbers::pi * m2_per_cm2 *
           (dbh_mean_cm * dbh_mean_cm + dbh_deviation_cm * dbh_deviation_cm);
}

}  // namespace coupling::validation
