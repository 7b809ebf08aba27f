#include "coupling/results/report/first_warnings.hpp"

#include <gtest/gtest.h>

namespace coupling::report::first_warnings_test {
namespace {

TEST(FirstWarnings, AreNothingWithoutAny) {
    EXPECT_EQ(first_warnings(config::Warnings{}), "");
}

TEST(FirstWarnings, PutDoubtsBeforeNotesAndEscapeThem) {
    config::Warnings warnings;
    warnings.add_note("a height was filled in");
    warnings.add("3 trees off the terrain & left out");
    const std::string html = first_warnings(warnings);
    EXPECT_NE(html.find("<b>2 warnings about this run</b><ul><li>3 trees off the terrain &amp; left out</li>"
                        "<li>a height was filled in</li></ul>"),
              std::string::npos)
        << html;
    EXPECT_EQ(html.find("<details>"), std::string::npos);
}

TEST(FirstWarnings, CountThoseOfAKindAndFoldWhatIsBeyondFive) {
    config::Warnings warnings;
    for (int i = 0; i < 40; ++i) {
        warnings.add("stand " + std::to_string(i) + " has no patch");
    }
    for (const char* other : {"alpha", "beta", "gamma", "delta"}) {
        warnings.add(other);
    }
    const std::string html = first_warnings(warnings);
    EXPECT_NE(html.find("<b>44 warnings about this run</b>"), std::string::npos) << html;
    EXPECT_NE(html.find("... and 37 more like this; the section Warnings lists all"), std::string::npos)
        << html;
    EXPECT_NE(html.find("<details><summary>3 more</summary><ul><li>beta</li>"), std::string::npos) << html;
}

}  // namespace
}  // namespace coupling::report::first_warnings_test
