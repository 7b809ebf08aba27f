#include "coupling/results/figures/model_verdicts.hpp"

#include <algorithm>

#include "config/data/shipped_tables.hpp"
#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

void add_row(const config::Table& table, std::size_t row, QuantityVerdict& to) {
    config::Problems problems;
    const auto count = [&](const char* column) {
        return static_cast<std::uint64_t>(table.number(row, column, {}, problems).value_or(0.0));
    };
    to.met += count("met");
    to.missed += count("missed");
    to.independent_met += count("independent_met");
    to.independent_missed += count("independent_missed");
    problems.throw_if_any();
}

}  // namespace

std::vector<QuantityVerdict> verdicts_on(std::string_view model) {
    std::vector<QuantityVerdict> verdicts;
    for (const std::string_view quantity : judged_quantities) {
        verdicts.push_back({.quantity = std::string{quantity}});
    }
    const config::Table table = config::read_shipped_table("model_verdicts.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "model") != model) {
            continue;
        }
        const auto verdict = std::find_if(verdicts.begin(), verdicts.end(), [&](const QuantityVerdict& one) {
            return one.quantity == table.text(row, "quantity");
        });
        if (verdict != verdicts.end()) {
            add_row(table, row, *verdict);
        }
    }
    return verdicts;
}

std::string verdicts_in_words(std::string_view model) {
    std::string judged;
    std::string others;
    for (const QuantityVerdict& one : verdicts_on(model)) {
        if (one.independent() > 0) {
            judged += joined(judged.empty() ? "" : ", ", one.quantity, " ",
                             std::to_string(one.independent_met), " of ", std::to_string(one.independent()));
        } else {
            others += joined(others.empty() ? "" : ", ", one.quantity);
        }
    }
    return joined(judged, others.empty() ? "" : joined(judged.empty() ? "" : "; ", "not judged: ", others));
}

}  // namespace coupling
