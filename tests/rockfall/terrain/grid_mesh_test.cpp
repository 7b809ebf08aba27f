#include "rockfall/terrain/grid_mesh.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "rockfall/terrain/mesh.hpp"
#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::grid_mesh_test {
namespace {

/// Cells of any form, some of whose heights are missing.
config::Raster<double> any_grid() {
    const double width_m = *rc::gen::element(1.0, 0.7, 2.3);
    config::Raster<double> heights{{.columns = *rc::gen::inRange(1, 12),
                                    .rows = *rc::gen::inRange(1, 12),
                                    .x_west_m = *rc::gen::element(0.0, 600'123.4),
                                    .y_south_m = *rc::gen::element(0.0, 200'456.7),
                                    .cell_width_m = width_m,
                                    .cell_height_m = width_m * *rc::gen::element(1.0, 0.9)},
                                   0.0};
    const int of_ten_missing = *rc::gen::inRange(0, 6);
    for (double& height_m : heights.values) {
        height_m = *rc::gen::inRange(0, 10) < of_ten_missing ? missing : 0.01 * *rc::gen::inRange(0, 1000);
    }
    return heights;
}

/// As it is when it begins at the corner with the right angle.
Triangle from_right_angle(const Triangle& triangle, std::span<const Vertex> vertices) {
    for (std::size_t first = 0; first < 3; ++first) {
        const auto corner = [&](std::size_t i) { return (first + i) % 3; };
        const Vertex& here = vertices[triangle.corners[corner(0)]];
        const Vertex& next = vertices[triangle.corners[corner(1)]];
        const Vertex& last = vertices[triangle.corners[corner(2)]];
        const bool is_right =
            (next.x_m == here.x_m && last.y_m == here.y_m) || (next.y_m == here.y_m && last.x_m == here.x_m);
        if (is_right) {
            Triangle turned = triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                turned.corners[i] = triangle.corners[corner(i)];
                turned.neighbours[i] = triangle.neighbours[corner(i)];
            }
            return turned;
        }
    }
    ADD_FAILURE() << "a triangle without a right angle";
    return triangle;
}

RC_GTEST_PROP(MeshOfEveryCell, HasTheTrianglesThatASearchFindsInTheirOrder, ()) {
    const config::Raster<double> heights = any_grid();
    const Terrain searched = triangulate(heights, 0.0);
    const Terrain written = mesh_of_every_cell(heights);

    RC_ASSERT(written.origin_m() == searched.origin_m());
    RC_ASSERT(std::equal(written.vertices().begin(), written.vertices().end(), searched.vertices().begin(),
                         searched.vertices().end(), [](const Vertex& one, const Vertex& other) {
                             return one.x_m == other.x_m && one.y_m == other.y_m && one.z_m == other.z_m;
                         }));
    RC_ASSERT(written.triangles().size() == searched.triangles().size());
    for (std::size_t i = 0; i < written.triangles().size(); ++i) {
        const Triangle& one = written.triangles()[i];
        const Triangle other = from_right_angle(searched.triangles()[i], searched.vertices());
        RC_ASSERT(std::equal(one.corners, one.corners + 3, other.corners));
        RC_ASSERT(std::equal(one.neighbours, one.neighbours + 3, other.neighbours));
    }
}

TEST(MeshOfEveryCell, IsWhatTriangulateTakesForALargeGrid) {
    // One row more than 2^22 cells; a search would begin the triangles anywhere.
    config::Raster<double> heights{frame_of(2048, 2049), 0.0};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        heights.values[i] = static_cast<double>(i % 7);
    }
    const Terrain terrain = triangulate(heights, 0.0);
    ASSERT_EQ(terrain.triangles().size(), 2U * 2047U * 2048U);
    for (std::size_t i = 0; i < terrain.triangles().size(); i += 1000) {
        const Triangle& triangle = terrain.triangles()[i];
        const Triangle turned = from_right_angle(triangle, terrain.vertices());
        ASSERT_TRUE(std::equal(triangle.corners, triangle.corners + 3, turned.corners));
    }
}

}  // namespace
}  // namespace rockfall::grid_mesh_test
