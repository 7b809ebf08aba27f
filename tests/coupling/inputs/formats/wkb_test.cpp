#include "coupling/inputs/formats/wkb.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace coupling::wkb_test {
namespace {

/// Well-known binary, little endian.
class Wkb {
public:
    Wkb& head(std::uint32_t kind) { return byte(1).whole(kind); }
    Wkb& byte(std::uint8_t value) {
        bytes_ += static_cast<char>(value);
        return *this;
    }
    Wkb& whole(std::uint32_t value) {
        for (int i = 0; i < 4; ++i) {
            bytes_ += static_cast<char>((value >> (8 * i)) & 0xFFU);
        }
        return *this;
    }
    Wkb& number(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        return whole(static_cast<std::uint32_t>(bits)).whole(static_cast<std::uint32_t>(bits >> 32U));
    }
    Wkb& point(double x, double y) { return number(x).number(y); }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::string refused(const std::string& bytes) {
    try {
        formats::wkt_of_wkb(bytes);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(WktOfWkb, WritesEachKind) {
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(1).point(1.5, -2).bytes()), "POINT (1.5 -2)");
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(2).whole(2).point(0, 0).point(1, 1).bytes()),
              "LINESTRING (0 0, 1 1)");
    Wkb polygon;
    polygon.head(3).whole(2).whole(1).point(0, 0).whole(1).point(5, 5);
    EXPECT_EQ(formats::wkt_of_wkb(polygon.bytes()), "POLYGON ((0 0), (5 5))");
    Wkb several;
    several.head(6).whole(2);
    several.head(3).whole(1).whole(1).point(0, 0).head(3).whole(1).whole(1).point(1, 1);
    EXPECT_EQ(formats::wkt_of_wkb(several.bytes()), "MULTIPOLYGON (((0 0)), ((1 1)))");
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(4).whole(1).head(1).point(7, 8).bytes()), "MULTIPOINT ((7 8))");
}

TEST(WktOfWkb, KeepsHeightsAndDropsMeasures) {
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(1001).point(1, 2).number(3).bytes()), "POINT Z (1 2 3)");
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(2001).point(1, 2).number(9).bytes()), "POINT (1 2)");
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(3001).point(1, 2).number(3).number(9).bytes()),
              "POINT Z (1 2 3)");
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(0x80000001U).point(1, 2).number(3).bytes()), "POINT Z (1 2 3)");
}

TEST(WktOfWkb, GivesNothingForWhatIsEmpty) {
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(1).point(std::nan(""), std::nan("")).bytes()), "");
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(2).whole(0).bytes()), "");
}

TEST(WktOfWkb, LeavesOutEmptyParts) {
    Wkb lines;
    lines.head(5).whole(2).head(2).whole(0).head(2).whole(2).point(0, 0).point(1, 1);
    EXPECT_EQ(formats::wkt_of_wkb(lines.bytes()), "MULTILINESTRING ((0 0, 1 1))");
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(5).whole(1).head(2).whole(0).bytes()), "");
}

TEST(WktOfWkb, NamesArcsInsideCurves) {
    EXPECT_EQ(formats::wkt_of_wkb(Wkb{}.head(8).whole(3).point(0, 0).point(1, 1).point(2, 0).bytes()),
              "CIRCULARSTRING (0 0, 1 1, 2 0)");
    Wkb curve;
    curve.head(9).whole(2).head(2).whole(2).point(-1, 0).point(0, 0);
    curve.head(8).whole(3).point(0, 0).point(1, 1).point(2, 0);
    EXPECT_EQ(formats::wkt_of_wkb(curve.bytes()),
              "COMPOUNDCURVE ((-1 0, 0 0), CIRCULARSTRING (0 0, 1 1, 2 0))");
    Wkb surface;
    surface.head(12).whole(2);
    surface.head(3).whole(1).whole(2).point(0, 0).point(1, 0);
    surface.head(10).whole(1).head(8).whole(3).point(0, 0).point(9, 0).point(0, 0);
    EXPECT_EQ(formats::wkt_of_wkb(surface.bytes()),
              "MULTISURFACE (((0 0, 1 0)), CURVEPOLYGON (CIRCULARSTRING (0 0, 9 0, 0 0)))");
    EXPECT_EQ(
        formats::wkt_of_wkb(Wkb{}.head(1011).whole(1).head(1008).whole(1).point(1, 2).number(3).bytes()),
        "MULTICURVE Z (CIRCULARSTRING Z (1 2 3))");
}

TEST(WktOfWkb, RefusesOtherKindsAndWhatEndsTooEarly) {
    EXPECT_EQ(refused(Wkb{}.head(7).whole(0).bytes()), "a shape of the kind collection");
    EXPECT_EQ(refused(Wkb{}.head(16).whole(0).bytes()), "a shape of the kind TIN");
    EXPECT_EQ(refused(Wkb{}.head(12).whole(1).head(8).whole(0).bytes()), "shapes of different kinds in one");
    EXPECT_EQ(refused(Wkb{}.head(5).whole(1).head(1).point(1, 2).bytes()),
              "shapes of different kinds in one");
    EXPECT_EQ(refused(Wkb{}.head(1).point(1, INFINITY).bytes()), "a coordinate that is no number");
    const std::string line = Wkb{}.head(2).whole(2).point(0, 0).point(1, 1).bytes();
    for (std::size_t bytes = 0; bytes < line.size(); ++bytes) {
        EXPECT_EQ(refused(line.substr(0, bytes)), "a geometry that is cut off") << bytes;
    }
    EXPECT_EQ(refused(Wkb{}.head(2).whole(4'000'000'000U).bytes()), "a geometry that is cut off");
}

}  // namespace
}  // namespace coupling::wkb_test
