#include "coupling/assessments/consequences/risk_words.hpp"

#include <gtest/gtest.h>

namespace coupling::consequences::risk_words_test {
namespace {

TEST(RateText, HasAFirstNumberBelowTenAlsoWhereItIsRounded) {
    EXPECT_EQ(rate_text(1.736e-4), "1.7\u00a0·\u00a010⁻⁴");
    EXPECT_EQ(rate_text(9.96e-5), "1.0\u00a0·\u00a010⁻⁴");
    EXPECT_EQ(rate_text(9.94e-5), "9.9\u00a0·\u00a010⁻⁵");
    EXPECT_EQ(rate_text(0.0), "0");
}

}  // namespace
}  // namespace coupling::consequences::risk_words_test
