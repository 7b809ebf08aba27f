#include "config/text/coordinates.hpp"

#include <gtest/gtest.h>

namespace config::coordinates_test {
namespace {

TEST(MetresInWords, AreRoundedToTheMillimetre) {
    EXPECT_EQ(metres_in_words(500'000.0), "500000");
    EXPECT_EQ(metres_in_words(2'600'000.0), "2600000");
    EXPECT_EQ(metres_in_words(-300'000.0), "-300000");
    EXPECT_EQ(metres_in_words(177'203.30000000002), "177203.3");
    EXPECT_EQ(metres_in_words(1e9), "1000000000");
    EXPECT_EQ(metres_in_words(0.0004), "0");
    EXPECT_EQ(metres_in_words(-0.0004), "0");
    EXPECT_EQ(place_in_words(5e5, 1.0 / 3.0), "500000, 0.333");
}

}  // namespace
}  // namespace config::coordinates_test
