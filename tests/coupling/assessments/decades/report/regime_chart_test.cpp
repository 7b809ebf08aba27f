#include "coupling/assessments/decades/report/regime_chart.hpp"

#include <gtest/gtest.h>

#include "config/text/joined.hpp"
#include "tests/coupling/results/markup_checks.hpp"

namespace coupling::decades::regime_chart_test {
namespace {

using config::joined;

std::vector<RegimeCurve> curves_of(std::size_t count) {
    std::vector<RegimeCurve> curves;
    for (std::size_t i = 0; i < count; ++i) {
        curves.push_back({.line = i,
                          .name = joined("regime ", std::to_string(i)),
                          .letter = std::string(1, static_cast<char>('A' + i)),
                          .means = {{0.0, 50.0}, {10.0, 60.0}},
                          .ranges = {{0.0, 40.0, 55.0}, {10.0, 45.0, 70.0}}});
    }
    return curves;
}

TEST(RegimeChart, GivesEachRegimeItsLineNameAndLetter) {
    const std::string svg =
        regime_charts({.title = "Reach", .y_title = "% of rocks", .years = 10}, curves_of(2), "");
    EXPECT_EQ(text_checks::markup_fault(svg), "");
    for (const char* part :
         {"line regime0", "line regime1", "regime 1</li>", ">A</text>", ">B</text>", "Years since the start",
          "% of rocks", "band regime1", "90 % interval of the mean"}) {
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    }
}

TEST(RegimeChart, DropsBandsThatWouldHideEachOther) {
    EXPECT_EQ(regime_charts({.title = "Reach", .y_title = "%", .years = 10}, curves_of(5), "").find("band"),
              std::string::npos);
}

TEST(RegimeChart, KeepsTheLineOfARegimeWhereOthersAreMissing) {
    std::vector<RegimeCurve> curves = curves_of(3);
    curves.erase(curves.begin(), curves.begin() + 2);
    EXPECT_NE(regime_charts({.title = "Reach", .y_title = "%", .years = 10}, curves, "").find("line regime2"),
              std::string::npos);
}

TEST(RegimeChart, IsAnEmptyFrameWithoutCurves) {
    EXPECT_EQ(text_checks::markup_fault(regime_charts({.title = "Reach", .y_title = "%"}, {}, "")), "");
}

TEST(RegimeChart, GivesEachClimateAChartAtTheSameScale) {
    std::vector<RegimeCurve> curves = curves_of(2);
    for (RegimeCurve curve : curves_of(2)) {
        curve.climate = 1;
        curve.means.back().y = 500.0;
        curves.push_back(curve);
    }
    const auto charts = [&](const std::vector<RegimeCurve>& of_curves) {
        return regime_charts({.title = "Reach", .y_title = "%", .years = 10, .climates = {"present", "warm"}},
                             of_curves, "");
    };
    const std::string svg = charts(curves);
    EXPECT_EQ(text_checks::markup_fault(svg), "");
    const std::size_t present = svg.find("Reach, climate present");
    const std::size_t warm = svg.find("Reach, climate warm");
    ASSERT_NE(warm, std::string::npos);
    EXPECT_LT(present, warm);
    EXPECT_NE(svg.substr(present, warm - present).find(">500<"), std::string::npos)
        << "the scale of the other climate";
    EXPECT_NE(svg.find("band"), std::string::npos) << "two lines a chart leave room for bands";
    EXPECT_EQ(charts(curves_of(2)).find("climate warm"), std::string::npos) << "nothing ran there";
}

}  // namespace
}  // namespace coupling::decades::regime_chart_test
