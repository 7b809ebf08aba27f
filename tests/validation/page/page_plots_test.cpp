#include <gtest/gtest.h>

#include <sstream>

#include "tests/coupling/results/markup_checks.hpp"
#include "validation/engine/page/page.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation::page_plots_test {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t times = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++times;
    }
    return times;
}

Plot plot_named(const std::string& title) {
    return {.title = title,
            .x = {"Age, years", 0.0, 100.0},
            .y = {"Volume, m3/ha", 0.0, 1000.0},
            .series = {{"ours", "default", PlotSeries::Form::line, {{0.0, 0.0}, {100.0, 500.0}}, {}},
                       {"table", "published", PlotSeries::Form::dots, {{50.0, 300.0}, {90.0, 400.0}}, {}},
                       {"range", "strict", PlotSeries::Form::band, {}, {{0.0, 1.0, 2.0}, {9.0, 1.0, 3.0}}}},
            .labels = {{100.0, 500.0, "500 m <low>"}},
            .caption = "one & all"};
}

CaseResult with_plots() {
    CaseResult result;
    result.name = "grown";
    result.has_strict = false;
    result.plots = {{"Over age", {plot_named("first"), plot_named("second")}, false}};
    result.tables = {{"Stands <all>", {"site", "volume, m3/ha"}, {{"a", "300"}, {"b", "400"}}}};
    return result;
}

TEST(PlotsPart, DrawsEverySeriesAndNamesItOnce) {
    const std::string html = plots_part(with_plots());
    EXPECT_EQ(count(html, "<figure"), 2U);
    EXPECT_EQ(count(html, "Age, years</text>"), 2U);
    EXPECT_EQ(count(html, "Volume, m3/ha</text>"), 2U);
    EXPECT_EQ(count(html, "</svg>table</li>"), 1U);
    EXPECT_EQ(count(html, "<circle class=\"dot published\""), 5U) << "two in each plot, one in the names";
    EXPECT_EQ(count(html, "<path class=\"band strict\""), 3U);
    EXPECT_EQ(count(html, "500 m &lt;low&gt;</text>"), 2U);
}

TEST(PlotsPart, IsWellFormedOnThePage) {
    const CaseResult result = with_plots();
    std::ostringstream out;
    write_validation_page(out, {&result, 1});
    EXPECT_EQ(coupling::text_checks::markup_fault(out.str()), "");
    EXPECT_NE(out.str().find("<td>a</td><td>300</td>"), std::string::npos);
    EXPECT_EQ(out.str().find("strict</b> meets"), std::string::npos) << "no case has it";
    EXPECT_EQ(plots_part({}), "");
}

}  // namespace
}  // namespace coupling::validation::page_plots_test
