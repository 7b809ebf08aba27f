// The pages of both kinds of runs in a real browser, opened from disk.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "config/text/joined.hpp"
#include "tests/coupling/parts_of_text.hpp"
#include "tests/runs/browser.hpp"
#include "tests/runs/program.hpp"

namespace coupling::report_in_browser_test {
namespace {

using config::joined;
using text_checks::count_of;

/// What a browser made of a page: its document when all scripts have run, and what they complained about.
struct Opened {
    std::string document;
    std::string complaints;
};

/// Opens `out/report.html` of a project.
Opened open_in_browser(const SampleProject& project, const std::string& flags) {
    const Outcome outcome = call_browser(
        project, joined("--enable-logging=stderr --v=0 --window-size=1280,14000 --virtual-time-budget=20000 ",
                        flags, " --dump-dom \"file://$PWD/out/report.html\""));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    Opened opened{outcome.out, ""};
    std::istringstream lines{outcome.err};
    for (std::string line; std::getline(lines, line);) {
        // The driver of software drawing tells how slow it is.
        if (line.find("CONSOLE") != std::string::npos &&
            line.find("GL Driver Message") == std::string::npos) {
            opened.complaints += line + "\n";
        }
    }
    return opened;
}

constexpr const char* with_webgl = "--enable-unsafe-swiftshader";
constexpr const char* without_webgl = "--disable-3d-apis";

/// Value of an attribute of <html>.
std::string told(const Opened& opened, const std::string& name) {
    const std::string before = joined(" data-", name, "=\"");
    const std::size_t at = opened.document.find(before);
    const std::size_t first = at + before.size();
    return at == std::string::npos ? ""
                                   : opened.document.substr(first, opened.document.find('"', first) - first);
}

void expect_readable_with_and_without_webgl(const SampleProject& project) {
    const std::string page = project.read("out/report.html");
    const std::size_t charts = count_of(page, "class=\"chart-numbers\"");
    EXPECT_GT(charts, 4U);
    EXPECT_EQ(page.find("\"title\":\"\""), std::string::npos) << "a chart or an axis without a title";

    const Opened opened = open_in_browser(project, with_webgl);
    EXPECT_EQ(opened.complaints, "");
    EXPECT_EQ(told(opened, "charts"), std::to_string(charts));
    EXPECT_EQ(told(opened, "slope"), "drawn");
    EXPECT_EQ(count_of(opened.document, "<canvas"), 1U);

    const Opened flat = open_in_browser(project, without_webgl);
    EXPECT_EQ(flat.complaints, "");
    EXPECT_EQ(told(flat, "charts"), std::to_string(charts));
    EXPECT_EQ(told(flat, "slope"), "no WebGL");
    EXPECT_NE(flat.document.find("Your browser offers no WebGL."), std::string::npos);
}

TEST(ReportInBrowser, ShowsTheStaticExampleWithoutAComplaint) {
    if (!has_browser()) {
        GTEST_SKIP() << "chromium is not installed";
    }
    const SampleProject project;
    const Outcome run = shell(project,
                              "\"$bannwald\" init x --example tyrol > /dev/null && "
                              "head -n 600 x/trees.csv > few && mv few x/trees.csv && "
                              "\"$bannwald\" run x/scenario.ini --quiet --out out "
                              "--set release.rocks_per_source=1 --set output.sample_paths=20\n");
    ASSERT_EQ(run.code, 0) << run.err;
    expect_readable_with_and_without_webgl(project);
}

TEST(ReportInBrowser, ShowsTheExampleOverYearsWithoutAComplaint) {
    if (!has_browser()) {
        GTEST_SKIP() << "chromium is not installed";
    }
    const SampleProject project;
    const Outcome run = shell(project,
                              "\"$bannwald\" init x --example regimes-small > /dev/null && "
                              "\"$bannwald\" run x/scenario.ini --quiet --out out --set run.years=2 "
                              "--set run.replicates=2 --set run.rockfall_every=1 --set release.rocks=50 "
                              "--set 'output.map_years=0, 2' "
                              "--set 'output.tree_list_years=0, 2' --set 'regimes.list=none, pfm1'\n");
    ASSERT_EQ(run.code, 0) << run.err;
    expect_readable_with_and_without_webgl(project);
}

}  // namespace
}  // namespace coupling::report_in_browser_test
