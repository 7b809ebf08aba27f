#include "rockfall/terrain/mesh.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::mesh_test {
namespace {

/// Each triangle counter-clockwise, each neighbour across the same two corners and back.
void expect_consistent(const Terrain& terrain) {
    const auto triangles = terrain.triangles();
    const auto vertices = terrain.vertices();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        EXPECT_GT(twice_area_m2(vertices[t.corners[0]], vertices[t.corners[1]], vertices[t.corners[2]]), 0.0);
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (t.neighbours[edge] == no_triangle) {
                continue;
            }
            const Triangle& other = triangles[t.neighbours[edge]];
            const std::size_t back = static_cast<std::size_t>(
                std::find(other.neighbours, other.neighbours + 3, i) - other.neighbours);
            ASSERT_LT(back, 3U) << "triangle " << i;
            EXPECT_EQ(other.corners[back], t.corners[(edge + 1) % 3]);
            EXPECT_EQ(other.corners[(back + 1) % 3], t.corners[edge]);
        }
    }
}

/// Vertices - edges + triangles: 1 for a disc, one less for each hole.
int euler_characteristic(const Terrain& terrain) {
    int sides = 0;
    int borders = 0;
    for (const Triangle& t : terrain.triangles()) {
        sides += 3;
        borders += static_cast<int>(std::count(t.neighbours, t.neighbours + 3, no_triangle));
    }
    const int edges = (sides + borders) / 2;
    return static_cast<int>(terrain.vertices().size()) - edges + static_cast<int>(terrain.triangles().size());
}

double extent_of_centres_m2(const config::GridFrame& frame) {
    return (frame.columns - 1) * frame.cell_width_m * (frame.rows - 1) * frame.cell_height_m;
}

/// Centre of a cell in terrain coordinates, drawn to the middle by a billionth so that rounding puts none of
/// the outermost beyond the border.
Eigen::Vector2d centre_m(const Terrain& terrain, const config::GridFrame& frame, config::Cell cell) {
    const Eigen::Vector2d middle{0.5 * (frame.x_west_m + frame.x_east_m()),
                                 0.5 * (frame.y_south_m + frame.y_north_m())};
    const Eigen::Vector2d centre{frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)};
    return centre + 1e-9 * (middle - centre) - terrain.origin_m();
}

/// Largest vertical distance between the terrain and the known cell centres on it.
double largest_error_m(const Terrain& terrain, const config::Raster<double>& heights) {
    double largest_m = 0.0;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const Eigen::Vector2d place_m = centre_m(terrain, heights.frame, heights.frame.cell_of(i));
        const std::optional<double> height_m = terrain.height_m(place_m.x(), place_m.y());
        if (height_m && std::isfinite(heights.values[i])) {
            largest_m = std::max(largest_m, std::abs(*height_m - heights.values[i]));
        }
    }
    return largest_m;
}

TEST(TriangulateGrid, CoversTheExtentOfTheCellCentres) {
    const config::Raster<double> heights = rough_grid(frame_of(23, 17), 0.3, 1);
    const Terrain terrain = triangulate(heights, 0.0);
    expect_consistent(terrain);
    EXPECT_EQ(terrain.vertices().size(), heights.values.size());
    EXPECT_EQ(terrain.triangles().size(), 2U * 22U * 16U);
    EXPECT_EQ(euler_characteristic(terrain), 1);
    EXPECT_NEAR(plan_area_m2(terrain), extent_of_centres_m2(heights.frame), 1e-6);
}

TEST(TriangulateGrid, KeepsEveryHeightAtToleranceZero) {
    const config::Raster<double> heights = rough_grid(frame_of(23, 17), 0.3, 2);
    const Terrain terrain = triangulate(heights, 0.0);
    const Eigen::Vector2d origin_m = terrain.origin_m();
    EXPECT_EQ(origin_m, (Eigen::Vector2d{177198.0, 376897.0}));
    for (const Vertex& vertex : terrain.vertices()) {
        const config::Cell cell = heights.frame.cell_at(origin_m.x() + vertex.x_m, origin_m.y() + vertex.y_m);
        EXPECT_EQ(vertex.z_m, heights.at(cell));
        EXPECT_NEAR(vertex.x_m + origin_m.x(), heights.frame.x_centre_m(cell.column), 1e-9);
        EXPECT_NEAR(vertex.y_m + origin_m.y(), heights.frame.y_centre_m(cell.row), 1e-9);
    }
}

TEST(TriangulateGrid, TakesCellsThatAreNotSquare) {
    config::GridFrame frame = frame_of(12, 9);
    frame.cell_height_m = 2.3;
    const Terrain terrain = triangulate(rough_grid(frame, 0.3, 3), 0.0);
    expect_consistent(terrain);
    EXPECT_EQ(euler_characteristic(terrain), 1);
    EXPECT_NEAR(plan_area_m2(terrain), extent_of_centres_m2(frame), 1e-6);
}

TEST(TriangulateGrid, LeavesAHoleOfOneCellAsADiamond) {
    config::Raster<double> heights = tilted_grid(frame_of(9, 9));
    heights.at({4, 4}) = missing;
    const Terrain terrain = triangulate(heights, 0.0);
    expect_consistent(terrain);
    EXPECT_EQ(euler_characteristic(terrain), 0);
    EXPECT_NEAR(plan_area_m2(terrain), 62.0 * heights.frame.cell_area_m2(), 1e-6);
    const Eigen::Vector2d hole_m = centre_m(terrain, heights.frame, {4, 4});
    const double beyond_m = 0.51 * heights.frame.cell_width_m;
    EXPECT_FALSE(terrain.locate(hole_m.x(), hole_m.y()));
    EXPECT_TRUE(terrain.locate(hole_m.x() + beyond_m, hole_m.y() + beyond_m));
}

TEST(TriangulateGrid, IsTheSameEveryTime) {
    config::Raster<double> heights = rough_grid(frame_of(40, 30), 0.3, 4);
    punch_holes(heights, 0.05, 4);
    for (const double tolerance_m : {0.0, 0.2}) {
        const Terrain first = triangulate(heights, tolerance_m);
        const Terrain second = triangulate(heights, tolerance_m);
        ASSERT_EQ(first.triangles().size(), second.triangles().size());
        ASSERT_EQ(first.vertices().size(), second.vertices().size());
        EXPECT_EQ(
            std::memcmp(first.triangles().data(), second.triangles().data(), first.triangles().size_bytes()),
            0);
        EXPECT_EQ(
            std::memcmp(first.vertices().data(), second.vertices().data(), first.vertices().size_bytes()), 0);
    }
}

TEST(TriangulateGrid, MakesNothingOfAGridWithoutArea) {
    for (const config::GridFrame& frame : {frame_of(1, 1), frame_of(8, 1), frame_of(1, 8)}) {
        EXPECT_TRUE(triangulate(tilted_grid(frame), 0.0).triangles().empty());
        EXPECT_TRUE(triangulate(tilted_grid(frame), 0.1).triangles().empty());
    }
    const config::Raster<double> nothing{frame_of(5, 5), missing};
    EXPECT_TRUE(triangulate(nothing, 0.0).triangles().empty());
    EXPECT_TRUE(triangulate(nothing, 0.1).vertices().empty());
}

TEST(TriangulateGrid, PutsNeighboursNearEachOtherInMemory) {
    const Terrain terrain = triangulate(rough_grid(frame_of(100, 100), 0.3, 5), 0.0);
    double sum = 0.0;
    double pairs = 0.0;
    const auto triangles = terrain.triangles();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (const std::uint32_t neighbour : triangles[i].neighbours) {
            if (neighbour != no_triangle) {
                sum += std::abs(static_cast<double>(neighbour) - i) < 32.0 ? 1.0 : 0.0;
                pairs += 1.0;
            }
        }
    }
    // A square of 16 cells holds 32 triangles and loses about 16 of their 48 links to its border.
    EXPECT_GT(sum / pairs, 0.6);
}

TEST(Thinning, LeavesFourPointsOfAPlane) {
    const Terrain terrain = triangulate(tilted_grid(frame_of(50, 40)), 0.01);
    EXPECT_EQ(terrain.vertices().size(), 4U);
    EXPECT_EQ(terrain.triangles().size(), 2U);
}

TEST(Thinning, LeavesTheRimOfAHoleInAPlane) {
    config::Raster<double> heights = tilted_grid(frame_of(50, 40));
    heights.at({20, 20}) = missing;
    heights.at({21, 20}) = missing;
    const Terrain terrain = triangulate(heights, 0.01);
    EXPECT_EQ(terrain.vertices().size(), 4U + 10U);
    EXPECT_EQ(euler_characteristic(terrain), 0);
}

TEST(Thinning, StaysWithinTheTolerance) {
    const config::Raster<double> heights = rough_grid(frame_of(60, 50), 0.3, 6);
    std::size_t finer = heights.values.size();
    for (const double tolerance_m : {0.05, 0.2, 0.5, 1.5}) {
        const Terrain terrain = triangulate(heights, tolerance_m);
        expect_consistent(terrain);
        EXPECT_LE(largest_error_m(terrain, heights), tolerance_m + 1e-9);
        EXPECT_LT(terrain.vertices().size(), finer) << tolerance_m;
        finer = terrain.vertices().size();
    }
}

TEST(Thinning, KeepsARidgeSharp) {
    const config::Raster<double> heights =
        grid_of(frame_of(41, 41, 1.0), [](double x_m, double) { return 100.0 - std::abs(x_m - 20.5); });
    const Terrain terrain = triangulate(heights, 0.01);
    EXPECT_LE(terrain.vertices().size(), 8U);
    EXPECT_LE(largest_error_m(terrain, heights), 0.01);
}

RC_GTEST_PROP(Thinning, KeepsTheOutlineOfAnyHoles, (std::uint64_t seed)) {
    config::Raster<double> heights = rough_grid(frame_of(15, 12), 0.3, seed);
    punch_holes(heights, *rc::gen::element(0.02, 0.1, 0.3, 0.5), seed + 1);
    const Terrain every_cell = triangulate(heights, 0.0);
    const Terrain thinned = triangulate(heights, 0.4);
    expect_consistent(every_cell);
    expect_consistent(thinned);
    RC_ASSERT(euler_characteristic(every_cell) == euler_characteristic(thinned));
    RC_ASSERT(std::abs(plan_area_m2(every_cell) - plan_area_m2(thinned)) < 1e-6);
    RC_ASSERT(largest_error_m(thinned, heights) <= 0.4 + 1e-9);
}

RC_GTEST_PROP(TriangulateGrid, NeverCoversAMissingCell, (std::uint64_t seed)) {
    config::Raster<double> heights = rough_grid(frame_of(15, 12), 0.3, seed);
    punch_holes(heights, *rc::gen::element(0.02, 0.1, 0.3), seed + 1);
    for (const double tolerance_m : {0.0, 0.4}) {
        const Terrain terrain = triangulate(heights, tolerance_m);
        for (std::size_t i = 0; i < heights.values.size(); ++i) {
            const Eigen::Vector2d place_m = centre_m(terrain, heights.frame, heights.frame.cell_of(i));
            RC_ASSERT((std::isfinite(heights.values[i]) || !terrain.locate(place_m.x(), place_m.y())));
        }
    }
}

TEST(Thinning, CoversEveryCellOfAGridWithoutHoles) {
    const config::Raster<double> heights = rough_grid(frame_of(23, 17), 0.3, 8);
    const Terrain terrain = triangulate(heights, 0.3);
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const Eigen::Vector2d place_m = centre_m(terrain, heights.frame, heights.frame.cell_of(i));
        EXPECT_TRUE(terrain.locate(place_m.x(), place_m.y()));
    }
}

TEST(TriangulatePoints, CoversTheHull) {
    std::vector<Eigen::Vector3d> points = scattered_points(500, 100.0, 7);
    for (const double x_m : {0.0, 100.0}) {
        for (const double y_m : {0.0, 100.0}) {
            points.emplace_back(177198.0 + x_m, 376897.0 + y_m, 1000.0);
        }
    }
    const Terrain terrain = triangulate(points, 0.0);
    expect_consistent(terrain);
    EXPECT_EQ(terrain.vertices().size(), points.size());
    EXPECT_EQ(euler_characteristic(terrain), 1);
    EXPECT_NEAR(plan_area_m2(terrain), 1e4, 1e-6);
}

TEST(TriangulatePoints, CountTheFirstOfThoseInOnePlace) {
    const std::vector<Eigen::Vector3d> points = {{5, 5, 1},  {0, 0, 0},   {10, 0, 0},
                                                 {0, 10, 0}, {10, 10, 0}, {5, 5, 9}};
    const Terrain terrain = triangulate(points, 0.0);
    EXPECT_EQ(terrain.vertices().size(), 5U);
    EXPECT_DOUBLE_EQ(terrain.height_m(5.0, 5.0).value(), 1.0);
}

TEST(TriangulatePoints, LeaveOutLongEdgesAndWhatIsNotFinite) {
    const std::vector<Eigen::Vector3d> points = {
        {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {90, 90, 0}, {5, 5, missing}};
    EXPECT_EQ(triangulate(points, 0.0).triangles().size(), 2U);
    const Terrain terrain = triangulate(points, 20.0);
    EXPECT_EQ(terrain.triangles().size(), 1U);
    EXPECT_EQ(terrain.vertices().size(), 3U);
}

TEST(TriangulatePoints, MakeNothingOfALine) {
    EXPECT_TRUE(triangulate(std::vector<Eigen::Vector3d>{}, 0.0).triangles().empty());
    EXPECT_TRUE(triangulate(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 1, 1}}, 0.0).triangles().empty());
    EXPECT_TRUE(
        triangulate(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 1, 1}, {2, 2, 5}}, 0.0).triangles().empty());
}

}  // namespace
}  // namespace rockfall::mesh_test
