#include "rockfall/terrain/contact_zone.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "rockfall/terrain/mesh.hpp"
#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::contact_zone_test {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// The zone of one radius, of heights that are without noise.
template <class Heights>
auto zone_of(const Heights& heights, double radius_m, double largest_shift_m) {
    return contact_zone(heights, {.given_radius_m = radius_m, .largest_shift_m = largest_shift_m},
                        HeightNoise{});
}

double largest_difference_m(const config::Raster<double>& a, const config::Raster<double>& b) {
    double largest_m = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        EXPECT_EQ(std::isnan(a.values[i]), std::isnan(b.values[i]));
        if (!std::isnan(a.values[i])) {
            largest_m = std::max(largest_m, std::abs(a.values[i] - b.values[i]));
        }
    }
    return largest_m;
}

std::vector<Eigen::Vector3d> points_of(const config::Raster<double>& heights) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        points.emplace_back(heights.frame.x_centre_m(cell.column), heights.frame.y_centre_m(cell.row),
                            heights.values[i]);
    }
    return points;
}

/// Root mean square of the angle between facets and the plane that the noise was laid on.
double facet_noise_deg(const Terrain& terrain) {
    const Eigen::Vector3d up = Eigen::Vector3d{-0.25, -0.78, 1.0}.normalized();
    double sum = 0.0;
    for (std::uint32_t i = 0; i < terrain.triangles().size(); ++i) {
        const double sine = terrain.plane_of(i).normal().cross(up).norm();
        sum += sine * sine;
    }
    constexpr double deg_per_rad = 57.295779513082321;
    return deg_per_rad * std::sqrt(sum / static_cast<double>(terrain.triangles().size()));
}

RC_GTEST_PROP(ContactZone, KeepsPlanesAtBordersAndBesideHoles, (std::uint64_t seed)) {
    config::GridFrame frame = frame_of(15, 12);
    frame.cell_height_m = *rc::gen::element(3.0, frame.cell_width_m);
    config::Raster<double> plane = tilted_grid(frame);
    punch_holes(plane, *rc::gen::element(0.0, 0.1, 0.4, 0.8), seed);
    const double radius_m = *rc::gen::element(5.1, 8.0, 12.0, 60.0, 1e6);
    RC_ASSERT(largest_difference_m(zone_of(plane, radius_m, no_limit), plane) < 1e-9);
}

TEST(ContactZone, KeepsThePlaneOfScatteredPoints) {
    std::vector<Eigen::Vector3d> points = scattered_points(2000, 100.0, 21);
    for (Eigen::Vector3d& point : points) {
        point.z() = 0.3 * (point.x() - 177198.0) - 0.9 * (point.y() - 376897.0);
    }
    for (const double radius_m : {1.0, 5.0, 20.0}) {
        const std::vector<Eigen::Vector3d> felt = zone_of(points, radius_m, no_limit);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_LT((felt[i] - points[i]).norm(), 1e-8);
        }
    }
}

TEST(ContactZone, IsTheSameForAGridAndItsPoints) {
    config::Raster<double> heights = rough_grid(frame_of(30, 20), 0.3, 22);
    punch_holes(heights, 0.1, 22);
    const config::Raster<double> felt = zone_of(heights, 14.0, 0.2);
    const std::vector<Eigen::Vector3d> felt_points = zone_of(points_of(heights), 14.0, 0.2);
    for (std::size_t i = 0; i < felt.values.size(); ++i) {
        if (std::isnan(heights.values[i])) {
            EXPECT_TRUE(std::isnan(felt.values[i]));
            EXPECT_TRUE(std::isnan(felt_points[i].z()));
        } else {
            EXPECT_NEAR(felt_points[i].z(), felt.values[i], 1e-9);
        }
    }
}

TEST(ContactZone, ReturnsTheInputWhereTheSupportHoldsOnePoint) {
    const config::Raster<double> heights = rough_grid(frame_of(10, 10, 5.0), 0.3, 23);
    for (const double radius_m : {0.0, 2.0, 5.0}) {
        EXPECT_EQ(zone_of(heights, radius_m, 1.0).values, heights.values);
        const std::vector<Eigen::Vector3d> points = points_of(heights);
        EXPECT_EQ(zone_of(points, 0.999 * radius_m, 1.0), points);
    }
    EXPECT_EQ(zone_of(heights, 20.0, 0.0).values, heights.values);
}

TEST(ContactZone, WeighsNeighboursByTheTricube) {
    // Four neighbours at half the radius: weight (1 - 1/8)^3 each; the diagonal ones at 0.7071 of it.
    config::Raster<double> heights{frame_of(5, 5, 1.0), 0.0};
    heights.at({2, 2}) = 0.1;  // too little for a step
    const double side = std::pow(1.0 - 1.0 / 8.0, 3.0);
    const double diagonal = std::pow(1.0 - std::pow(0.5, 1.5), 3.0);
    const config::Raster<double> felt = zone_of(heights, 2.0, no_limit);
    EXPECT_NEAR(felt.at({2, 2}), 0.1 / (1.0 + 4.0 * side + 4.0 * diagonal), 1e-12);
}

TEST(ContactZone, LowersASingleWrongHeight) {
    config::Raster<double> heights{frame_of(9, 9, 1.0), 0.0};
    heights.at({4, 4}) = 1.0;
    EXPECT_LT(zone_of(heights, 2.0, no_limit).at({4, 4}), 0.3);
}

TEST(ContactZone, MovesNoPointFurtherThanTheLimit) {
    // A rounded ridge whose curvature would lower it by about 0.6 m.
    const config::Raster<double> ridge = grid_of(
        frame_of(60, 10, 1.0), [](double x_m, double) { return 100.0 - 0.1 * (x_m - 30.0) * (x_m - 30.0); });
    EXPECT_GT(largest_difference_m(zone_of(ridge, 10.0, no_limit), ridge), 0.5);
    EXPECT_NEAR(largest_difference_m(zone_of(ridge, 10.0, 0.2), ridge), 0.2, 1e-9);
}

TEST(ContactZone, LeavesWallsAndWhatTheyStandOn) {
    // A cliff of 30 m between two terraces, and a wall of 60 degrees over an even slope.
    const config::Raster<double> cliff =
        grid_of(frame_of(30, 10, 1.0), [](double x_m, double) { return x_m < 15.0 ? 130.0 : 100.0; });
    EXPECT_LT(largest_difference_m(zone_of(cliff, 5.0, no_limit), cliff), 1e-9);
    const config::Raster<double> wall = grid_of(frame_of(60, 20, 1.0), [](double x_m, double) {
        return x_m < 20.0   ? 100.0
               : x_m < 30.0 ? 100.0 - std::sqrt(3.0) * (x_m - 20.0)
                            : 100.0 - std::sqrt(3.0) * 10.0 - 0.2 * (x_m - 30.0);
    });
    const config::Raster<double> felt = zone_of(wall, 4.0, no_limit);
    // On the faces nothing moves; one point to either side of a break may.
    for (const int column : {10, 15, 17, 23, 25, 26, 33, 35, 45}) {
        EXPECT_NEAR(felt.at({column, 10}), wall.at({column, 10}), 0.03) << column;
    }
    EXPECT_LT(largest_difference_m(felt, wall), 0.35);
}

TEST(ContactZone, StillTakesTheNoiseOutBesideAWall) {
    config::Raster<double> rough = rough_grid(frame_of(120, 120, 1.0), 0.1, 25);
    for (std::size_t i = 0; i < rough.values.size(); ++i) {
        rough.values[i] += rough.frame.cell_of(i).column < 60 ? 40.0 : 0.0;
    }
    const config::Raster<double> felt =
        contact_zone(rough, {.given_radius_m = 4.0, .largest_shift_m = no_limit}, HeightNoise{rough});
    const auto roughness_m = [](const config::Raster<double>& heights, int column) {
        double sum = 0.0;
        for (int row = 10; row < 110; ++row) {
            const double bend_m = heights.at({column, row - 1}) - 2.0 * heights.at({column, row}) +
                                  heights.at({column, row + 1});
            sum += bend_m * bend_m;
        }
        return std::sqrt(sum / 100.0);
    };
    for (const int column : {50, 56, 63, 70}) {
        EXPECT_LT(roughness_m(felt, column), 0.35 * roughness_m(rough, column)) << column;
    }
}

TEST(ContactZone, TakesTheNoiseOutOfTheFacets) {
    for (const double cell_m : {1.0, 2.5}) {
        const config::Raster<double> rough = rough_grid(frame_of(120, 120, cell_m), 0.3, 24);
        const double before_deg = facet_noise_deg(triangulate(rough, 0.0));
        const double after_deg = facet_noise_deg(triangulate(zone_of(rough, 8.0, 2.0), 0.0));
        EXPECT_GT(before_deg, 8.0);
        EXPECT_LT(after_deg, 1.5);
    }
}

}  // namespace
}  // namespace rockfall::contact_zone_test
