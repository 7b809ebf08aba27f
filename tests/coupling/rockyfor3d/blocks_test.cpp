#include "coupling/rockyfor3d/blocks.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"
#include "coupling/rockyfor3d/grounds.hpp"

namespace coupling::rockyfor3d::blocks_test {
namespace {

/// A folder of 10 x 10 cells with the same block in every source of `sources`.
Folder folder_with(const std::vector<config::Cell>& sources) {
    const config::GridFrame frame{10, 10, 0.0, 0.0, 2.0, 2.0};
    const config::Raster<double> none{frame, 0.0};
    Folder folder{config::Raster<double>{frame, 500.0},
                  "",
                  none,
                  none,
                  none,
                  none,
                  none,
                  none,
                  none,
                  none,
                  none,
                  {},
                  {},
                  {},
                  {},
                  {},
                  {},
                  {},
                  {}};
    for (const config::Cell& cell : sources) {
        folder.rock_density.at(cell) = 2500.0;
        folder.d1.at(cell) = folder.d2.at(cell) = folder.d3.at(cell) = 1.0;
        folder.shape.at(cell) = 3.0;
    }
    return folder;
}

TEST(EqualVolume, IsThatOfTheBlock) {
    EXPECT_DOUBLE_EQ(equal_volume_diameter_m(0.7, 0.7, 0.7, 3), 0.7);      // a sphere is itself
    EXPECT_DOUBLE_EQ(equal_volume_diameter_m(2.0, 1.0, 0.5, 2), 1.0);      // an ellipsoid of the same product
    EXPECT_NEAR(equal_volume_diameter_m(1.0, 1.0, 1.0, 1), 1.2407, 1e-4);  // (6 / pi)^(1/3)
    EXPECT_NEAR(equal_volume_diameter_m(1.0, 1.0, 1.0, 4), 1.1447, 1e-4);  // (3 / 2)^(1/3)
}

TEST(Blocks, LeaveOutTheTwoOuterRowsAndColumns) {
    const Blocks blocks = blocks_of(folder_with({{1, 5}, {2, 5}, {5, 8}, {7, 7}}));
    EXPECT_EQ(blocks.cells(), 2U);
    EXPECT_EQ(blocks.left_out, 2U);
    EXPECT_EQ(blocks.zones.at({2, 5}), 1.0);
    EXPECT_EQ(blocks.zones.at({1, 5}), 0.0);
    EXPECT_THROW((void)blocks_of(folder_with({{0, 0}})), config::InputError);
}

TEST(Blocks, ComeInClassesWhereThereAreManySizes) {
    Folder folder = folder_with({{2, 2}, {3, 2}, {4, 2}, {5, 2}, {6, 2}});
    const double sizes_m[] = {0.5, 0.52, 0.9, 0.92, 1.4};
    for (int i = 0; i < 5; ++i) {
        folder.d1.at({2 + i, 2}) = folder.d2.at({2 + i, 2}) = folder.d3.at({2 + i, 2}) = sizes_m[i];
    }
    const Blocks exact = blocks_of(folder);
    ASSERT_EQ(exact.classes.size(), 5U);
    EXPECT_DOUBLE_EQ(exact.classes[1].diameter_m, 0.52);
    EXPECT_EQ(exact.zones.at({6, 2}), 5.0);
    const Blocks few = blocks_of(folder, 3);
    EXPECT_LE(few.classes.size(), 3U);
    EXPECT_EQ(few.cells(), 5U);
    EXPECT_GT(few.class_width_m, 0.0);
    EXPECT_NEAR(few.mean_diameter_m(), exact.mean_diameter_m(), few.class_width_m);
}

TEST(TangentialShare, FallsWithRoughnessAndForSmallRocks) {
    EXPECT_NEAR(tangential_share(0.0, 0.0, 0.0, 0.5), std::sqrt(1.39 / 1.4),
                1e-12);  // smooth: 0.99 of the energy
    EXPECT_LT(tangential_share(0.3, 0.5, 0.9, 0.5), tangential_share(0.03, 0.05, 0.1, 0.5));
    EXPECT_LT(tangential_share(0.3, 0.5, 0.9, 0.2), tangential_share(0.3, 0.5, 0.9, 1.0));
    // Obstacles as high as the radius: half of the energy along the slope.
    EXPECT_NEAR(tangential_share(0.5, 0.5, 0.5, 0.5), std::sqrt(0.9 / 1.4), 1e-12);
}

TEST(Grounds, AreOneForEachSoilAndRoughness) {
    Folder folder = folder_with({{5, 5}});
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 10; ++column) {
            folder.soil_type.at({column, row}) = column < 5 ? 4.0 : 0.0;
            folder.rg70.at({column, row}) = row < 5 ? 0.3 : 0.05;
        }
    }
    const Grounds grounds = grounds_of(folder, 0.5);
    ASSERT_EQ(grounds.types.size(), 4U);
    const auto at = [&](int column, int row) -> const Ground& {
        return grounds.types[static_cast<std::size_t>(grounds.codes.at({column, row})) - 1];
    };
    EXPECT_EQ(at(0, 0).like, "coarse_debris");
    EXPECT_EQ(at(0, 9).like, "fine_debris");
    EXPECT_EQ(at(9, 0).like, "");  // rocks sink into soil type 0
    EXPECT_DOUBLE_EQ(at(0, 0).r_n, 0.38);
    EXPECT_EQ(at(0, 0).cells, 25U);
    EXPECT_EQ(grounds_of(folder, 0.5, 2).types.size(), 2U);  // rounded until they fit
}

}  // namespace
}  // namespace coupling::rockyfor3d::blocks_test
