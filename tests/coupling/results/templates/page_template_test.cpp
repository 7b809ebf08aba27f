// Templates of pages: every one is filled as a whole, in all languages; a name too many or too few is an
// error.

#include "coupling/results/templates/page_template.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {
namespace {

/// The fields of run_settings.html.
PageFields settings_of(std::vector<PageFields> rows) {
    return {{"settings", std::move(rows)}};
}

TEST(PageTemplate, RepeatsASectionAndEscapesItsFields) {
    EXPECT_EQ(
        filled_template("run_settings.html", settings_of({{{"setting", "a=<1>"}}, {{"setting", "b=\"2\""}}})),
        "<code>a=&lt;1&gt;</code><br><code>b=&quot;2&quot;</code><br>\n");
}

TEST(PageTemplate, SaysItsSentencesInTheLanguageInUse) {
    EXPECT_EQ(filled_template("run_settings.html", settings_of({})), "as in the scenario\n");
    const WritingLanguage german{config::Language::de};
    EXPECT_EQ(filled_template("run_settings.html", settings_of({})), "wie im Szenario\n");
}

TEST(PageTemplate, RefusesNamesThatHaveNoPartner) {
    EXPECT_THROW(filled_template("run_settings.html", {}), std::logic_error);
    EXPECT_THROW(filled_template("run_settings.html", settings_of({{{"a", "1"}}})), std::logic_error);
    EXPECT_THROW(filled_template("run_settings.html", settings_of({PageFields{}})), std::logic_error);
    EXPECT_THROW(filled_template("no_page.html", {}), std::logic_error);
}

TEST(PageTemplate, PutsReadyHtmlAndIncludedPartsInPlace) {
    const std::string html =
        filled_template("inputs_and_files.html",
                        {{"inputs", "<table>&lt;</table>"}, {"files", ""}, {"citation", "<p>c</p>"}});
    EXPECT_NE(html.find("<table>&lt;</table>"), std::string::npos);
    EXPECT_NE(html.find("<h2>Data</h2>\n"), std::string::npos);
}

}  // namespace
}  // namespace coupling::report
