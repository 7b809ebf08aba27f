#include "coupling/exchange/regimes/run_years.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::run_years_test {
namespace {

/// From 2024 (the start) to 2064.
constexpr RunYears forty_years{2024, 40};

Regime read(const std::string& text) {
    return Regime::read(table_of(text), "regime", species_table(), two_stands(4), one_polygon, forty_years);
}

TEST(UseRunYears, TakesCalendarYears) {
    const Regime regime = read(
        "name,treatment,first_year,every_years,last_year,share\n"
        "early,thin_below,2030,10,2055,0.2\nat_start,clear_cut,2024,,,\n");
    EXPECT_EQ(regime.interventions()[0].first_year, 6);
    EXPECT_EQ(regime.interventions()[0].last_year, 31);
    EXPECT_EQ(regime.interventions()[1].first_year, 0);
}

TEST(UseRunYears, KeepsYearsOfTheRun) {
    const Regime regime = read("treatment,first_year,last_year,share\nthin_below,40,90,0.2\n");
    EXPECT_EQ(regime.interventions()[0].first_year, 40);
    EXPECT_EQ(regime.interventions()[0].last_year, 90) << "a turn that the end of the run cuts off";
}

}  // namespace
}  // namespace coupling::run_years_test
