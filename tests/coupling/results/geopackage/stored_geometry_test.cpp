#include "coupling/results/geopackage/stored_geometry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <stdexcept>

namespace coupling::geopackage::stored_geometry_test {
namespace {

using Kind = StoredGeometry::Kind;

double any_metres() {
    return 0.001 * *rc::gen::inRange(-1'000'000'000, 1'000'000'000);
}

TEST(StoredGeometry, GivesBackEveryCornerOfALine) {
    EXPECT_TRUE(rc::check([] {
        const Dimensions dimensions{.z = *rc::gen::arbitrary<bool>(), .m = *rc::gen::arbitrary<bool>()};
        std::vector<Vertex> corners(static_cast<std::size_t>(*rc::gen::inRange(2, 20)));
        for (Vertex& corner : corners) {
            corner = {any_metres(), any_metres(), dimensions.z ? any_metres() : 0.0,
                      dimensions.m ? any_metres() : 0.0};
        }
        const StoredGeometry read = read_geometry(line(corners, dimensions, 100'000).bytes);
        RC_ASSERT(read.kind == Kind::line);
        RC_ASSERT(read.dimensions.z == dimensions.z && read.dimensions.m == dimensions.m);
        RC_ASSERT(read.parts.size() == 1U);
        RC_ASSERT(std::equal(corners.begin(), corners.end(), read.parts[0].corners.begin(),
                             read.parts[0].corners.end(), [](const Vertex& a, const Vertex& b) {
                                 return a.x_m == b.x_m && a.y_m == b.y_m && a.z_m == b.z_m &&
                                        a.measure == b.measure;
                             }));
    }));
}

TEST(StoredGeometry, SaysWhichRingsAreHoles) {
    const auto square = [](double from, double to) {
        return std::vector<config::Point2>{{from, from}, {to, from}, {to, to}, {from, to}, {from, from}};
    };
    // A square with a hole and an island in it, and one beside them.
    const std::vector<std::vector<config::Point2>> rings{square(0.0, 10.0), square(2.0, 8.0),
                                                         square(4.0, 6.0), square(20.0, 30.0)};
    const StoredGeometry read = read_geometry(polygons(rings, 1).bytes);
    EXPECT_EQ(read.kind, Kind::area);
    std::vector<std::pair<double, bool>> seen;
    for (const StoredGeometry::Part& part : read.parts) {
        seen.emplace_back(part.corners.front().x_m, part.is_hole);
        EXPECT_EQ(part.corners.size(), 5U);
    }
    EXPECT_EQ(seen,
              (std::vector<std::pair<double, bool>>{{0.0, false}, {2.0, true}, {4.0, false}, {20.0, false}}));
}

TEST(StoredGeometry, RefusesBytesThatEndTooEarly) {
    const std::vector<std::uint8_t> bytes = point({1.0, 2.0}, {}, 1).bytes;
    EXPECT_EQ(read_geometry(bytes).parts[0].corners[0].y_m, 2.0);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THROW((void)read_geometry(std::span{bytes}.first(size)), std::invalid_argument) << size;
    }
}

}  // namespace
}  // namespace coupling::geopackage::stored_geometry_test
