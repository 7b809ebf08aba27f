#include "coupling/assessments/nets/figures/net_paths.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace coupling::net_paths_test {
namespace {

constexpr std::uint32_t no_neighbour = rockfall::no_triangle;

const std::vector<rockfall::Vertex> stored_square{{0, 0, 5}, {10, 0, 5}, {10, 10, 5}, {0, 10, 5}};

/// The square in two triangles that share its diagonal.
std::vector<rockfall::Triangle> halves() {
    return {{{0, 1, 2}, {no_neighbour, no_neighbour, 1}}, {{0, 2, 3}, {0, no_neighbour, no_neighbour}}};
}

TEST(StoredTerrain, IsWholeWhereAllOfItIsThere) {
    EXPECT_TRUE(is_whole_terrain(stored_square, halves()));
    EXPECT_FALSE(is_whole_terrain(stored_square, {}));
    EXPECT_FALSE(is_whole_terrain(std::span{stored_square}.first(3), halves()));
}

TEST(StoredTerrain, IsRefusedWithIndicesThatLeadNowhere) {
    for (std::size_t triangle = 0; triangle < 2; ++triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            auto triangles = halves();
            triangles[triangle].corners[corner] = 4;
            EXPECT_FALSE(is_whole_terrain(stored_square, triangles));
            triangles = halves();
            triangles[triangle].neighbours[corner] = 2;
            EXPECT_FALSE(is_whole_terrain(stored_square, triangles));
        }
    }
    auto triangles = halves();
    triangles[0].neighbours[2] = no_neighbour;  // the other one still says that it lies there
    EXPECT_FALSE(is_whole_terrain(stored_square, triangles));
}

TEST(StoredTerrain, IsRefusedWithCoordinatesThatAreNone) {
    auto vertices = stored_square;
    vertices[2].z_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_whole_terrain(vertices, halves()));
    vertices[2].z_m = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_whole_terrain(vertices, halves()));
}

TEST(StoredDesign, IsWholeWithSettingsThatAScenarioMayHave) {
    DesignSettings design;
    EXPECT_TRUE(is_whole_design(design));
    design.percentile = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_whole_design(design));
    design.percentile = 95.0;
    design.rule = static_cast<DesignRule>(9);
    EXPECT_FALSE(is_whole_design(design));
    design.rule = DesignRule::own;
    design.energy_factor = 0.5;
    EXPECT_FALSE(is_whole_design(design));
    design.energy_factor = 1.2;
    design.sold_heights_m.clear();
    EXPECT_FALSE(is_whole_design(design));
}

TEST(StoredPath, IsWholeWhereItLiesOnTheTerrain) {
    StoredPath path;
    path.cover = rockfall::Cover::bare;
    path.body = rockfall::Rock::sphere(1.0, 2700.0);
    path.pieces.resize(1);
    path.pieces[0].triangle = 1;
    path.pieces[0].first = 0.5;
    EXPECT_TRUE(is_whole_path(path, 2));
    EXPECT_FALSE(is_whole_path(path, 1));
    path.pieces[0].first = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_whole_path(path, 2));
    path.pieces.clear();
    path.body.mass_kg = 0.0;
    EXPECT_FALSE(is_whole_path(path, 2));
    path.body.mass_kg = 1.0;
    path.cover = static_cast<rockfall::Cover>(7);
    EXPECT_FALSE(is_whole_path(path, 2));
}

}  // namespace
}  // namespace coupling::net_paths_test
