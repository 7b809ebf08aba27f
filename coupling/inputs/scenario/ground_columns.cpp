#include "coupling/inputs/scenario/ground_columns.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "config/data/shipped_tables.hpp"

namespace coupling {

rockfall::StopCurve stop_curve(double stop_probability) {
    using Knots = std::vector<std::pair<double, double>>;
    static const Knots factors = [] {
        config::Problems problems;
        std::istringstream in{std::string{config::shipped_table("stopping_size.csv")}};
        const config::Table table = config::Table::read(in, "stopping_size.csv");
        Knots knots;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            knots.emplace_back(table.number(row, "diameter_m", {.low = 0.0}, problems).value_or(1.0),
                               table.number(row, "factor", {.low = 0.0}, problems).value_or(1.0));
        }
        problems.throw_if_any();
        return knots;
    }();
    Knots knots = factors;
    for (auto& [diameter_m, value] : knots) {
        value = std::min(1.0, value * stop_probability);
    }
    return rockfall::StopCurve{std::move(knots)};
}

}  // namespace coupling
