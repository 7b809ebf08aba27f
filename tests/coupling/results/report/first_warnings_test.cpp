#include "coupling/results/report/first_warnings.hpp"

#include <gtest/gtest.h>

namespace coupling::report::first_warnings_test {
namespace {

TEST(FirstWarnings, AreNothingWithoutAny) {
    EXPECT_EQ(first_warnings(config::Warnings{}), "");
}

TEST(FirstWarnings, PutTheLargestEffectFirstEscapeThemAndLeaveNotesOut) {
    config::Warnings warnings;
    warnings.add_note("a height was filled in");
    warnings.add("3 trees off the terrain & left out");
    warnings.add("the heights are in feet", config::Effect::answer);
    const std::string html = first_warnings(warnings);
    EXPECT_NE(
        html.find("<li>the heights are in feet</li>\n<li>3 trees off the terrain &amp; left out</li>\n</ul>"),
        std::string::npos)
        << html;
    EXPECT_NE(html.find("<b>2 warnings about this run</b>"), std::string::npos) << html;
    EXPECT_EQ(html.find("<details>"), std::string::npos);
}

TEST(FirstWarnings, CountThoseOfAKindAndFoldWhatIsBeyondFive) {
    config::Warnings warnings;
    for (int i = 0; i < 40; ++i) {
        warnings.add("stand " + std::to_string(i) + " has no patch");
    }
    for (const char* other : {"alpha", "beta", "gamma", "delta", "epsilon", "zeta"}) {
        warnings.add(other);
    }
    const std::string html = first_warnings(warnings);
    EXPECT_NE(html.find("<b>46 warnings about this run</b>"), std::string::npos) << html;
    EXPECT_NE(html.find("<li>stand 0 has no patch (and 39 more like this; the section Warnings lists all)"),
              std::string::npos)
        << html;
    EXPECT_NE(
        html.find("<details><summary>2 more</summary><ul>\n<li>epsilon</li>\n<li>zeta</li>\n</ul></details>"),
        std::string::npos)
        << html;
}

}  // namespace
}  // namespace coupling::report::first_warnings_test
