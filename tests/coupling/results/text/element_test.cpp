#include "coupling/results/text/element.hpp"

#include <gtest/gtest.h>

namespace coupling::report::element_test {
namespace {

TEST(Element, EscapesAttributesAndLeavesEmptyOnesOut) {
    EXPECT_EQ(element("rect", {{"class", ""}, {"x", 1.26}, {"y", -0.04}, {"data-name", "a \"b\" <c>"}}),
              "<rect x=\"1.3\" y=\"0\" data-name=\"a &quot;b&quot; &lt;c&gt;\"/>");
}

TEST(Element, ClosesWhatHasContentEvenWithoutAny) {
    EXPECT_EQ(element("td", {}, ""), "<td></td>");
    EXPECT_EQ(element("g", {{"id", "a"}}, element("g", {})), "<g id=\"a\"><g/></g>");
}

TEST(Element, EscapesWordsOfADrawingButNotReadyMarkup) {
    EXPECT_EQ(svg_text(1.0, 2.0, "a < b", {{"text-anchor", "end"}}),
              "<text x=\"1\" y=\"2\" text-anchor=\"end\">a &lt; b</text>");
    EXPECT_EQ(svg_drawing(30.0, 14.0, "Gr\u00f6\u00dfe & Ort", svg_path("s", "M0 0h1")),
              "<svg viewBox=\"0 0 30 14\" role=\"img\" aria-label=\"Gr\u00f6\u00dfe &amp; Ort\">"
              "<path class=\"s\" d=\"M0 0h1\"/></svg>");
}

}  // namespace
}  // namespace coupling::report::element_test
