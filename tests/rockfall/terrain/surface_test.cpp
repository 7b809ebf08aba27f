#include "rockfall/terrain/surface.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rockfall::surface_test {
namespace {

/// 3 columns of 10 m and 2 rows of 5 m from (100, 200).
SurfaceMap small_map() {
    const config::GridFrame frame{.columns = 3,
                                  .rows = 2,
                                  .x_west_m = 100.0,
                                  .y_south_m = 200.0,
                                  .cell_width_m = 10.0,
                                  .cell_height_m = 5.0};
    return {frame, {0, 1, 2, 3, 4, 5}};
}

TEST(SurfaceMap, NamesTheGroundOfTheCell) {
    const SurfaceMap map = small_map();
    EXPECT_EQ(map.at(100.1, 209.9), SurfaceId{0});
    EXPECT_EQ(map.at(115.0, 207.0), SurfaceId{1});
    EXPECT_EQ(map.at(129.9, 205.1), SurfaceId{2});
    EXPECT_EQ(map.at(100.1, 204.9), SurfaceId{3});
    EXPECT_EQ(map.at(129.9, 200.1), SurfaceId{5});
}

TEST(SurfaceMap, ContinuesTheNearestCellOutside) {
    const SurfaceMap map = small_map();
    EXPECT_EQ(map.at(-1e9, 1e9), SurfaceId{0});
    EXPECT_EQ(map.at(115.0, 1e12), SurfaceId{1});
    EXPECT_EQ(map.at(1e9, 203.0), SurfaceId{5});
    EXPECT_EQ(map.at(130.0, 200.0), SurfaceId{5});
    constexpr double odd = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(map.at(odd, odd), SurfaceId{0});
}

TEST(SurfaceMap, AgreesWithTheGridFrameInside) {
    const config::GridFrame frame{.columns = 7,
                                  .rows = 5,
                                  .x_west_m = -3.3,
                                  .y_south_m = 1.7,
                                  .cell_width_m = 0.9,
                                  .cell_height_m = 1.1};
    std::vector<std::uint8_t> ids(frame.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        ids[i] = static_cast<std::uint8_t>(i);
    }
    const SurfaceMap map{frame, ids};
    for (double x_m = -3.25; x_m < 3.0; x_m += 0.1) {
        for (double y_m = 1.75; y_m < 7.2; y_m += 0.1) {
            EXPECT_EQ(map.at(x_m, y_m),
                      SurfaceId{static_cast<std::uint8_t>(frame.index(frame.cell_at(x_m, y_m)))});
        }
    }
}

TEST(SurfaceMap, CanBeTheSameEverywhere) {
    const SurfaceMap map = SurfaceMap::uniform(SurfaceId{7});
    EXPECT_EQ(map.at(0.0, 0.0), SurfaceId{7});
    EXPECT_EQ(map.at(-5e5, 3e6), SurfaceId{7});
}

}  // namespace
}  // namespace rockfall::surface_test
