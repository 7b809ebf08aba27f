#include "coupling/inputs/plausible/overlapping_areas.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "config/random/stream.hpp"

namespace coupling::plausible::overlapping_areas_test {
namespace {

config::Shape box(double west_m, double south_m, double width_m, double depth_m) {
    const double east_m = west_m + width_m;
    const double north_m = south_m + depth_m;
    return {
        config::Shape::Kind::polygon,
        {{{west_m, south_m}, {east_m, south_m}, {east_m, north_m}, {west_m, north_m}, {west_m, south_m}}}};
}

TEST(AreaOfPolygon, LeavesHolesOutAndAddsParts) {
    config::Shape yard = box(0.0, 0.0, 20.0, 10.0);
    yard.parts.push_back(box(5.0, 3.0, 4.0, 2.0).parts.front());   // a court
    yard.parts.push_back(box(30.0, 0.0, 3.0, 3.0).parts.front());  // an outbuilding
    EXPECT_DOUBLE_EQ(area_m2(yard), 200.0 - 8.0 + 9.0);
}

// The share of rectangles is known: width by depth of what both cover.
RC_GTEST_PROP(Overlapping, FindsRectanglesByTheShareOfTheSmallerOne, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 0, 0, 0}, config::Purpose::test};
    const auto drawn = [&](double least, double most) { return least + (most - least) * stream.uniform(); };
    struct Box {
        double west_m, south_m, width_m, depth_m;
    };
    std::vector<Box> boxes;
    std::vector<config::Shape> shapes;
    for (int i = 0; i < 6; ++i) {
        const Box one{drawn(0.0, 40.0), drawn(0.0, 40.0), drawn(5.0, 20.0), drawn(5.0, 20.0)};
        boxes.push_back(one);
        shapes.push_back(box(one.west_m, one.south_m, one.width_m, one.depth_m));
    }
    std::vector<const config::Shape*> areas;
    for (const config::Shape& shape : shapes) {
        areas.push_back(&shape);
    }
    constexpr double least_share = 0.2;
    const std::vector<Overlap> found = overlapping(areas, least_share);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = i + 1; k < boxes.size(); ++k) {
            const Box& a = boxes[i];
            const Box& b = boxes[k];
            const double width_m =
                std::min(a.west_m + a.width_m, b.west_m + b.width_m) - std::max(a.west_m, b.west_m);
            const double depth_m =
                std::min(a.south_m + a.depth_m, b.south_m + b.depth_m) - std::max(a.south_m, b.south_m);
            const double smaller_m2 = std::min(a.width_m * a.depth_m, b.width_m * b.depth_m);
            const double share = std::max(width_m, 0.0) * std::max(depth_m, 0.0) / smaller_m2;
            const auto pair = std::find_if(found.begin(), found.end(), [&](const Overlap& one) {
                return one.first == i && one.second == k;
            });
            // Sampled at the middles of 40 x 40 fields: each side is off by one row at most.
            constexpr double off = 2.0 / 40.0;
            if (pair != found.end()) {
                RC_ASSERT(std::abs(pair->share - share) < off);
            }
            RC_ASSERT(share < least_share + off || pair != found.end());
            RC_ASSERT(share > least_share - off || pair == found.end());
        }
    }
}

TEST(Overlapping, WallsInCommonAreNone) {
    const config::Shape left = box(0.0, 0.0, 10.0, 10.0);
    const config::Shape right = box(10.0, 0.0, 10.0, 10.0);
    EXPECT_TRUE(overlapping({&left, &right}, 0.0).empty());
}

}  // namespace
}  // namespace coupling::plausible::overlapping_areas_test
