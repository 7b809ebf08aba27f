#include "coupling/inputs/rockyfor3d/blocks.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/rockyfor3d/grounds.hpp"

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

TEST(Blocks, KeepTheirShapes) {
    Folder folder = folder_with({{2, 2}, {3, 2}, {5, 5}});
    folder.shape.at({2, 2}) = folder.shape.at({3, 2}) = 1.0;
    folder.d1.at({2, 2}) = folder.d1.at({3, 2}) = 0.5;
    folder.d3.at({2, 2}) = folder.d3.at({3, 2}) = 2.0;
    folder.shape.at({5, 5}) = 4.0;
    const Blocks blocks = blocks_of(folder);
    ASSERT_EQ(blocks.classes.size(), 2U);
    EXPECT_EQ(blocks.classes[0].form, BlockForm::disc);
    EXPECT_EQ(blocks.classes[1].form, BlockForm::rectangular);
    EXPECT_EQ(blocks.classes[1].sides_m, (std::array{2.0, 1.0, 0.5}));
    EXPECT_EQ(blocks.classes[1].cells, 2U);
    // Two cells side by side are one rectangle.
    EXPECT_NE(sources_csv(blocks).find(
                  "2,1.240,2500,box,2.000,1.000,0.500,,\"MULTIPOLYGON (((4.000 14.000, 8.000 14.000, 8.000 "
                  "16.000, 4.000 16.000, 4.000 14.000)))\""),
              std::string::npos)
        << sources_csv(blocks);
    EXPECT_NE(sources_csv(blocks).find("hull,,,,disc_1.csv"), std::string::npos) << sources_csv(blocks);
}

/// A length in whole half centimetres has at most three decimals.
bool is_short(double length_m) {
    const std::string text = config::to_text(length_m);
    const std::size_t point = text.find('.');
    return point == std::string::npos || text.size() - point <= 4;
}

TEST(Blocks, HaveSizesInWholeCentimetresThatPrintSo) {
    Folder folder = folder_with({{5, 5}});
    for (int cm = 1; cm <= 1000; ++cm) {
        folder.d1.at({5, 5}) = folder.d2.at({5, 5}) = folder.d3.at({5, 5}) = 0.01 * cm + 0.001;
        const double diameter_m = blocks_of(folder).classes.front().diameter_m;
        EXPECT_NEAR(diameter_m, 0.01 * cm, 1e-9);
        EXPECT_TRUE(is_short(diameter_m)) << config::to_text(diameter_m);
    }
}

TEST(Blocks, HaveClassesThatPrintShort) {
    Folder folder =
        folder_with({{2, 2}, {3, 2}, {4, 2}, {5, 2}, {6, 2}, {2, 3}, {3, 3}, {4, 3}, {5, 3}, {6, 3}});
    double size_m = 0.31;
    for (std::size_t i = 0; i < folder.d1.values.size(); ++i) {
        if (folder.rock_density.values[i] > 0.0) {
            folder.d1.values[i] = folder.d2.values[i] = folder.d3.values[i] = size_m;
            size_m += 0.37;
        }
    }
    for (std::size_t most = 1; most <= 9; ++most) {
        const Blocks blocks = blocks_of(folder, most);
        EXPECT_TRUE(is_short(blocks.class_width_m)) << config::to_text(blocks.class_width_m);
        for (const BlockClass& block : blocks.classes) {
            EXPECT_TRUE(is_short(block.diameter_m)) << config::to_text(block.diameter_m);
        }
    }
}

TEST(Grounds, HaveHeightsInWholeCentimetresThatPrintSo) {
    Folder folder = folder_with({});
    for (std::size_t i = 0; i < folder.dem.values.size(); ++i) {
        folder.soil_type.values[i] = 3.0;
        folder.rg70.values[i] = 0.01 * static_cast<double>(i) + 0.001;
    }
    for (const std::size_t most : {1000U, 50U, 20U, 10U, 3U, 1U}) {
        const Grounds grounds = grounds_of(folder, 0.5, most);
        EXPECT_TRUE(is_short(grounds.step_m)) << config::to_text(grounds.step_m);
        for (const Ground& ground : grounds.types) {
            EXPECT_TRUE(is_short(ground.rg70_m)) << config::to_text(ground.rg70_m);
        }
    }
}

/// Smooth rock would keep more than any ground type may.
TEST(Grounds, HaveFiguresThatARunTakes) {
    Folder folder = folder_with({{5, 5}});
    for (int soil = 0; soil <= 7; ++soil) {
        for (double& value : folder.soil_type.values) {
            value = soil;
        }
        EXPECT_LE(grounds_of(folder, 0.5).types.at(0).r_t, 0.99) << soil;
    }
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
    EXPECT_TRUE(at(9, 0).stops_all);  // rocks sink into soil type 0
    EXPECT_EQ(at(9, 0).r_t, 0.0);
    EXPECT_EQ(at(9, 0).like, "forest_soil_deep") << "a soil for the model that asks for one";
    EXPECT_FALSE(at(0, 0).stops_all);
    EXPECT_DOUBLE_EQ(at(0, 0).r_n, 0.38);
    EXPECT_EQ(at(0, 0).cells, 25U);
    EXPECT_EQ(grounds_of(folder, 0.5, 2).types.size(), 2U);  // rounded until they fit
}

}  // namespace
}  // namespace coupling::rockyfor3d::blocks_test
