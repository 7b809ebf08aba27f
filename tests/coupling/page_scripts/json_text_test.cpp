#include "coupling/page_scripts/json_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

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

TEST(JsonText, PacksNumbersWithAllTheirBits) {
    const auto packed = [](std::vector<double> values) {
        return json_packed(std::span<const double>{values});
    };
    EXPECT_EQ(packed({1.0, -0.5}), "\"f4:AACAPwAAAL8=\"");
    EXPECT_EQ(packed({0.1}), "\"f8:mpmZmZmZuT8=\"");
    EXPECT_EQ(packed({1e300}).substr(0, 4), "\"f8:");
    EXPECT_EQ(json_packed(std::span<const std::uint32_t>{std::vector<std::uint32_t>{0x01020304U}}),
              "\"BAMCAQ==\"");
}

}  // namespace
}  // namespace coupling::page_scripts::json_text_test
