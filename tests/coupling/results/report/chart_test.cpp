#include "coupling/results/report/chart.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "tests/coupling/results/markup_checks.hpp"

namespace coupling::report::chart_test {
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

// Whatever is drawn, even numbers of damaged results: memory and drawing stay bounded.
TEST(Axis, HasFewTicks) {
    for (const double high : {1e-300, 1.0, 1e15, 1e300, std::numeric_limits<double>::infinity()}) {
        for (const double low : {-1e308, -1.0, 0.0}) {
            EXPECT_LE((Axis{"a", low, high}.ticks().size()), 20U) << low << " " << high;
        }
        EXPECT_LE(Axis::from_zero("a", high).ticks().size(), 20U) << high;
        EXPECT_LE(Axis::powers_of_ten("a", 1e-300, high).ticks().size(), 20U) << high;
    }
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
    EXPECT_EQ(text_checks::markup_fault(figure), "");
}

/// The number that follows a text, from a place on.
double number_behind(const std::string& svg, const std::string& text, std::size_t from) {
    const std::size_t at = svg.find(text, from);
    return at == std::string::npos ? -1.0 : std::stod(svg.substr(at + text.size()));
}

/// However long a title is and however wide a font: it stays within the view of 430 by 292 from 18 on.
TEST(Chart, KeepsTitlesOfAxesInTheDrawing) {
    constexpr double widest_letter = 7.8;  // of 13 px
    for (std::size_t letters = 1; letters <= 200; ++letters) {
        const std::string title(letters, 'm');
        const std::string svg = Chart{"Title", Axis{title, 0.0, 1.0}, Axis{title, 0.0, 1.0}}.figure("");
        const std::size_t below = svg.find("class=\"axis-title\"");
        const std::size_t beside = svg.find("class=\"axis-title\"", below + 1);
        ASSERT_NE(beside, std::string::npos);
        const auto half = [&](std::size_t at) {
            const std::string tag = svg.substr(at, svg.find('>', at) - at);
            const double length = number_behind(tag, "textLength=\"", 0);
            return 0.5 * (length > 0.0 ? length : widest_letter * static_cast<double>(letters));
        };
        const double x = number_behind(svg, "x=\"", svg.rfind("<text", below));
        EXPECT_GE(x - half(below), 0.0) << letters;
        EXPECT_LE(x + half(below), 430.0) << letters;
        const double y = number_behind(svg, "translate(14 ", beside);
        EXPECT_GE(y - half(beside), 18.0) << letters;
        EXPECT_LE(y + half(beside), 310.0) << letters;
        // Short ones stand in the middle of their axis, and are written as they are.
        EXPECT_EQ(svg.find("textLength") == std::string::npos, letters <= 36) << letters;
        if (letters <= 20) {
            EXPECT_EQ(x, 240.0) << letters;
            EXPECT_EQ(y, 148.0) << letters;
        }
    }
}

TEST(Chart, DrawsABandAsOneClosedRim) {
    Chart chart{"Jumps", Axis{"Distance, m", 0.0, 10.0}, Axis{"Length, m", 0.0, 10.0}};
    chart.add_band("strict", std::array{ChartRange{0.0, 0.0, 10.0}, ChartRange{10.0, 0.0, 10.0}});
    // 336 x 228 units of drawing: along the top, down, and back along the bottom.
    EXPECT_NE(chart.figure("").find("<path class=\"band strict\" d=\"M72 34l336 0l0 228l-336 0\"/>"),
              std::string::npos)
        << chart.figure("");
}

TEST(Chart, DrawsNoBandOfNothing) {
    Chart chart{"Jumps", Axis{"Distance, m", 0.0, 10.0}, Axis{"Length, m", 0.0, 10.0}};
    chart.add_band("strict", {});
    EXPECT_EQ(chart.figure("").find("band"), std::string::npos);
}

TEST(Chart, PutsDotsAndWhiskersWhereTheirValuesAre) {
    Chart chart{"Jumps", Axis{"Distance, m", 0.0, 10.0}, Axis{"Length, m", 0.0, 10.0}};
    chart.add_dots("observed", std::array{ChartPoint{5.0, 5.0}});
    chart.add_whiskers("observed", std::array{ChartRange{5.0, 0.0, 10.0}});
    const std::string figure = chart.figure("");
    EXPECT_NE(figure.find("<circle class=\"dot observed\" cx=\"240\" cy=\"148\""), std::string::npos)
        << figure;
    EXPECT_NE(figure.find("M240 262V34M237 262h6M237 34h6"), std::string::npos) << figure;
}

TEST(Chart, ListsNamesThatDoNotFitIntoTheDrawing) {
    Chart chart{"Run-out", Axis{"Distance, m", 0.0, 10.0}, Axis{"%", 0.0, 10.0}};
    chart.add_name("strict", "strict");
    EXPECT_EQ(chart.figure("").find("<ul"), std::string::npos);
    chart.add_band_name("strict", "strict, 90 % of series");
    chart.add_dot_name("observed", "observed");
    const std::string figure = chart.figure("");
    EXPECT_NE(figure.find("<ul class=\"names\">"), std::string::npos);
    for (const char* sample : {"line strict", "band strict", "dot observed"}) {
        EXPECT_NE(figure.find(sample), std::string::npos) << sample;
    }
    EXPECT_EQ(text_checks::markup_fault(figure), "");
}

TEST(Chart, KeepsMarksOutsideTheAxisAway) {
    Chart chart{"Energy", Axis::powers_of_ten("Energy, kJ", 1.0, 9.0), Axis::from_zero("%", 1.0)};
    chart.add_mark(300.0, "300 kJ");
    EXPECT_EQ(chart.figure("").find("300 kJ"), std::string::npos);
}

}  // namespace
}  // namespace coupling::report::chart_test
