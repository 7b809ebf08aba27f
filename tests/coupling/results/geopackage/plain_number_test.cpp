#include "coupling/results/geopackage/plain_number.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace coupling::geopackage::plain_number_test {
namespace {

RC_GTEST_PROP(PlainNumber, IsTheDoubleNearestToTheText, (std::int64_t value)) {
    const auto decimals = *rc::gen::inRange<std::size_t>(0, 9);
    std::string text = std::to_string(value < 0 ? value / 7 : value);
    if (text.size() > decimals + 1 && decimals > 0) {
        text.insert(text.size() - decimals, ".");
    }
    double nearest = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), nearest);
    RC_PRE(error == std::errc{} && end == text.data() + text.size());
    RC_ASSERT(plain_number(text) == nearest);
}

TEST(PlainNumber, IsTheWholeFieldOrNothing) {
    EXPECT_EQ(plain_number("-0.050"), -0.05);
    EXPECT_EQ(plain_number("12."), 12.0);
    EXPECT_EQ(plain_number("1e3"), 1000.0);
    EXPECT_EQ(plain_number("123456789012345678901"), 123456789012345678901.0);
    for (const char* text : {"", "-", ".", "1,5", "1.2.3", "12 m", "forest", "0x10"}) {
        EXPECT_FALSE(plain_number(text)) << text;
    }
}

}  // namespace
}  // namespace coupling::geopackage::plain_number_test
