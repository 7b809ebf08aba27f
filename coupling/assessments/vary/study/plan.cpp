#include "coupling/assessments/vary/study/plan.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling::vary {

namespace {

using config::joined;

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in{text};
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        words.push_back(word);
    }
    return words;
}

/// Reads rows and collects what is wrong in them.
class FactorReader {
public:
    explicit FactorReader(const config::Table& table) : table_{table} {}

    std::vector<Factor> read() {
        if (table_.require({"setting", "values", "how"}, problems_)) {
            for (std::size_t row = 0; row < table_.rows(); ++row) {
                read_row(row);
            }
            if (table_.rows() == 0) {
                problems_.add(config::ExitCode::data, {table_.file()}, "no settings",
                              "one row for each setting that is to be varied");
            }
        }
        problems_.throw_if_any();
        return std::move(factors_);
    }

private:
    void refuse(std::size_t row, const std::string& column, std::string found, std::string expected) {
        problems_.add(config::ExitCode::data, table_.place(row, column), std::move(found),
                      std::move(expected));
    }

    void read_row(std::size_t row) {
        const std::string& setting = table_.text(row, "setting");
        const std::string& how = table_.text(row, "how");
        const bool again = std::any_of(factors_.begin(), factors_.end(),
                                       [&](const Factor& factor) { return factor.setting == setting; });
        if (setting.find('.') == std::string::npos || again) {
            refuse(row, "setting", joined(config::in_quotes(setting), again ? " a second time" : ""),
                   "section.key, each once");
        }
        if (how != "alone" && how != "crossed") {
            refuse(row, "how", config::in_quotes(how), "alone or crossed");
        }
        Factor factor{setting, words_of(table_.text(row, "values")), how == "crossed",
                      table_.place(row, "setting")};
        if (factor.values.empty()) {
            refuse(row, "values", "no values", "one or more, separated by blanks");
        }
        factors_.push_back(std::move(factor));
    }

    const config::Table& table_;
    std::vector<Factor> factors_;
    config::Problems problems_;
};

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

std::vector<Factor> read_factors(const config::Table& table) {
    std::vector<Factor> factors = FactorReader{table}.read();
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
