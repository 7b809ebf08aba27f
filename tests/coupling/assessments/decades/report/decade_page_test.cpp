#include "coupling/assessments/decades/report/decade_page.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "config/text/joined.hpp"
#include "tests/coupling/assessments/decades/report/some_years.hpp"
#include "tests/coupling/parts_of_text.hpp"
#include "tests/coupling/results/markup_checks.hpp"

namespace coupling::decades::decade_page_test {
namespace {

using config::joined;
using text_checks::count_of;

/// The cells of the first table row that begins so.
std::string row_of(const std::string& page, const std::string& name) {
    const std::size_t at = page.find(joined("<tr><td>", name, "</td>"));
    return at == std::string::npos ? "" : page.substr(at, page.find("</tr>", at) - at);
}

/// Two regimes on a hectare, two replicates, ten years of growth.
const SomeYears& grown() {
    static const SomeYears some = [] {
        SomeYears years{forest::square_of_forest(10)};
        years.regimes = {"none", "thinning"};
        years.grow(2, 2, 10);
        return years;
    }();
    return some;
}

TEST(WriteDecadePage, IsWellFormedForAnyForest) {
    SomeYears none;
    EXPECT_EQ(text_checks::markup_fault(none.page()), "") << "no members";
    EXPECT_NE(none.page().find("No member of the run is done."), std::string::npos);

    SomeYears empty;
    empty.add_member(0, 0, {0.0, 0.0, 0.0});
    for (StandRow& stand : empty.members[0].stands) {
        stand.figures = {};
    }
    EXPECT_EQ(text_checks::markup_fault(empty.page()), "") << "no trees";

    SomeYears start_alone;
    start_alone.add_member(0, 0, {100.0});
    EXPECT_EQ(text_checks::markup_fault(start_alone.page()), "") << "no years";

    SomeYears one{forest::square_of_forest(1)};
    one.add_member(0, 0, {10.0, 11.0});
    for (const std::int32_t year : {0, 1}) {
        one.members[0].trees.push_back({.year = year,
                                        .x_m = 3.0,
                                        .y_m = 4.0,
                                        .dbh_cm = 20.0F,
                                        .height_m = 15.0F,
                                        .crown_radius_m = 2.0F});
    }
    EXPECT_EQ(text_checks::markup_fault(one.page()), "") << "one tree";

    EXPECT_EQ(text_checks::markup_fault(grown().page()), "") << "regimes and replicates";
}

TEST(WriteDecadePage, ShowsNoNumbersThatAreNone) {
    const std::regex no_number{"[^a-z](nan|inf)\\b|[MLHVhv]-?(nan|inf)"};
    for (const std::string& whole : {SomeYears{}.page(), grown().page()}) {
        const std::string page = coupling::text_checks::without_scripts(whole);
        std::smatch found;
        EXPECT_FALSE(std::regex_search(page, found, no_number))
            << page.substr(static_cast<std::size_t>(found.position()) - 60, 120);
    }
}

TEST(WriteDecadePage, ReachesOutToNothing) {
    const std::string page = coupling::text_checks::without_scripts(grown().page());
    for (const char* outside : {"http:", "https:", "url(//", "<link", "@import", "javascript:"}) {
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    }
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(WriteDecadePage, RefersOnlyToWhatItDefinesAndDefinesItOnce) {
    const std::string page = coupling::text_checks::without_scripts(grown().page());
    std::set<std::string> ids;
    for (std::size_t at = page.find(" id=\""); at != std::string::npos; at = page.find(" id=\"", at + 1)) {
        const std::string id = page.substr(at + 5, page.find('"', at + 5) - at - 5);
        EXPECT_TRUE(ids.insert(id).second) << id;
    }
    for (const std::string before : {"href=\"#", "url(#"}) {
        for (std::size_t at = page.find(before); at != std::string::npos; at = page.find(before, at + 1)) {
            const std::size_t first = at + before.size();
            const std::string id = page.substr(first, page.find_first_of("\")", first) - first);
            EXPECT_TRUE(ids.contains(id)) << id;
        }
    }
}

TEST(WriteDecadePage, TellsMeansOfStartMiddleAndEnd) {
    SomeYears some;
    some.add_member(0, 0, {100.0, 150.0, 200.0, 250.0, 300.0});
    some.add_member(0, 1, {100.0, 170.0, 240.0, 310.0, 380.0});
    const std::string page = some.page();
    // (200 + 240) / 2 = 220 with a standard error of 20; t = 6.3138 of two values.
    EXPECT_EQ(row_of(page, "Volume, m³/ha"),
              "<tr><td>Volume, m³/ha</td><td>100</td><td>220 <small>(93.7 – 346)</small></td><td>340 "
              "<small>(87.4 – 593)</small></td>");
    EXPECT_EQ(row_of(page, "Stems from 12 cm on, per ha"),
              "<tr><td>Stems from 12 cm on, per ha</td><td>100</td><td>100</td><td>100</td>");
    // 7 m3 a year in the first replicate, 8 in the second.
    EXPECT_NE(row_of(page, "Increment, m³/ha a year").find("<td>7.50 <small>(4.34 – 10.7)"),
              std::string::npos)
        << row_of(page, "Increment, m³/ha a year");
    EXPECT_NE(row_of(page, "Felled, m³/ha a year").find("<td>1.50<"), std::string::npos);
    EXPECT_NE(row_of(page, "Removed from the forest, m³/ha a year").find("<td>1.20<"), std::string::npos);
    EXPECT_NE(row_of(page, "Left of felled and salvaged, m³/ha a year").find("<td>0.30<"), std::string::npos);
    EXPECT_NE(row_of(page, "Mortality, m³/ha a year").find("<td>2.50<"), std::string::npos);
    EXPECT_NE(page.find("Volume 100 → <b>340</b>"), std::string::npos);
}

TEST(WriteDecadePage, HasNoBandForASingleReplicate) {
    SomeYears some;
    some.add_member(0, 0, {100.0, 150.0, 200.0});
    EXPECT_EQ(row_of(some.page(), "Volume, m³/ha"),
              "<tr><td>Volume, m³/ha</td><td>100</td><td>150</td><td>200</td>");
    EXPECT_EQ(some.page().find("90 % interval of the mean"), std::string::npos);
}

TEST(WriteDecadePage, NamesRegimesByLettersAndKeepsTheirOrder) {
    SomeYears some;
    some.regimes = {"none", "thinning"};
    some.add_member(1, 0, {100.0, 80.0});
    some.add_member(0, 0, {100.0, 120.0});
    const std::string page = some.page();
    EXPECT_EQ(row_of(page, "A: none"), "<tr><td>A: none</td><td>100</td><td>100</td>")
        << "stems, the first figure";
    EXPECT_LT(page.find("<td>A: none"), page.find("<td>B: thinning"));
    EXPECT_EQ(count_of(page, "<b>Volume by species, "), 2U);
}

TEST(WriteDecadePage, PutsSectionsOfOthersBeforeTheForest) {
    SomeYears some;
    some.first = {{"Protection over the years", "<p>All rocks stop.</p>\n"}};
    const std::string page = some.page();
    EXPECT_LT(page.find("</dl>"), page.find("<h2>Protection over the years</h2>\n<p>All rocks stop.</p>"));
    EXPECT_LT(page.find("<h2>Protection over"), page.find("<h2>The forest at the start"));
}

TEST(WriteDecadePage, EscapesWhatTheUserWrote) {
    SomeYears some;
    some.add_member(0, 0, {100.0, 120.0});
    const std::string page = some.page();
    EXPECT_EQ(page.find("<at all>"), std::string::npos);
    for (const char* text :
         {"none &lt;at all&gt;", "observed &amp; repeated", "forest &amp; were left out", "0123456789abcdef",
          "Bannwald 0.1.0", "What stands.", "1, 2021 to 2021; start: end of 2020"}) {
        EXPECT_NE(page.find(text), std::string::npos) << text;
    }
}

TEST(WriteDecadePage, ShowsACommonStartOnceAndEachEnd) {
    const std::string page = grown().page();
    EXPECT_EQ(count_of(page, "<b>All regimes, start</b>"), 2U) << "from above and from the side";
    EXPECT_EQ(count_of(page, "<b>A: none, year 10</b>"), 2U);
    EXPECT_EQ(count_of(page, "<b>B: thinning, year 10</b>"), 2U);
}

TEST(WriteDecadePage, DrawsACrownForEachTreeSeenFromAbove) {
    SomeYears some;
    some.add_member(0, 0, {100.0, 120.0});
    for (int i = 0; i < 7; ++i) {
        some.members[0].trees.push_back({.year = 0, .x_m = 2.0 * i + 1.0, .y_m = 5.0, .height_m = 9.0F});
    }
    const std::string page = some.page();
    EXPECT_EQ(count_of(page, "<circle class=\"species0\""), 7U);
}

TEST(WriteDecadePage, StaysOfModerateSize) {
    // Ten replicates of 4 regimes over 100 years, tree lists of a large forest.
    SomeYears some{forest::square_of_forest(40)};
    some.regimes = {"a", "b", "c", "d"};
    const std::vector<forest::Tree> trees = forest::any_trees(some.grid, some.species, 20'000, 3);
    for (std::uint32_t regime = 0; regime < 4; ++regime) {
        for (std::uint32_t replicate = 0; replicate < 10; ++replicate) {
            some.add_member(regime, replicate, std::vector<double>(101, 300.0));
        }
        MemberYears& first = some.members[regime * 10];
        for (const std::int32_t year : {0, 100}) {
            for (const forest::Tree& tree : trees) {
                first.trees.push_back({.year = year,
                                       .species = static_cast<std::uint32_t>(forest::index_of(tree.species)),
                                       .tree = forest::number_of(tree.id),
                                       .x_m = tree.x_m,
                                       .y_m = tree.y_m,
                                       .dbh_cm = static_cast<float>(tree.dbh_cm),
                                       .height_m = static_cast<float>(tree.height_m + regime),
                                       .crown_radius_m = static_cast<float>(tree.crown.radius_m)});
            }
        }
    }
    const std::string page = some.page();
    EXPECT_LT(page.size(), 3'000'000U);
    EXPECT_NE(page.find("One tree in 3.3 is drawn, a random sample"), std::string::npos);
}

}  // namespace
}  // namespace coupling::decades::decade_page_test
