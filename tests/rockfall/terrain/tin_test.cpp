#include "rockfall/terrain/tin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "rockfall/terrain/edges.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::tin_test {
namespace {

using testing::heights_of;

/// A terrain taken apart into faces in absolute coordinates, `apart`: each with vertices of its own.
Tin tin_of(const Terrain& terrain, bool apart = false) {
    Tin tin;
    for (const Vertex& v : terrain.vertices()) {
        tin.vertices_m.emplace_back(v.x_m + terrain.origin_m().x(), v.y_m + terrain.origin_m().y(), v.z_m);
    }
    const std::vector<Eigen::Vector3d> shared = tin.vertices_m;
    for (const Triangle& t : terrain.triangles()) {
        TinFace face{{t.corners[0], t.corners[1], t.corners[2]}};
        for (std::uint32_t& corner : face.corners) {
            if (apart) {
                tin.vertices_m.push_back(shared[corner]);
                corner = static_cast<std::uint32_t>(tin.vertices_m.size() - 1);
            }
        }
        tin.faces.push_back(face);
    }
    return tin;
}

double hills_m(double x, double y) {
    return 900.0 - 0.6 * x + 0.01 * (x - 40.0) * (y - 30.0) + 0.1 * y;
}

Terrain grid_terrain() {
    return triangulate(heights_of({12, 9, 1000.0, 2000.0, 10.0, 10.0},
                                  [](double x, double y) { return hills_m(x - 1000.0, y - 2000.0); }),
                       0.0);
}

/// Faces over the corners (column, row) of a grid of this spacing; two faces a cell; rows go northwards.
Tin patch(int columns, int rows, double spacing_m, const std::function<double(double, double)>& height_m) {
    Tin tin;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const double x = column * spacing_m;
            const double y = row * spacing_m;
            tin.vertices_m.emplace_back(x, y, height_m(x, y));
        }
    }
    const auto at = [&](int column, int row) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            tin.faces.push_back({{at(column, row), at(column + 1, row), at(column + 1, row + 1)}});
            tin.faces.push_back({{at(column, row), at(column + 1, row + 1), at(column, row + 1)}});
        }
    }
    return tin;
}

double even_m(double x, double) {
    return 500.0 - 0.5 * x;
}

std::optional<TinFinding> found(const CheckedTin& checked, TinFault fault) {
    const auto it = std::find_if(checked.findings.begin(), checked.findings.end(),
                                 [&](const TinFinding& finding) { return finding.fault == fault; });
    return it == checked.findings.end() ? std::nullopt : std::optional{*it};
}

/// A plateau of 20 m, a wall of 12 m at x = 20 in rows of faces, ground of 20 m before it; north-south 20 m.
Tin cliff(double overhang_m = 0.0) {
    Tin tin;
    const std::vector<std::pair<double, double>> line{{0.0, 112.0},
                                                      {20.0, 112.0},
                                                      {20.0 - 0.5 * overhang_m, 106.0},
                                                      {20.0 - overhang_m, 100.0},
                                                      {40.0, 98.0}};
    for (const double y : {0.0, 10.0, 20.0}) {
        for (const auto& [x, z] : line) {
            tin.vertices_m.emplace_back(x, y, z);
        }
    }
    const auto at = [&](std::size_t k, std::size_t row) {
        return static_cast<std::uint32_t>(row * line.size() + k);
    };
    for (std::size_t row = 0; row < 2; ++row) {
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            tin.faces.push_back({{at(k, row), at(k + 1, row), at(k + 1, row + 1)}});
            tin.faces.push_back({{at(k, row), at(k + 1, row + 1), at(k, row + 1)}});
        }
    }
    return tin;
}

TEST(CheckedTin, MakesTheSameTerrainOfItsFaces) {
    const Terrain terrain = grid_terrain();
    for (const bool apart : {false, true}) {
        const CheckedTin checked = rockfall::checked(tin_of(terrain, apart));
        EXPECT_TRUE(checked.findings.empty());
        ASSERT_TRUE(checked.is_sound());
        const Terrain again = terrain_of(checked.tin);
        EXPECT_EQ(again.vertices().size(), terrain.vertices().size());
        ASSERT_EQ(again.triangles().size(), terrain.triangles().size());
        for (std::size_t i = 0; i < again.triangles().size(); ++i) {
            // Along the same curve the same faces stand at the same places.
            const Plane mine = again.plane_of(static_cast<std::uint32_t>(i));
            const Plane given = terrain.plane_of(static_cast<std::uint32_t>(i));
            EXPECT_LT((mine.gradient - given.gradient).norm(), 1e-9);
            EXPECT_EQ(std::count(std::begin(again.triangles()[i].neighbours),
                                 std::end(again.triangles()[i].neighbours), no_triangle),
                      std::count(std::begin(terrain.triangles()[i].neighbours),
                                 std::end(terrain.triangles()[i].neighbours), no_triangle));
        }
    }
}

TEST(CheckedTin, KeepsTheGroundOfEachFace) {
    Tin tin = patch(4, 4, 5.0, even_m);
    for (TinFace& face : tin.faces) {
        face.surface = tin.vertices_m[face.corners[0]].x() < 9.0 ? 1 : 2;
    }
    const Terrain terrain = terrain_of(rockfall::checked(tin).tin);
    EXPECT_EQ(terrain.triangles()[*terrain.locate(4.0, 3.0)].surface, 1U);
    EXPECT_EQ(terrain.triangles()[*terrain.locate(14.0, 3.0)].surface, 2U);
}

TEST(CheckedTin, JoinsVerticesAndLeavesOutFacesThatLoseACorner) {
    Tin tin = patch(2, 2, 5.0, even_m);
    tin.vertices_m.push_back(tin.vertices_m[0]);
    tin.faces.push_back({{0, static_cast<std::uint32_t>(tin.vertices_m.size() - 1), 1}});
    const CheckedTin checked = rockfall::checked(tin);
    EXPECT_TRUE(checked.is_sound());
    EXPECT_EQ(checked.changes.joined, 1U);
    EXPECT_EQ(checked.changes.left_out, 1U);
    EXPECT_EQ(checked.tin.vertices_m.size(), 9U);
}

TEST(CheckedTin, TurnsFacesOverThatAllLookDown) {
    Tin tin = patch(3, 3, 5.0, even_m);
    for (TinFace& face : tin.faces) {
        std::swap(face.corners[0], face.corners[1]);
    }
    const CheckedTin checked = rockfall::checked(tin);
    EXPECT_TRUE(checked.changes.turned_over);
    EXPECT_TRUE(checked.is_sound());
    EXPECT_NEAR(*terrain_of(checked.tin).height_m(7.0, 8.0), even_m(7.0, 8.0), 1e-9);
}

TEST(CheckedTin, NamesAFlippedFace) {
    Tin tin = patch(5, 5, 4.0, even_m);
    std::swap(tin.faces[22].corners[0], tin.faces[22].corners[1]);
    const CheckedTin checked = rockfall::checked(tin);
    EXPECT_FALSE(checked.is_sound());
    ASSERT_TRUE(found(checked, TinFault::flipped));
    EXPECT_EQ(found(checked, TinFault::flipped)->count, 1U) << "not each of its sides";
    const TinFace& face = checked.tin.faces[22];
    const Eigen::Vector3d middle_m =
        (checked.tin.vertices_m[face.corners[0]] + checked.tin.vertices_m[face.corners[1]] +
         checked.tin.vertices_m[face.corners[2]]) /
        3.0;
    EXPECT_LT((found(checked, TinFault::flipped)->place_m - middle_m).norm(), 1e-9) << "not its neighbour";
}

TEST(CheckedTin, CountsFlippedNeighboursAsFaces) {
    Tin tin = patch(5, 5, 4.0, even_m);
    for (const std::size_t face : {22U, 23U, 24U, 40U}) {
        std::swap(tin.faces[face].corners[0], tin.faces[face].corners[1]);
    }
    EXPECT_EQ(found(rockfall::checked(tin), TinFault::flipped)->count, 4U);
}

TEST(FlippedFaces, OfASurfaceOfOneSideAreFoundToo) {
    // A strip of Moebius of five faces: however they turn, one edge disagrees.
    const std::vector<TinFace> faces{{{0, 1, 2}}, {{1, 3, 2}}, {{2, 3, 4}}, {{3, 0, 4}}, {{4, 0, 1}}};
    EXPECT_FALSE(flipped_faces(edges_of(faces)).empty());
}

TEST(CheckedTin, NamesADoubledFaceAndItsEdges) {
    Tin tin = patch(5, 5, 4.0, even_m);
    tin.faces.push_back(tin.faces[10]);
    const CheckedTin checked = rockfall::checked(tin);
    ASSERT_TRUE(found(checked, TinFault::doubled));
    const Eigen::Vector3d place_m = found(checked, TinFault::doubled)->place_m;
    EXPECT_NEAR(place_m.z(), even_m(place_m.x(), place_m.y()), 1e-9);
    EXPECT_TRUE(found(checked, TinFault::crowded));
    EXPECT_FALSE(checked.is_sound());
}

TEST(CheckedTin, NamesAnEdgeOfThreeFaces) {
    Tin tin = patch(4, 4, 5.0, even_m);
    tin.vertices_m.emplace_back(10.0, 10.0, 530.0);  // a fin on the surface
    const TinFace& face = tin.faces[12];
    tin.faces.push_back(
        {{face.corners[0], face.corners[1], static_cast<std::uint32_t>(tin.vertices_m.size() - 1)}});
    const CheckedTin checked = rockfall::checked(tin);
    ASSERT_TRUE(found(checked, TinFault::crowded));
    EXPECT_FALSE(checked.is_sound());
}

TEST(CheckedTin, NamesAFaceWithoutArea) {
    Tin tin = patch(2, 2, 5.0, even_m);
    tin.vertices_m.emplace_back(10.0, 5.0, even_m(10.0, 0.0));
    tin.vertices_m.emplace_back(10.0, 15.0, even_m(10.0, 0.0));
    tin.vertices_m.emplace_back(10.0, 25.0, even_m(10.0, 0.0));
    const auto last = static_cast<std::uint32_t>(tin.vertices_m.size());
    tin.faces.push_back({{last - 3, last - 2, last - 1}});
    EXPECT_EQ(found(rockfall::checked(tin), TinFault::no_area)->count, 1U);
}

TEST(CheckedTin, DoubtsAHoleAndAPartAndSaysWhere) {
    Tin tin = patch(6, 6, 5.0, even_m);
    tin.faces.erase(tin.faces.begin() + 2 * (2 * 6 + 3), tin.faces.begin() + 2 * (2 * 6 + 3) + 2);
    const Tin island = patch(1, 1, 5.0, even_m);
    const auto shift = static_cast<std::uint32_t>(tin.vertices_m.size());
    for (const Eigen::Vector3d& v : island.vertices_m) {
        tin.vertices_m.push_back(v + Eigen::Vector3d{50.0, 0.0, 0.0});
    }
    for (TinFace face : island.faces) {
        for (std::uint32_t& corner : face.corners) {
            corner += shift;
        }
        tin.faces.push_back(face);
    }
    const CheckedTin checked = rockfall::checked(tin);
    EXPECT_TRUE(checked.is_sound());
    ASSERT_TRUE(found(checked, TinFault::hole));
    EXPECT_EQ(found(checked, TinFault::hole)->size, 4U);
    EXPECT_NEAR(found(checked, TinFault::hole)->place_m.x(), 17.5, 1e-9);
    EXPECT_NEAR(found(checked, TinFault::hole)->place_m.y(), 12.5, 1e-9);
    ASSERT_TRUE(found(checked, TinFault::parts));
    EXPECT_EQ(found(checked, TinFault::parts)->size, 2U);
    EXPECT_FALSE(terrain_of(checked.tin).locate(17.5, 12.5));
}

TEST(CheckedTin, NamesPartsThatLieOverEachOther) {
    Tin tin = patch(6, 6, 5.0, even_m);
    const Tin above = patch(2, 2, 3.0, [](double x, double y) { return even_m(x, y) + 30.0; });
    const auto shift = static_cast<std::uint32_t>(tin.vertices_m.size());
    for (const Eigen::Vector3d& v : above.vertices_m) {
        tin.vertices_m.push_back(v + Eigen::Vector3d{11.0, 12.0, 0.0});
    }
    for (TinFace face : above.faces) {
        for (std::uint32_t& corner : face.corners) {
            corner += shift;
        }
        tin.faces.push_back(face);
    }
    const CheckedTin checked = rockfall::checked(tin);
    EXPECT_TRUE(found(checked, TinFault::overlap));
    EXPECT_FALSE(checked.is_sound());
}

TEST(CheckedTin, NamesASeamThatIsNotJoined) {
    // Two halves that overlap by a tenth of a micrometre.
    Tin tin = patch(2, 4, 5.0, even_m);
    const Tin east = patch(2, 4, 5.0, even_m);
    const auto shift = static_cast<std::uint32_t>(tin.vertices_m.size());
    for (const Eigen::Vector3d& v : east.vertices_m) {
        tin.vertices_m.push_back(v + Eigen::Vector3d{10.0 - 1e-7, 0.0, -5.0});
    }
    for (TinFace face : east.faces) {
        for (std::uint32_t& corner : face.corners) {
            corner += shift;
        }
        tin.faces.push_back(face);
    }
    EXPECT_TRUE(found(rockfall::checked(tin), TinFault::overlap));
}

TEST(CheckedTin, FindsASheetRightAboveAnother) {
    // The same plan, once 50 m higher; then with other vertices along its border, so that no edge is the
    // same.
    const auto with_upper = [](const Tin& upper) {
        Tin both = patch(6, 4, 10.0, even_m);
        const auto first = static_cast<std::uint32_t>(both.vertices_m.size());
        for (const Eigen::Vector3d& vertex : upper.vertices_m) {
            both.vertices_m.emplace_back(vertex.x(), vertex.y(), vertex.z() + 50.0);
        }
        for (TinFace face : upper.faces) {
            for (std::uint32_t& corner : face.corners) {
                corner += first;
            }
            both.faces.push_back(face);
        }
        return rockfall::checked(both);
    };
    for (const CheckedTin& checked :
         {with_upper(patch(6, 4, 10.0, even_m)), with_upper(patch(12, 8, 5.0, even_m))}) {
        EXPECT_FALSE(checked.is_sound());
        ASSERT_TRUE(found(checked, TinFault::overlap));
        EXPECT_GE(found(checked, TinFault::overlap)->count, 20U);
    }
}

TEST(CheckedTin, LeansAnUprightWallByACentimetreAtItsTop) {
    const CheckedTin checked = rockfall::checked(cliff());
    ASSERT_TRUE(checked.is_sound());
    EXPECT_EQ(checked.changes.leaned, 8U);
    EXPECT_DOUBLE_EQ(checked.changes.largest_lean_m, upright_lean_m);
    const Terrain terrain = terrain_of(checked.tin);
    EXPECT_NEAR(*terrain.height_m(19.989, 7.0), 112.0, 1e-6);
    EXPECT_NEAR(*terrain.height_m(19.995, 7.0), 106.0, 1e-6);  // half way down
    EXPECT_NEAR(*terrain.height_m(20.0, 7.0), 100.0, 1e-6);
    EXPECT_TRUE(found(rockfall::checked(cliff(0.006)), TinFault::overhang) == std::nullopt);
    EXPECT_TRUE(rockfall::checked(cliff(0.006)).is_sound());  // rounding of a survey
}

TEST(CheckedTin, NamesAnOverhangWithItsPlace) {
    const CheckedTin checked = rockfall::checked(cliff(2.0));
    EXPECT_FALSE(checked.is_sound());
    ASSERT_TRUE(found(checked, TinFault::overhang));
    EXPECT_EQ(found(checked, TinFault::overhang)->count, 8U);
    EXPECT_NEAR(found(checked, TinFault::overhang)->place_m.x(), 19.0, 1.0);
}

TEST(CheckedTin, NamesAWallThatCannotLean) {
    // Plateau of 5 mm between two walls: leaning both would turn it over.
    Tin tin;
    const std::vector<std::pair<double, double>> line{{0.0, 100.0},    {20.0, 100.0},   {20.0, 110.0},
                                                      {20.005, 110.0}, {20.005, 100.0}, {40.0, 100.0}};
    for (const double y : {0.0, 10.0}) {
        for (const auto& [x, z] : line) {
            tin.vertices_m.emplace_back(x, y, z);
        }
    }
    for (std::uint32_t k = 0; k + 1 < line.size(); ++k) {
        const auto above = static_cast<std::uint32_t>(line.size()) + k;
        tin.faces.push_back({{k, k + 1, above + 1}});
        tin.faces.push_back({{k, above + 1, above}});
    }
    const CheckedTin checked = rockfall::checked(tin);
    EXPECT_FALSE(checked.is_sound());
    EXPECT_TRUE(found(checked, TinFault::not_leaned));
}

TEST(CheckedTin, LeansWallsAroundACorner) {
    // A tower of 10 x 10 m on even ground, walls on all four sides.
    Tin tin;
    const std::array<Eigen::Vector2d, 4> way{
        Eigen::Vector2d{10.0, 10.0}, {20.0, 10.0}, {20.0, 20.0}, {10.0, 20.0}};
    const std::array<Eigen::Vector2d, 4> rim{
        Eigen::Vector2d{0.0, 0.0}, {30.0, 0.0}, {30.0, 30.0}, {0.0, 30.0}};
    for (const auto& [ring, z] : {std::pair{rim, 50.0}, std::pair{way, 50.0}, std::pair{way, 58.0}}) {
        for (const Eigen::Vector2d& p : ring) {
            tin.vertices_m.emplace_back(p.x(), p.y(), z);
        }
    }
    for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t next = (k + 1) % 4;
        for (const std::uint32_t ring : {0U, 4U}) {
            tin.faces.push_back({{ring + k, ring + next, ring + 4 + next}});
            tin.faces.push_back({{ring + k, ring + 4 + next, ring + 4 + k}});
        }
    }
    tin.faces.push_back({{8, 9, 10}});
    tin.faces.push_back({{8, 10, 11}});
    const CheckedTin checked = rockfall::checked(tin);
    ASSERT_TRUE(checked.is_sound());
    const Terrain terrain = terrain_of(checked.tin);
    EXPECT_NEAR(*terrain.height_m(15.0, 15.0), 58.0, 1e-9);
    EXPECT_NEAR(*terrain.height_m(9.99, 15.0), 50.0, 1e-9);
    EXPECT_NEAR(*terrain.height_m(15.0, 20.01), 50.0, 1e-9);
}

TEST(FallOverAWall, LandsAtItsFootWithTheEnergyOfItsHeight) {
    const CheckedTin checked = rockfall::checked(cliff());
    SurfaceType type;
    type.restitution = {0.3, 0.8};
    type.soil = testing::test_soil();
    const Slope slope{terrain_of(checked.tin), SurfaceMap::uniform(SurfaceId{0}), {type}};
    const Flight flight{{5.0, 9.0, 113.0}, {12.0, 0.0, 0.0}};
    std::vector<Stretch> stretches;
    const auto triangle = slope.terrain.locate(5.0, 9.0);
    ASSERT_TRUE(triangle);
    // From 1 m above the plateau it comes down after 0.45 s and 5.4 m; nearer to the edge it flies over it.
    const Landing landing = fly(slope.terrain, flight, *triangle, stretches);
    EXPECT_EQ(landing.end, FlightEnd::ground);
    EXPECT_LT(flight.position_m(landing.time_s).x(), 20.0);
    const Flight far{{19.0, 9.0, 113.0}, {12.0, 0.0, 0.0}};
    const auto start = slope.terrain.locate(19.0, 9.0);
    const Landing below = fly(slope.terrain, far, *start, stretches);
    ASSERT_EQ(below.end, FlightEnd::ground);
    const Eigen::Vector3d end = far.position_m(below.time_s);
    EXPECT_GT(end.x(), 20.0);
    EXPECT_NEAR(end.z(), 100.0 - 0.1 * (end.x() - 20.0), 1e-6);
}

}  // namespace
}  // namespace rockfall::tin_test
