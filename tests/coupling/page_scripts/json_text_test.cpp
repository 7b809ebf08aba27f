#include "coupling/page_scripts/json_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace coupling::page_scripts::json_text_test {
namespace {

TEST(JsonText, NeverEndsTheScriptItStandsIn) {
    EXPECT_EQ(json_string("a\"b\\</script>&\n"), "\"a\\\"b\\\\\\u003c/script\\u003e\\u0026\\u000a\"");
    EXPECT_EQ(json_string("Größe"), "\"Größe\"");
}

TEST(JsonText, WritesNumbersShortAndMissingOnesAsNull) {
    EXPECT_EQ(json_numbers(std::array<double, 6>{0.0, -1.5, 1234567.0, 0.1, std::nan(""), INFINITY}),
              "[0,-1.5,1.23457e+06,0.1,null,null]");
}

TEST(JsonText, KeepsMembersInTheirOrder) {
    EXPECT_EQ(JsonObject{}.text("b", "x").number("a", 2.0).flag("c", true).json(),
              "{\"b\":\"x\",\"a\":2,\"c\":true}");
    EXPECT_EQ(json_array({"1", "\"x\""}), "[1,\"x\"]");
}

TEST(JsonText, PacksTheLowerByteFirst) {
    EXPECT_EQ(json_packed(std::array<std::uint16_t, 2>{0x4241, 0x4443}), "\"QUJDRA==\"");  // "ABCD"
    EXPECT_EQ(json_packed(std::array<std::uint8_t, 3>{'M', 'a', 'n'}), "\"TWFu\"");        // RFC 4648
}

}  // namespace
}  // namespace coupling::page_scripts::json_text_test
