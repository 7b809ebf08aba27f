#include "tests/coupling/results/markup_checks.hpp"

#include <gtest/gtest.h>

namespace coupling::testing::markup_checks_test {
namespace {

TEST(MarkupFault, FindsNothingInGoodMarkup) {
    EXPECT_EQ(
        markup_fault("<!DOCTYPE html>\n<p class=\"a\">x &amp; y<br/><b>z</b></p>\n<style>a>b{}</style>"), "");
}

TEST(MarkupFault, FindsWhatIsWrong) {
    for (const char* text :
         {"<p>", "</p>", "<p><b></p></b>", "<p class=a></p>", "<p class=\"a\" class=\"b\"></p>",
          "<p>a & b</p>", "<p>a > b</p>", "<p class=\"a\"id=\"b\"></p>", "<p", "<p a></p>"}) {
        EXPECT_NE(markup_fault(text), "") << text;
    }
}

}  // namespace
}  // namespace coupling::testing::markup_checks_test
