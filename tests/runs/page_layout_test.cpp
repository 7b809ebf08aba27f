// Every kind of page in every language, opened in a browser at the width of a screen, of half of one and of a
// phone: nothing is wider than the screen, each label lies within its drawing, and none lies over another.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "tests/runs/browser.hpp"
#include "tests/runs/calibrations.hpp"

namespace coupling::page_layout_test {
namespace {

using config::joined;

/// Text of an element that the script has written.
std::string written_in(const std::string& document, const std::string& id) {
    const std::string before = joined("<pre id=\"", id, "\">");
    const std::size_t at = document.find(before);
    if (at == std::string::npos) {
        ADD_FAILURE() << "the script did not end: " << document.substr(0, 1000);
        return "";
    }
    const std::size_t first = at + before.size();
    return document.substr(first, document.find("</pre>", first) - first);
}

/// What is wrong with pages of a project, a line a fault, and how many drawings and labels were looked at.
struct Layout {
    std::string faults;
    std::size_t drawings = 0;
    std::size_t labels = 0;
};

Layout layout_of(const SampleProject& project, const std::string& pages) {
    project.write("layout.html",
                  joined("<!DOCTYPE html><html><body data-pages=\"", pages,
                         "\" data-widths=\"1240 600 390\"><script src=\"page_layout.js\"></script>"
                         "</body></html>\n"));
    const Outcome opened =
        call_browser(project,
                     "--allow-file-access-from-files --virtual-time-budget=120000 --window-size=1300,1600 "
                     "--dump-dom \"file://$PWD/layout.html\"");
    EXPECT_EQ(opened.code, 0) << opened.err;
    Layout layout;
    layout.faults = written_in(opened.out, "faults");
    std::istringstream seen{written_in(opened.out, "seen")};
    seen >> layout.drawings >> layout.labels;
    return layout;
}

void take_script(const SampleProject& project) {
    ASSERT_EQ(shell(project, "cp \"" BANNWALD_SOURCE_DIR "/tests/runs/page_layout.js\" .\n").code, 0);
}

/// The kinds of pages, with what makes one of each quickly.
struct Kind {
    std::string page;
    std::string script;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> list{
        {"today",
         "\"$bannwald\" init tyrol --example tyrol > /dev/null && head -n 600 tyrol/trees.csv > few && "
         "mv few tyrol/trees.csv && printf 'name,height_m,capacity_kj,wkt\\nobere Reihe,4,3000,"
         "\"LINESTRING (177700 377900, 177800 377910, 177900 377940)\"\\n' > tyrol/net.csv && "
         "\"$bannwald\" run tyrol/scenario.ini $quick --out $out --set nets.keep_paths=yes --set "
         "nets.file=net.csv "
         "--set release.rocks_per_source=1"},
        {"today_pir3d",
         "\"$bannwald\" run tyrol/scenario.ini $quick --out $out --set rockfall.motion=pir3d "
         "--set release.rocks_per_source=1"},
        {"net_try", "\"$bannwald\" net try today --nets tyrol/net.csv -q --out net_try"},
        {"net_place", "\"$bannwald\" net place today --nets tyrol/targets.csv -q --out net_place"},
        {"compare", "\"$bannwald\" compare today today_pir3d -q --out compare"},
        {"vary",
         "printf 'setting,values,how\\ntree_impact.taper,yes no,alone\\n' > factors.csv && "
         "\"$bannwald\" vary tyrol/scenario.ini factors.csv $quick --out $out --set "
         "release.rocks_per_source=0 "
         "--set release.rocks=300"},
        {"hazard/return_period_300",
         "\"$bannwald\" init jura --example jura > /dev/null && \"$bannwald\" run jura/scenario.ini $quick "
         "--out hazard --set release.rocks=300 --set nets.keep_paths=yes"},
        {"hazard/hazard", "true"},
        {"profile",
         "\"$bannwald\" init line --example profile > /dev/null && \"$bannwald\" run line/scenario.ini "
         "$quick --out $out --set release.rocks=500"},
        {"regimes",
         "\"$bannwald\" init nine --example regimes-small > /dev/null && \"$bannwald\" run "
         "nine/scenario.ini $quick --out $out --set run.years=3 --set run.replicates=2 --set "
         "release.rocks=50 "
         "--set output.map_years=3"},
        {"collapse",
         "\"$bannwald\" init cliff --example collapse-small > /dev/null && \"$bannwald\" collapse "
         "cliff/scenario.ini $quick --out $out --set collapse.duration_s=1 --set collapse.picture_times_s=1"},
        {"calibrate",
         "\"$bannwald\" init found --example calibrate > /dev/null && \"$bannwald\" calibrate "
         "found/scenario.ini $quick --out $out " +
             few_sets},
    };
    return list;
}

class PageLayout : public testing::TestWithParam<std::string> {};

TEST_P(PageLayout, KeepsAllWithinTheScreenAndLabelsApart) {
    if (!has_browser()) {
        GTEST_SKIP() << "chromium is not installed";
    }
    const SampleProject project;
    take_script(project);
    std::string pages;
    for (const Kind& kind : kinds()) {
        const Outcome made = shell(project, joined("quick='--quiet --set report.language=", GetParam(),
                                                   "'\nout=", kind.page, "\n", kind.script, "\n"));
        ASSERT_EQ(made.code, 0) << kind.page << '\n' << made.err;
        pages += joined(pages.empty() ? "" : " ", kind.page, "/report.html");
    }
    const Layout layout = layout_of(project, pages);
    EXPECT_EQ(layout.faults, "");
    EXPECT_GT(layout.drawings, 3 * kinds().size());
    EXPECT_GT(layout.labels, 10 * layout.drawings / 4);
}

INSTANTIATE_TEST_SUITE_P(InEachLanguage, PageLayout, testing::Values("en", "de", "fr", "it"),
                         [](const auto& about) { return about.param; });

/// The search finds each fault where there is one.
TEST(PageLayouts, WithFaultsAreFound) {
    if (!has_browser()) {
        GTEST_SKIP() << "chromium is not installed";
    }
    const SampleProject project;
    take_script(project);
    const std::string before = "<!DOCTYPE html><html><body style=\"margin:0\">";
    const auto drawing = [&](const std::string& texts) {
        return before + "<svg width=\"200\" height=\"100\">" + texts + "</svg></body></html>";
    };
    project.write("right.html",
                  drawing("<text x=\"10\" y=\"20\">one</text><text x=\"90\" y=\"20\">two</text>"));
    project.write("over.html",
                  drawing("<text x=\"10\" y=\"20\">one</text><text x=\"12\" y=\"20\">two</text>"));
    project.write("outside.html", drawing("<text x=\"180\" y=\"20\">a long label</text>"));
    project.write("map.html", drawing("<rect class=\"paper\" x=\"60\" width=\"100\" height=\"90\"/>"
                                      "<text class=\"name\" x=\"30\" y=\"20\">a long name</text>"
                                      "<text x=\"10\" y=\"60\">100</text>"));
    project.write("wide.html", before + "<div style=\"width:500px\">wide</div></body></html>");
    project.write("cut.html", before +
                                  "<div style=\"overflow-x:auto\"><div style=\"width:2000px\">wide</div>"
                                  "</div></body></html>");
    const Layout layout = layout_of(project, "right.html over.html outside.html map.html wide.html cut.html");
    std::string expected;
    const auto expect = [&](const std::string& page, const std::vector<std::string>& widths,
                            const std::string& fault) {
        for (const std::string& width : widths) {
            expected += joined(page, ", ", width, " px, with scripts, ", fault, "\n");
        }
        if (widths.front() == "1240") {
            expected += joined(page, ", 1240 px, without scripts, ", fault, "\n");
        }
    };
    expect("over.html", {"1240", "600", "390"}, "over each other: one | two");
    expect("outside.html", {"1240", "600", "390"}, "outside of its drawing: a long label");
    expect("map.html", {"1240", "600", "390"}, "outside of its map: a long name");
    expect("wide.html", {"390"}, "wider than the screen: DIV wide");
    EXPECT_EQ(layout.faults + "\n", expected);
    EXPECT_EQ(layout.drawings, 16U);
    EXPECT_EQ(layout.labels, 28U);
}

}  // namespace
}  // namespace coupling::page_layout_test
