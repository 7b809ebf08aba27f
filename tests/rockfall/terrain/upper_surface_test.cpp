#include "rockfall/terrain/upper_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "config/random/stream.hpp"

namespace rockfall::upper_surface_test {
namespace {

/// Faces over the corners of a grid, two a cell, with their ground.
void add_patch(Tin& tin, double west_m, double south_m, int columns, int rows, double spacing_m,
               std::uint32_t ground, const std::function<double(double, double)>& height_m,
               bool turned_over = false) {
    const auto first = static_cast<std::uint32_t>(tin.vertices_m.size());
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const double x = west_m + column * spacing_m;
            const double y = south_m + row * spacing_m;
            tin.vertices_m.emplace_back(x, y, height_m(x, y));
        }
    }
    const auto at = [&](int column, int row) {
        return first + static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            std::array<std::uint32_t, 3> lower{at(column, row), at(column + 1, row), at(column + 1, row + 1)};
            std::array<std::uint32_t, 3> upper{at(column, row), at(column + 1, row + 1), at(column, row + 1)};
            if (turned_over) {
                std::swap(lower[1], lower[2]);
                std::swap(upper[1], upper[2]);
            }
            tin.faces.push_back({lower, ground});
            tin.faces.push_back({upper, ground});
        }
    }
}

double slope_m(double x, double y) {
    return 500.0 - 0.5 * x + 0.02 * y;
}
double roof_m(double x, double y) {
    return slope_m(x, y) + 8.0;
}

/// A slope with a roof of 8 x 6 m over it, 8 m above, as a wall scanned from the front leaves it.
Tin with_roof() {
    Tin tin;
    add_patch(tin, 0.0, 0.0, 20, 15, 2.0, 1, slope_m);
    add_patch(tin, 11.0, 9.0, 4, 3, 2.0, 2, roof_m);
    add_patch(
        tin, 11.0, 9.0, 4, 3, 2.0, 3, [](double x, double y) { return roof_m(x, y) - 1.0; }, true);
    return tin;
}

TEST(UpperSurface, KeepsTheRoofAndTheGroundBesideIt) {
    const Tin given = with_roof();
    EXPECT_FALSE(checked(given).is_sound());
    const UpperSurface upper = upper_surface(given);
    const CheckedTin result = checked(upper.tin);
    ASSERT_TRUE(result.is_sound());
    EXPECT_TRUE(result.findings.empty());  // no hole where the ground below was left out
    const Terrain terrain = terrain_of(result.tin);
    const auto height_m = [&](double x, double y) {
        return terrain.height_m(x - terrain.origin_m().x(), y - terrain.origin_m().y()).value();
    };
    EXPECT_NEAR(height_m(14.3, 12.1), roof_m(14.3, 12.1), 1e-9);
    EXPECT_NEAR(height_m(5.0, 5.0), slope_m(5.0, 5.0), 1e-9);
    EXPECT_NEAR(height_m(30.0, 25.0), slope_m(30.0, 25.0), 1e-9);
    // The underside of the roof is gone as a whole, and the ground faces that the roof reaches over.
    std::size_t of_underside = 0;
    for (const CoveredFace& face : upper.left_out) {
        of_underside += given.faces[face.number].surface == 3 ? 1 : 0;
        EXPECT_NE(given.faces[face.number].surface, 2U);
    }
    EXPECT_EQ(of_underside, 24U);
    EXPECT_GT(upper.left_out.size(), 24U);
    EXPECT_GT(upper.filled, 0U);
}

TEST(UpperSurface, GivesEachFaceTheGroundThatIsSeenThere) {
    const UpperSurface upper = upper_surface(with_roof());
    for (const TinFace& face : upper.tin.faces) {
        const Eigen::Vector3d middle_m =
            (upper.tin.vertices_m[face.corners[0]] + upper.tin.vertices_m[face.corners[1]] +
             upper.tin.vertices_m[face.corners[2]]) /
            3.0;
        const bool under_roof =
            middle_m.x() > 11.0 && middle_m.x() < 19.0 && middle_m.y() > 9.0 && middle_m.y() < 15.0;
        EXPECT_EQ(face.surface, under_roof ? 2U : 1U) << middle_m.transpose();
    }
}

TEST(UpperSurface, IsNeverBelowAnyGivenFaceThatStayed) {
    // Sheets of random height over each other: seen from above, the highest of them wherever it stayed whole.
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const config::RandomStream stream{{seed, 0, 0, 1}, config::Purpose::test};
        Tin tin;
        add_patch(tin, 0.0, 0.0, 12, 12, 2.0, 1, slope_m);
        for (std::uint32_t sheet = 0; sheet < 3; ++sheet) {
            const auto u = stream.uniforms_of(sheet);
            const double rise_m = 2.0 + 6.0 * u[2];
            add_patch(tin, 1.0 + 12.0 * u[0], 1.0 + 12.0 * u[1], 4, 4, 1.3, 2 + sheet,
                      [&](double x, double y) { return slope_m(x, y) + rise_m; });
        }
        const UpperSurface upper = upper_surface(tin);
        const CheckedTin result = checked(upper.tin);
        ASSERT_TRUE(result.is_sound()) << "seed " << seed;
        std::vector<bool> is_left_out(tin.faces.size(), false);
        for (const CoveredFace& face : upper.left_out) {
            is_left_out[face.number] = true;
        }
        const Terrain terrain = terrain_of(result.tin);
        for (std::size_t f = 0; f < tin.faces.size(); ++f) {
            const auto& [a, b, c] = tin.faces[f].corners;
            const Eigen::Vector3d middle_m =
                (tin.vertices_m[a] + tin.vertices_m[b] + tin.vertices_m[c]) / 3.0;
            const auto height_m = terrain.height_m(middle_m.x() - terrain.origin_m().x(),
                                                   middle_m.y() - terrain.origin_m().y());
            ASSERT_TRUE(height_m) << "seed " << seed << ", face " << f;
            if (!is_left_out[f]) {
                EXPECT_NEAR(*height_m, middle_m.z(), 1e-9) << "seed " << seed << ", face " << f;
            }
        }
    }
}

TEST(UpperSurface, LeavesASoundSurfaceAsItIs) {
    Tin tin;
    add_patch(tin, 0.0, 0.0, 8, 5, 2.0, 4, slope_m);
    const UpperSurface upper = upper_surface(tin);
    EXPECT_TRUE(upper.left_out.empty());
    EXPECT_EQ(upper.filled, 0U);
    EXPECT_EQ(upper.tin.faces.size(), tin.faces.size());
}

TEST(UpperSurface, OfAClosedBodyIsItsTop) {
    // A box of 10 x 10 x 6 m with upright sides.
    Tin tin;
    add_patch(tin, 0.0, 0.0, 1, 1, 10.0, 1, [](double, double) { return 106.0; });
    add_patch(
        tin, 0.0, 0.0, 1, 1, 10.0, 1, [](double, double) { return 100.0; }, true);
    const auto v = [](int corner, bool above) {
        return static_cast<std::uint32_t>((above ? 0 : 4) + corner);
    };
    const std::array<int, 4> around{0, 1, 3, 2};
    for (std::size_t i = 0; i < 4; ++i) {
        const int from = around[i];
        const int to = around[(i + 1) % 4];
        tin.faces.push_back({{v(from, false), v(to, false), v(to, true)}, 1});
        tin.faces.push_back({{v(from, false), v(to, true), v(from, true)}, 1});
    }
    const UpperSurface upper = upper_surface(tin);
    const CheckedTin result = checked(upper.tin);
    ASSERT_TRUE(result.is_sound());
    const Terrain terrain = terrain_of(result.tin);
    EXPECT_NEAR(terrain.height_m(5.0 - terrain.origin_m().x(), 5.0 - terrain.origin_m().y()).value(), 106.0,
                1e-9);
    EXPECT_GE(upper.left_out.size(), 2U);
}

}  // namespace
}  // namespace rockfall::upper_surface_test
