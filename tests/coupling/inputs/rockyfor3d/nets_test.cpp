#include "coupling/inputs/rockyfor3d/nets.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::rockyfor3d::nets_test {
namespace {

/// 20 x 12 cells of 5 m that fall to the east.
Folder folder_with_nets() {
    const config::GridFrame frame{20, 12, 1000.0, 2000.0, 5.0, 5.0};
    Folder folder;
    folder.dem = config::Raster<double>{frame};
    for (std::size_t i = 0; i < frame.size(); ++i) {
        folder.dem.values[i] = 500.0 - 3.0 * frame.cell_of(i).column;
    }
    folder.net_number = config::Raster<double>{frame, 0.0};
    folder.net_energy = config::Raster<double>{frame, 0.0};
    folder.net_height = config::Raster<double>{frame, 0.0};
    return folder;
}

void put(Folder& folder, config::Cell cell, double number, double energy_kj = 1000.0, double height_m = 4.0) {
    folder.net_number->at(cell) = number;
    folder.net_energy->at(cell) = energy_kj;
    folder.net_height->at(cell) = height_m;
}

TEST(RockyNets, AreLinesFromEndToEnd) {
    Folder folder = folder_with_nets();
    for (int row = 2; row <= 8; ++row) {
        put(folder, {10, row}, 7.0);
    }
    const Nets nets = nets_of(folder);
    ASSERT_EQ(nets.nets.size(), 1U);
    EXPECT_EQ(nets.nets[0].name, "net 7");
    EXPECT_EQ(nets.nets[0].capacity_kj, 1000.0);
    EXPECT_EQ(nets.nets[0].height_m, 4.0);
    EXPECT_FALSE(nets.nets[0].varies);
    EXPECT_EQ(nets.nets[0].off_line, 0U);
    ASSERT_EQ(nets.nets[0].line.size(), 2U) << "a straight net has two ends";
    EXPECT_EQ(nets.nets[0].line[0].x_m, 1052.5);
    EXPECT_EQ(std::abs(nets.nets[0].line[0].y_m - nets.nets[0].line[1].y_m), 30.0);
}

/// A line across the grid has steps that are none of the net's; a corner of the net stays.
TEST(RockyNets, LoseTheStepsOfTheGridAndKeepCorners) {
    Folder folder = folder_with_nets();
    for (int column = 2; column <= 16; ++column) {
        put(folder, {column, column / 2 + 1}, 1.0);
    }
    EXPECT_EQ(nets_of(folder).nets.at(0).line.size(), 2U);
    Folder bent = folder_with_nets();
    for (int k = 2; k <= 9; ++k) {
        put(bent, {k, 2}, 1.0);
        put(bent, {9, k}, 1.0);
    }
    EXPECT_GE(nets_of(bent).nets.at(0).line.size(), 3U);
    EXPECT_EQ(nets_of(bent).nets.at(0).off_line, 0U);
}

TEST(RockyNets, AreOneForEachNumberAndPiece) {
    Folder folder = folder_with_nets();
    put(folder, {5, 5}, 1.0);
    put(folder, {5, 9}, 1.0, 500.0);
    put(folder, {6, 5}, 2.0, 800.0, 3.0);
    put(folder, {7, 5}, 2.0, 700.0, 3.5);
    const Nets nets = nets_of(folder);
    ASSERT_EQ(nets.nets.size(), 3U);
    EXPECT_EQ(nets.nets[0].name, "net 1a");
    EXPECT_EQ(nets.nets[1].name, "net 1b");
    EXPECT_EQ(nets.nets[2].name, "net 2");
    EXPECT_TRUE(nets.nets[2].varies);
    EXPECT_EQ(nets.nets[2].capacity_kj, 700.0) << "the weakest of its cells";
    EXPECT_EQ(nets.nets[2].height_m, 3.0);
    // One cell of 5 m across the fall line, which runs east.
    ASSERT_EQ(nets.nets[0].line.size(), 2U);
    EXPECT_NEAR(nets.nets[0].line[0].x_m, nets.nets[0].line[1].x_m, 1e-9);
    EXPECT_NEAR(std::abs(nets.nets[0].line[0].y_m - nets.nets[0].line[1].y_m), 5.0, 1e-9);
}

TEST(RockyNets, LeaveOutTheBorderAndCountIt) {
    Folder folder = folder_with_nets();
    folder.dem.at({12, 3}) = std::nan("");
    for (int row = 0; row < 12; ++row) {
        put(folder, {11, row}, 1.0);
    }
    const Nets nets = nets_of(folder);
    EXPECT_EQ(nets.left_out, 2U + 3U);
    std::size_t cells = 0;
    for (const Net& net : nets.nets) {
        EXPECT_GE(net.line.size(), 2U);
        cells += net.off_line;
    }
    EXPECT_EQ(cells, 0U);
}

TEST(RockyNets, OfWideAreasAreReported) {
    Folder folder = folder_with_nets();
    for (int row = 2; row <= 9; ++row) {
        for (int column = 4; column <= 14; ++column) {
            put(folder, {column, row}, 1.0);
        }
    }
    EXPECT_GT(nets_of(folder).nets.at(0).off_line, 10U);
}

}  // namespace
}  // namespace coupling::rockyfor3d::nets_test
