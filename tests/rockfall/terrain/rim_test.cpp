#include "rockfall/terrain/rim.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "rockfall/terrain/mesh.hpp"
#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::rim_test {
namespace {

/// An edge of the rim: the triangle inside, its middle, and a place inside from which a rock came.
struct WayOut {
    std::uint32_t triangle;
    Eigen::Vector2d end_m;
    Eigen::Vector2d from_m;
};

std::vector<WayOut> ways_out(const Terrain& terrain) {
    std::vector<WayOut> ways;
    for (std::uint32_t i = 0; i < terrain.triangles().size(); ++i) {
        const Triangle& t = terrain.triangles()[i];
        const auto corner = [&](std::size_t k) {
            const Vertex& v = terrain.vertices()[t.corners[k % 3]];
            return Eigen::Vector2d{v.x_m, v.y_m};
        };
        // No corner counts the same: else the way could point between two sides, too.
        const Eigen::Vector2d inside_m = 0.5 * corner(0) + 0.3 * corner(1) + 0.2 * corner(2);
        for (std::size_t k = 0; k < 3; ++k) {
            if (t.neighbours[k] == no_triangle) {
                ways.push_back({i, 0.5 * (corner(k) + corner(k + 1)), inside_m});
            }
        }
    }
    return ways;
}

RimPart part_of(const Terrain& terrain, const WayOut& way) {
    return terrain.rim().part_at(terrain, way.triangle, way.end_m, way.from_m);
}

/// The same triangles with other places of their corners; `mirrors`: their order turns round.
Terrain moved(const Terrain& terrain, const Eigen::Matrix2d& by, bool mirrors) {
    std::vector<Vertex> vertices;
    for (const Vertex& v : terrain.vertices()) {
        const Eigen::Vector2d place_m = by * Eigen::Vector2d{v.x_m, v.y_m};
        vertices.push_back({place_m.x(), place_m.y(), v.z_m});
    }
    std::vector<Triangle> triangles{terrain.triangles().begin(), terrain.triangles().end()};
    for (Triangle& t : triangles) {
        if (mirrors) {
            std::swap(t.corners[1], t.corners[2]);
            std::swap(t.neighbours[0], t.neighbours[2]);
        }
    }
    return Terrain{Eigen::Vector2d::Zero(), std::move(vertices), std::move(triangles)};
}

RimPart moved(RimPart part, const Eigen::Matrix2d& by) {
    if (is_hole(part)) {
        return part;
    }
    const std::array<Eigen::Vector2d, rim_sides> towards{Eigen::Vector2d{0.0, 1.0}, Eigen::Vector2d{1.0, 0.0},
                                                         Eigen::Vector2d{0.0, -1.0},
                                                         Eigen::Vector2d{-1.0, 0.0}};
    const Eigen::Vector2d now = by * towards[static_cast<std::size_t>(part)];
    for (std::size_t side = 0; side < rim_sides; ++side) {
        if ((now - towards[side]).norm() < 1e-9) {
            return static_cast<RimPart>(side);
        }
    }
    ADD_FAILURE() << "no side";
    return part;
}

config::Raster<double> grid_with_holes() {
    config::Raster<double> heights = tilted_grid(frame_of(20, 14));
    for (const config::Cell cell : {config::Cell{5, 5}, config::Cell{6, 5}, config::Cell{12, 8}}) {
        heights.at(cell) = missing;
    }
    return heights;
}

TEST(Rim, NamesTheSidesOfAGrid) {
    const Terrain terrain = triangulate(tilted_grid(frame_of(20, 14)), 0.0);
    EXPECT_TRUE(terrain.rim().holes().empty());
    constexpr double far_m = 1e9;
    double west_m = far_m, east_m = -far_m, south_m = far_m, north_m = -far_m;
    for (const Vertex& v : terrain.vertices()) {
        west_m = std::min(west_m, v.x_m);
        east_m = std::max(east_m, v.x_m);
        south_m = std::min(south_m, v.y_m);
        north_m = std::max(north_m, v.y_m);
    }
    std::map<RimPart, int> edges;
    for (const WayOut& way : ways_out(terrain)) {
        const RimPart part = part_of(terrain, way);
        ++edges[part];
        const double off_m = part == RimPart::north   ? north_m - way.end_m.y()
                             : part == RimPart::south ? way.end_m.y() - south_m
                             : part == RimPart::east  ? east_m - way.end_m.x()
                                                      : way.end_m.x() - west_m;
        EXPECT_NEAR(off_m, 0.0, 1e-6);
    }
    EXPECT_EQ(edges,
              (std::map<RimPart, int>{
                  {RimPart::north, 19}, {RimPart::east, 13}, {RimPart::south, 19}, {RimPart::west, 13}}));
}

TEST(Rim, FindsHolesByTheirMiddle) {
    const config::Raster<double> heights = grid_with_holes();
    const Terrain terrain = triangulate(heights, 0.0);
    ASSERT_EQ(terrain.rim().holes().size(), 2U);
    std::map<RimPart, int> edges;
    for (const WayOut& way : ways_out(terrain)) {
        const RimPart part = part_of(terrain, way);
        ++edges[part];
        if (is_hole(part)) {
            const Hole& hole = terrain.rim().holes()[hole_of(part)];
            EXPECT_LT((hole.centre_m - way.end_m).norm(), 2.0 * heights.frame.cell_width_m);
        }
    }
    EXPECT_EQ(edges.size(), 6U) << "four sides and two holes";
    for (const config::Cell cell : {config::Cell{12, 8}}) {
        const Eigen::Vector2d middle_m{heights.frame.x_centre_m(cell.column),
                                       heights.frame.y_centre_m(cell.row)};
        double nearest_m = 1e9;
        for (const Hole& hole : terrain.rim().holes()) {
            nearest_m = std::min(nearest_m, (terrain.origin_m() + hole.centre_m - middle_m).norm());
        }
        EXPECT_LT(nearest_m, 1e-6) << "a hole of one cell is even on all sides";
    }
}

TEST(Rim, TurnsAndMirrorsWithTheTerrain) {
    const Terrain grid = triangulate(grid_with_holes(), 0.0);
    const Terrain points = triangulate(scattered_points(400, 200.0, 5), 30.0);
    Eigen::Matrix2d quarter, east_west, diagonal;
    quarter << 0.0, -1.0, 1.0, 0.0;
    east_west << -1.0, 0.0, 0.0, 1.0;
    diagonal << 0.0, 1.0, 1.0, 0.0;
    for (const Terrain* terrain : {&grid, &points}) {
        for (const Eigen::Matrix2d& by : {quarter, Eigen::Matrix2d{quarter * quarter}, east_west, diagonal}) {
            const bool mirrors = by.determinant() < 0.0;
            const Terrain other = moved(*terrain, by, mirrors);
            ASSERT_EQ(other.rim().holes().size(), terrain->rim().holes().size());
            for (const WayOut& way : ways_out(*terrain)) {
                const WayOut same{way.triangle, by * way.end_m, by * way.from_m};
                const RimPart part = part_of(*terrain, way);
                const RimPart now = part_of(other, same);
                if (is_hole(part)) {
                    ASSERT_TRUE(is_hole(now));
                    EXPECT_LT((by * terrain->rim().holes()[hole_of(part)].centre_m -
                               other.rim().holes()[hole_of(now)].centre_m)
                                  .norm(),
                              1e-6);
                } else {
                    EXPECT_EQ(now, moved(part, by));
                }
            }
        }
    }
}

TEST(Rim, FindsTheEdgeOfABlockThatIsBeyond) {
    // A block is found outside after a step: its last triangle need not be at the rim, or is not known.
    const Terrain terrain = triangulate(tilted_grid(frame_of(20, 14)), 0.0);
    for (const WayOut& way : ways_out(terrain)) {
        const Eigen::Vector2d beyond_m = way.end_m + 0.02 * (way.end_m - way.from_m);
        const RimPart part = part_of(terrain, way);
        EXPECT_EQ(terrain.rim().part_at(terrain, no_triangle, beyond_m, way.from_m), part);
        for (const std::uint32_t next : terrain.triangles()[way.triangle].neighbours) {
            if (next != no_triangle) {
                const RimPart found = terrain.rim().part_at(terrain, next, beyond_m, way.from_m);
                EXPECT_FALSE(is_hole(found));
            }
        }
    }
}

}  // namespace
}  // namespace rockfall::rim_test
