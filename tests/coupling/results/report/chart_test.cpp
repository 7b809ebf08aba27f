#include "coupling/results/report/chart.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/coupling/results/markup_checks.hpp"

namespace coupling::report {
namespace {

TEST(Axis, FromZeroEndsAtARoundNumber) {
    const Axis axis = Axis::from_zero("Run-out, m", 730.0);
    EXPECT_EQ(axis.low, 0.0);
    EXPECT_DOUBLE_EQ(axis.high, 800.0);
    EXPECT_EQ(axis.ticks().size(), 5U);
}

TEST(Axis, ByPowersOfTenHasOneTickToEach) {
    const Axis axis = Axis::powers_of_ten("Energy, kJ", 0.1, 891.0);
    EXPECT_DOUBLE_EQ(axis.high, 1000.0);
    EXPECT_EQ(axis.ticks().size(), 5U);
    EXPECT_NEAR(axis.share_of(10.0), 0.5, 1e-12);
}

TEST(Axis, OfCountsHasWholeTicks) {
    const Axis axis{"Hits", -0.5, 3.5, false, true};
    EXPECT_EQ(axis.ticks(), (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
}

TEST(Chart, NamesBothAxesAndEverySeries) {
    Chart chart{"Energy", Axis::powers_of_ten("Energy, kJ", 1.0, 500.0),
                Axis::from_zero("% of all rocks", 3.0)};
    const std::array edges{1.0, 10.0, 100.0};
    const std::array heights{2.0, 0.5};
    chart.add_steps("forest", edges, heights);
    chart.add_line("bare", std::array{ChartPoint{1.0, 3.0}, ChartPoint{500.0, 0.1}});
    chart.add_mark(30.0, "30 kJ");
    chart.add_name("forest", "with forest");
    const std::string figure = chart.figure("A caption.");
    for (const char* text : {"Energy, kJ", "% of all rocks", "with forest", "30 kJ", "A caption."}) {
        EXPECT_NE(figure.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(testing::markup_fault(figure), "");
}

TEST(Chart, KeepsMarksOutsideTheAxisAway) {
    Chart chart{"Energy", Axis::powers_of_ten("Energy, kJ", 1.0, 9.0), Axis::from_zero("%", 1.0)};
    chart.add_mark(300.0, "300 kJ");
    EXPECT_EQ(chart.figure("").find("300 kJ"), std::string::npos);
}

}  // namespace
}  // namespace coupling::report
