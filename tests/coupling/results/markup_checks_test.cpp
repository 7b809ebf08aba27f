#include "tests/coupling/results/markup_checks.hpp"

#include <gtest/gtest.h>

namespace coupling::markup_checks_test {
namespace {

TEST(MarkupFault, FindsNothingInGoodMarkup) {
    EXPECT_EQ(text_checks::markup_fault(
                  "<!DOCTYPE html>\n<p class=\"a\">x &amp; y<br/><b>z</b></p>\n<style>a>b{}</style>"),
              "");
}

TEST(MarkupFault, FindsWhatIsWrong) {
    for (const char* text :
         {"<p>", "</p>", "<p><b></p></b>", "<p class=a></p>", "<p class=\"a\" class=\"b\"></p>",
          "<p>a & b</p>", "<p>a > b</p>", "<p class=\"a\"id=\"b\"></p>", "<p", "<p a></p>"}) {
        EXPECT_NE(text_checks::markup_fault(text), "") << text;
    }
}

}  // namespace
}  // namespace coupling::markup_checks_test
