#include "coupling/results/text/page_text.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace coupling::report::page_text_test {
namespace {

TEST(PageText, IsFoundByItsKey) {
    EXPECT_EQ(page_text("common.with_forest"), "with forest");
    EXPECT_GT(all_page_texts().size(), 500U);
}

TEST(PageText, PutsValuesInThePlaceOfTheirNames) {
    EXPECT_EQ(page_text("common.year", {{"year", "12"}}), "year 12");
    EXPECT_EQ(page_text("today.answers.to", {{"interval_high", "9 %"}, {"interval_low", "3 %"}}),
              "3 % to 9 %");
}

TEST(PageText, RefusesWhatTheTableDoesNotHave) {
    EXPECT_THROW(page_text("common.no_such_text"), std::logic_error);
    EXPECT_THROW(page_text("common.year", {{"month", "12"}}), std::logic_error);
    EXPECT_THROW(page_text("common.year", {}), std::logic_error);
    EXPECT_THROW(page_text("common.with_forest", {{"year", "12"}}), std::logic_error);
}

}  // namespace
}  // namespace coupling::report::page_text_test
