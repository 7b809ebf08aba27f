#include "validation/engine/field/field_trends.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

namespace coupling::validation::field_trends_test {
namespace {

const std::vector<std::string> states{"low", "middle", "high"};

config::Table table_of(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "trends.csv");
}

Trend rising_ways() {
    return {"ways", &way_figures().front(), states, "made up"};
}

TrendFound found_in(const std::map<std::string, std::vector<RockWay>>& ways) {
    return find_trend(rising_ways(),
                      [&](const std::string& state) -> std::span<const RockWay> { return ways.at(state); });
}

TEST(FieldTrends, CountStepsThatFallByMoreThanTheirInterval) {
    // Means 10, 5, 20 with standard errors of 1: only the first step goes against the trend.
    const TrendFound found = found_in({{"low", {{9.0, 0.0}, {11.0, 0.0}}},
                                       {"middle", {{4.0, 0.0}, {6.0, 0.0}}},
                                       {"high", {{19.0, 0.0}, {21.0, 0.0}}}});
    EXPECT_EQ(found.steps_against, 1);
    EXPECT_EQ(found.means, (std::vector<double>{10.0, 5.0, 20.0}));
    EXPECT_NEAR(found.change_low, 10.0 - 1.96 * std::sqrt(2.0), 1e-12);
}

TEST(FieldTrends, LetStepsWithinTheirIntervalPass) {
    const TrendFound found = found_in({{"low", {{8.0, 0.0}, {12.0, 0.0}}},
                                       {"middle", {{7.0, 0.0}, {11.0, 0.0}}},
                                       {"high", {{8.0, 0.0}, {12.0, 0.0}}}});
    EXPECT_EQ(found.steps_against, 0);
    EXPECT_LT(found.change_low, 0.0);
}

TEST(FieldTrends, KnowNothingOfStatesWithOneRock) {
    const TrendFound found = found_in(
        {{"low", {{8.0, 0.0}}}, {"middle", {{7.0, 0.0}, {11.0, 0.0}}}, {"high", {{8.0, 0.0}, {12.0, 0.0}}}});
    EXPECT_TRUE(std::isnan(found.steps_against));
}

TEST(FieldTrends, NameTheirFiguresByPreset) {
    Comparison comparison;
    name_trend(rising_ways(), "", comparison);
    name_trend(rising_ways(), "unity_compat.", comparison);
    ASSERT_EQ(comparison.figures.size(), 4U);
    EXPECT_EQ(comparison.figures[0].name, "steps_against:ways");
    EXPECT_EQ(comparison.figures[3].name, "unity_compat.change_low:ways");
    EXPECT_EQ(comparison.figures[3].unit, "m");
}

TEST(FieldTrends, ReportUnknownFiguresStatesAndLoneStates) {
    config::Problems problems;
    const auto trends = read_trends(table_of("trend,figure,states,source\n"
                                             "a,displacement_m,low middle high,x\n"
                                             "b,distance,low high,x\n"
                                             "c,max_speed_mps,low hihg,x\n"
                                             "d,max_speed_mps,low,x\n"),
                                    states, problems);
    EXPECT_EQ(trends.size(), 3U);
    try {
        problems.throw_if_any();
        FAIL() << "no problem found";
    } catch (const config::InputError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("trends.csv:3"), std::string::npos) << what;
        EXPECT_NE(what.find("displacement_m or max_speed_mps"), std::string::npos) << what;
        EXPECT_NE(what.find("hihg"), std::string::npos) << what;
        EXPECT_NE(what.find("fewer than two states"), std::string::npos) << what;
    }
}

}  // namespace
}  // namespace coupling::validation::field_trends_test
