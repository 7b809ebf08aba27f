#include "coupling/assessments/vary/study/plan.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "config/text/words_of_list.hpp"

namespace coupling::vary {

struct FactorRow : Factor {
    std::string listed;  ///< the values as they are written
    std::string how;
};

namespace {

using config::joined;

/// Values as a row lists them: between bars where it has one, else between blanks.
std::vector<std::string> values_in(const std::string& listed) {
    if (listed.find('|') == std::string::npos) {
        return config::words_between_blanks(listed);
    }
    std::vector<std::string> values;
    for (std::size_t from = 0; from <= listed.size();) {
        const std::size_t bar = std::min(listed.find('|', from), listed.size());
        values.emplace_back(config::trimmed(std::string_view{listed}.substr(from, bar - from)));
        from = bar + 1;
    }
    return values;
}

/// All combinations of the crossed factors, the last one moving fastest.
void add_crossed(const std::vector<Factor>& factors, std::size_t place, Combination combination,
                 std::vector<Combination>& all) {
    if (place == factors.size()) {
        all.push_back(std::move(combination));
        return;
    }
    if (!factors[place].crossed) {
        add_crossed(factors, place + 1, std::move(combination), all);
        return;
    }
    for (const std::string& value : factors[place].values) {
        combination.values[place] = value;
        add_crossed(factors, place + 1, combination, all);
    }
}

std::size_t count_of(const std::vector<Factor>& factors) {
    std::size_t alone = 0;
    std::size_t crossed = 1;
    for (const Factor& factor : factors) {
        if (factor.crossed) {
            crossed = std::min(crossed * factor.values.size(), most_combinations + 1);
        } else {
            alone += factor.values.size();
        }
    }
    return 1 + alone + crossed;
}

}  // namespace

std::vector<std::string> Combination::overrides(const std::vector<Factor>& factors) const {
    std::vector<std::string> overrides;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (!values[i].empty()) {
            overrides.push_back(joined(factors[i].setting, "=", values[i]));
        }
    }
    return overrides;
}

const config::Schema<FactorRow>& factor_columns() {
    using R = FactorRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.setting = "vary", .row = "factor", .no_rows = "one row for each setting that is to be varied"},
        {{"setting", &R::setting, "section.key of the scenario", {.unique = true, .advice = "write all its values into one row"}},
         {"values", &R::listed, "that it takes, blanks between; lists as values have bars between them", {.may_be_empty = true}},
         {"how", &R::how, "alone: one value at a time, all else as in the scenario; crossed: with each value of the other crossed ones", {.words = {"alone", "crossed"}}}}};
    // clang-format on
    return columns;
}

std::vector<Factor> read_factors(const config::Table& table) {
    config::RowProblems wrong{table};
    std::vector<Factor> factors;
    for (const config::Read<FactorRow>& row : factor_columns().rows(table, wrong)) {
        if (row.setting.find('.') == std::string::npos) {
            wrong.refuse(row.row, "setting", config::in_quotes(row.setting), "section.key");
        }
        factors.push_back(row);
        factors.back().values = values_in(row.listed);
        const std::vector<std::string>& values = factors.back().values;
        if (values.empty()) {
            wrong.refuse(row.row, "values", "no values", "one or more, separated by blanks");
        } else if (std::ranges::find(values, "") != values.end()) {
            wrong.refuse(row.row, "values", joined("values ", config::in_quotes(row.listed)),
                         "lists with bars between them, none of them empty");
        }
        factors.back().crossed = row.how == "crossed";
        factors.back().place = table.place(row.row, "setting");
    }
    wrong.throw_first();
    if (count_of(factors) > most_combinations) {
        config::fail(config::ExitCode::data, {table.file()},
                     joined("more than ", std::to_string(most_combinations), " combinations"),
                     "fewer values, or how = alone for some settings");
    }
    return factors;
}

std::vector<Combination> combinations_of(const std::vector<Factor>& factors) {
    const Combination scenario{std::vector<std::string>(factors.size()), ""};
    std::vector<Combination> all{scenario};
    for (std::size_t i = 0; i < factors.size(); ++i) {
        for (const std::string& value : factors[i].crossed ? std::vector<std::string>{} : factors[i].values) {
            Combination moved = scenario;
            moved.values[i] = value;
            moved.alone = factors[i].setting;
            all.push_back(std::move(moved));
        }
    }
    if (std::any_of(factors.begin(), factors.end(), [](const Factor& factor) { return factor.crossed; })) {
        add_crossed(factors, 0, scenario, all);
    }
    return all;
}

void IdleFactors::see(const Combination& combination, const config::Options& options) {
    std::map<std::string, std::string> idle;
    for (const config::IdleSettings& settings : options.idle()) {
        for (const std::string& key : settings.keys) {
            idle[key] = joined(settings.other, " is ", settings.value.empty() ? "empty" : settings.value);
        }
    }
    for (std::size_t i = 0; i < factors_.size(); ++i) {
        if (combination.values[i].empty()) {
            continue;
        }
        const auto found = idle.find(factors_[i].setting);
        uses_[i].acts = uses_[i].acts || found == idle.end();
        if (found != idle.end() && uses_[i].other.empty()) {
            uses_[i].other = found->second;
        }
    }
}

void IdleFactors::refuse() const {
    config::Problems problems;
    for (std::size_t i = 0; i < factors_.size(); ++i) {
        if (!uses_[i].acts) {
            problems.add(config::ExitCode::data, factors_[i].place,
                         joined(factors_[i].setting, ", which changes nothing: ", uses_[i].other),
                         "settings that have an effect");
        }
    }
    problems.throw_if_any();
}

}  // namespace coupling::vary
