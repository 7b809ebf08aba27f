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

std::string problems(const std::string& text) {
    try {
        static_cast<void>(read(text));
    } catch (const config::InputError& error) {
        return error.what();
    }
    return {};
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

TEST(UseRunYears, RefusesWhatCouldNeverAct) {
    for (const char* year : {"41", "2065", "2023", "2300"}) {
        const std::string text =
            problems(std::string{"treatment,first_year,share\nthin_below,"} + year + ",0.2\n");
        EXPECT_NE(text.find("could never act"), std::string::npos) << year << ": " << text;
        EXPECT_NE(text.find("from 0 to 40"), std::string::npos) << text;
        EXPECT_NE(text.find(year), std::string::npos) << text;
    }
}

TEST(UseRunYears, RefusesBothWaysOfCountingInOneRegime) {
    const std::string text =
        problems("name,treatment,first_year,share\na,thin_below,5,0.2\nb,thin_below,2040,0.2\n");
    EXPECT_NE(text.find("years of the run in a, calendar years in b"), std::string::npos) << text;
}

}  // namespace
}  // namespace coupling::run_years_test
