#include "validation/engine/page/page.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <sstream>

#include "tests/coupling/results/markup_checks.hpp"
#include "tests/validation/sample_cases.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation::page_test {
namespace {

std::string page_of(std::span<const CaseResult> cases) {
    std::ostringstream out;
    write_validation_page(out, cases);
    return out.str();
}

std::string full_page() {
    return page_of(std::array{testing::forested_case(), testing::bare_case()});
}

/// The part of the page from one text to the next occurrence of another.
std::string between(const std::string& page, const std::string& from, const std::string& to) {
    const std::size_t first = page.find(from);
    return first == std::string::npos ? "" : page.substr(first, page.find(to, first + from.size()) - first);
}

TEST(WriteValidationPage, IsWellFormedWhateverACaseLacks) {
    EXPECT_EQ(coupling::text_checks::markup_fault(full_page()), "");
    EXPECT_EQ(coupling::text_checks::markup_fault(page_of({})), "");
    EXPECT_EQ(coupling::text_checks::markup_fault(page_of(std::array{CaseResult{}})), "");
}

TEST(WriteValidationPage, ReachesOutToNothing) {
    const std::string page = coupling::text_checks::without_scripts(full_page());
    for (const char* outside : {"http:", "https:", "url(", "<link", "@import", "javascript:"}) {
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    }
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(WriteValidationPage, OpensWithTheCriteriaMet) {
    const std::string opening = between(full_page(), "<h1>", "<h2>");
    // Strict meets tree hits (rebuilding) and the 90 % height (independent); it misses speed and run-out.
    EXPECT_NE(opening.find("<b>strict</b> meets <b>2 of 4</b> criteria, of the independent ones 1 of 3"),
              std::string::npos)
        << opening;
    EXPECT_NE(opening.find("<b>default</b> meets <b>4 of 4</b>, of the independent ones 3 of 3"),
              std::string::npos);
    EXPECT_NE(opening.find("<td class=\"text\">mean speed, m/s</td><td class=\"text\">none</td>"),
              std::string::npos)
        << "which are missed";
}

TEST(WriteValidationPage, OfOwnCasesDoesNotSpeakOfPublishedOnes) {
    std::array cases{testing::forested_case(), testing::bare_case()};
    EXPECT_NE(page_of(cases).find("<h1>Bannwald against the published cases</h1>"), std::string::npos);
    for (CaseResult& result : cases) {
        result.is_own = true;
    }
    const std::string page = page_of(cases);
    EXPECT_NE(page.find("<h1>Bannwald against own cases</h1>"), std::string::npos);
    EXPECT_NE(page.find("Criteria are those of criteria.csv"), std::string::npos);
    EXPECT_EQ(page.find("before our model was run"), std::string::npos);
}

TEST(WriteValidationPage, LinksToEachCaseOnce) {
    const std::string page = full_page();
    std::set<std::string> ids;
    for (std::size_t at = page.find(" id=\""); at != std::string::npos; at = page.find(" id=\"", at + 1)) {
        const std::string id = page.substr(at + 5, page.find('"', at + 5) - at - 5);
        EXPECT_TRUE(ids.insert(id).second) << id;
        EXPECT_NE(page.find("href=\"#" + id + '"'), std::string::npos) << id;
    }
    EXPECT_EQ(ids.size(), 2U);
}

TEST(WriteValidationPage, EscapesWhatTheFoldersSay) {
    const std::string page = full_page();
    EXPECT_NE(page.find("Site 2 &lt;forested&gt;"), std::string::npos);
    EXPECT_NE(page.find("rocks lose &lt;too much&gt; at stems"), std::string::npos);
    EXPECT_NE(page.find("replaced by &lt;surveyed&gt;.csv"), std::string::npos);
}

TEST(VerdictTable, SaysEachVerdictInAWord) {
    const std::string table = verdict_table(testing::forested_case());
    EXPECT_NE(
        table.find("4.90 <span class=\"badge missed\">missed</span><small>4.80\u00a0±\u00a00.40</small>"),
        std::string::npos)
        << table;
    EXPECT_NE(table.find("7.60 <span class=\"badge\">met</span>"), std::string::npos);
    EXPECT_NE(table.find("1.30 to 2.20"), std::string::npos);
}

TEST(VerdictTable, GivesEachSourceOneNumber) {
    const std::string table = verdict_table(testing::forested_case());
    EXPECT_NE(table.find("8.00<sup title=\"Rammer et al. 2010, Table 3\">1</sup>"), std::string::npos);
    EXPECT_NE(table.find("1.20<sup title=\"Rammer et al. 2010, Table 3\">1</sup>"), std::string::npos);
    const std::string notes = between(table, "<ol", "</ol>");
    const std::size_t first = notes.find("Rammer et al. 2010, Table 3");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(notes.find("Rammer", first + 1), std::string::npos);
}

TEST(Misses, AreSpelledOutWithTheirCause) {
    const std::string text = misses(testing::forested_case());
    EXPECT_NE(
        text.find("<b>mean speed, m/s</b>: strict 4.90 instead of 5.60 to 8.00. Likely cause: the taper"),
        std::string::npos)
        << text;
    EXPECT_NE(misses(testing::bare_case()).find("strict – instead of 435 to 471. The cause is not known."),
              std::string::npos);
    CaseResult met = testing::forested_case();
    met.rows.erase(met.rows.begin());
    EXPECT_EQ(misses(met), "");
}

TEST(Nearness, CountsRowsThatAreObservedAndPublished) {
    // Of speed, hits and largest height default is nearer in speed (0.4 against 1.2 off) and height;
    // published hits are exact. Strict is nearer nowhere.
    const Nearness found = nearness(testing::forested_case());
    EXPECT_EQ(found.compared, 3U);
    EXPECT_EQ(found.ours, 2U);
    EXPECT_EQ(found.strict, 0U);
    EXPECT_EQ(nearness(testing::bare_case()).compared, 0U);
    const std::string page = full_page();
    EXPECT_NE(page.find("Of 3 figures"), std::string::npos);
    EXPECT_NE(page.find("in <b>2</b>, strict in 0"), std::string::npos);
    EXPECT_EQ(page_of(std::array{testing::bare_case()}).find("both observed and published"),
              std::string::npos);
}

TEST(VariantsTable, PutsAllVariantsBesideWhatWasObserved) {
    const std::string table = variants_table(testing::forested_case());
    EXPECT_NE(
        table.find("<td>largest rebound height, m</td><td>2.00</td><td>7.90</td><td>7.00</td><td>5.60</td>"
                   "<td>10.5</td>"),
        std::string::npos)
        << table;
    EXPECT_EQ(variants_table(testing::bare_case()), "");
}

TEST(ChoicesTable, MarksWhereAVerdictTurns) {
    const std::string table = choices_table(testing::forested_case());
    EXPECT_NE(table.find("of 0 of 3 criteria in strict and of 1 in default"), std::string::npos) << table;
    EXPECT_NE(table.find("<td>7.70 <span class=\"badge\">met</span></td>"), std::string::npos)
        << "nothing moved";
    EXPECT_NE(table.find("<b>8.30</b> <span class=\"badge missed\">missed</span>"), std::string::npos);
    EXPECT_NE(table.find("<td>5.20</td>"), std::string::npos) << "still missed in strict: nothing turns";
    EXPECT_EQ(choices_table(testing::bare_case()), "");
}

TEST(CaseCharts, EachHasATitleAxesWithUnitsAndALegend) {
    const std::string charts = case_charts(testing::forested_case());
    std::size_t figures = 0;
    for (std::size_t at = charts.find("<figure"); at != std::string::npos;
         at = charts.find("<figure", at + 1)) {
        const std::string figure = charts.substr(at, charts.find("</figure>", at) - at);
        ++figures;
        EXPECT_NE(figure.find("<figcaption><b>"), std::string::npos) << figure.substr(0, 200);
        EXPECT_TRUE(figure.find(", m</text>") != std::string::npos ||
                    figure.find("% of") != std::string::npos)
            << figure.substr(0, 200);
        EXPECT_TRUE(figure.find("<ul class=\"names\">") != std::string::npos ||
                    figure.find(" 16h26\"") != std::string::npos)
            << figure.substr(0, 200);
    }
    EXPECT_EQ(figures, 6U) << "slope, run-out, tree hits, their heights, jumps of strict and of default";
    EXPECT_EQ(case_charts(testing::bare_case()), "");
}

TEST(CaseCharts, TellTheShareThatStopsInASection) {
    // 1/(1 + e^((x - reach)/25)) at 120 m less that at 220 m, reach 140 m: 69.0 - 3.9 %.
    const std::string charts = case_charts(testing::forested_case());
    EXPECT_NE(
        charts.find("Stopped in B (120 to 220\u00a0m): observed 33.0\u00a0%, published 30.0\u00a0%, strict "
                    "65.1\u00a0%"),
        std::string::npos);
}

TEST(CaseCharts, PartTheCurveWhereNoJumpEnds) {
    const std::string jumps =
        between(case_charts(testing::forested_case()), "Jump lengths, strict", "</figure>");
    std::size_t bands = 0;
    for (std::size_t at = jumps.find("class=\"band strict\" d=\"M72"); at != std::string::npos;
         at = jumps.find("class=\"band strict\" d=\"M", at + 1)) {
        ++bands;
    }
    EXPECT_EQ(bands, 2U);
}

TEST(ProfileDrawing, HasOneScaleForBothAxes) {
    CaseResult result;
    result.profile = {{0.0, 100.0, "road"}, {100.0, 0.0, "road"}};
    // The height sets the scale here: 330 units for 100 m either way.
    EXPECT_NE(profile_drawing(result).find("class=\"ground\" d=\"M64 24l330 330\""), std::string::npos)
        << profile_drawing(result);
}

TEST(ProfileDrawing, NamesEachGroundTypeOnce) {
    const std::string drawing = profile_drawing(testing::forested_case());
    for (const char* item :
         {"<b>a</b> fine debris forest", "<b>c</b> road", "<b>e</b> forest soil woody debris"}) {
        EXPECT_NE(drawing.find(item), std::string::npos) << item;
    }
    EXPECT_EQ(drawing.find("<b>f</b>"), std::string::npos);
}

TEST(FigureText, KeepsAShareNearOneApartFromOne) {
    EXPECT_EQ(figure_text(0.9994), "0.999");
    EXPECT_EQ(figure_text(1.0), "1.00");
    EXPECT_EQ(figure_text(15.44), "15.4");
    EXPECT_EQ(figure_text(0.0), "0");
}

}  // namespace
}  // namespace coupling::validation::page_test
