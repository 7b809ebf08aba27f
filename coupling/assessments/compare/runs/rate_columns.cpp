#include "coupling/assessments/compare/runs/rate_columns.hpp"

#include "config/errors/input_error.hpp"
#include "coupling/results/figures/effect_words.hpp"

namespace coupling::compare {

using config::joined;

std::vector<RateColumn> rate_columns(const config::Table& table, const std::vector<std::string>& wanted) {
    std::vector<RateColumn> columns;
    config::Problems problems;
    for (std::size_t i = 0; i < rockfall::counted_energies_j.size(); ++i) {
        const RateColumn rate{joined("above_", kj_text(i), "_kj")};
        if (table.has(rate.with(""))) {
            for (const std::string& infix : wanted) {
                table.require({rate.with(infix)}, problems);
            }
            columns.push_back(rate);
        }
    }
    problems.throw_if_any();
    return columns;
}

}  // namespace coupling::compare
