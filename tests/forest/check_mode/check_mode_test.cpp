#include "forest/check_mode/check_mode.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "config/text/numbers.hpp"
#include "tests/forest/check_mode/reference.hpp"

namespace forest::check_mode {
namespace {

const std::string beech = "Fagus sylvatica";
const std::string pine = "Pinus sylvestris";

struct Difference {
    double largest = 0.0;         ///< relative
    double largest_stock = 0.0;   ///< of biomass, t/ha
    std::string where;
    std::size_t compared = 0;
};

/// All figures of all months that both programs give. r3PG prints nine digits.
Difference difference(const std::vector<Row>& rows, const config::Table& reference) {
    Difference result;
    EXPECT_EQ(rows.size(), reference.rows());
    for (const Column& column : columns()) {
        if (!reference.has(column.name)) {
            continue;
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto expected = config::parse_number(reference.text(i, column.name));
            if (!expected) {
                continue;
            }
            // What has not been computed before the first month is 0 in r3PG.
            if (i == 0 && *expected == 0.0) {
                continue;
            }
            const double found = column.of(rows[i]);
            const double scale = std::max(std::abs(*expected), 1e-7);
            const double relative = std::abs(found - *expected) / scale;
            if (relative > result.largest) {
                result.largest = relative;
                result.where = std::string{column.name} + " in month " + std::to_string(i) + ": " +
                               std::to_string(found) + " for " + std::to_string(*expected);
            }
            if (column.name.starts_with("biom_") && column.name != "biom_tree" &&
                column.name != "biom_tree_max") {
                result.largest_stock = std::max(result.largest_stock, std::abs(found - *expected));
            }
            ++result.compared;
        }
    }
    return result;
}

TEST(CheckMode, MeetsEveryMonthOfThePineRun) {
    const Difference found = difference(run(demonstration({pine}), {}), reference_table("out_pine_pjs.csv"));
    EXPECT_GT(found.compared, 7000U);
    EXPECT_LT(found.largest, 1e-6) << found.where;
    EXPECT_LT(found.largest_stock, 5e-7);
    std::cout << "largest difference " << found.largest << " (" << found.where << "), biomass "
              << found.largest_stock << " t/ha\n";
}

TEST(CheckMode, MeetsEveryMonthOfTheBeechRun) {
    const Difference found = difference(run(demonstration({beech}), {}), reference_table("out_beech_pjs.csv"));
    EXPECT_GT(found.compared, 7000U);
    EXPECT_LT(found.largest, 1e-6) << found.where;
    EXPECT_LT(found.largest_stock, 5e-7);
    std::cout << "largest difference " << found.largest << " (" << found.where << "), biomass "
              << found.largest_stock << " t/ha\n";
}

}  // namespace
}  // namespace forest::check_mode
