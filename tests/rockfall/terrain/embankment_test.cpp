#include "rockfall/terrain/embankment.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "rockfall/tally/target.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::embankment_test {
namespace {

using testing::heights_of;

/// A plane of 100 m by 100 m that falls along a direction.
Terrain plane(double tangent, double towards_rad, double cell_m = 5.0) {
    const int cells = static_cast<int>(100.0 / cell_m);
    const config::GridFrame frame{cells, cells, 0.0, 0.0, cell_m, cell_m};
    return triangulate(heights_of(frame,
                                  [&](double x, double y) {
                                      return 900.0 - tangent * (std::cos(towards_rad) * (x - 50.0) +
                                                                std::sin(towards_rad) * (y - 50.0));
                                  }),
                       0.0);
}

/// A line through the middle that turns by an angle against the x axis.
std::vector<Eigen::Vector2d> axis_through_middle(const Terrain& terrain, double angle_rad, double length_m) {
    const Eigen::Vector2d middle = Eigen::Vector2d{50.3, 49.6} - terrain.origin_m();
    const Eigen::Vector2d half = 0.5 * length_m * Eigen::Vector2d{std::cos(angle_rad), std::sin(angle_rad)};
    return {middle - half, middle + half};
}

/// Between two terrains over the same ground: how much higher the second one is, in all.
double volume_of(const Terrain& terrain) {
    double volume_m3 = 0.0;
    for (const Triangle& triangle : terrain.triangles()) {
        const Vertex& a = terrain.vertices()[triangle.corners[0]];
        const Vertex& b = terrain.vertices()[triangle.corners[1]];
        const Vertex& c = terrain.vertices()[triangle.corners[2]];
        const double area_m2 = 0.5 * ((b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m));
        volume_m3 += area_m2 * ((a.z_m - 900.0) + (b.z_m - 900.0) + (c.z_m - 900.0)) / 3.0;
    }
    return volume_m3;
}

double plan_area_of(const Terrain& terrain) {
    double area_m2 = 0.0;
    for (const Triangle& triangle : terrain.triangles()) {
        const Vertex& a = terrain.vertices()[triangle.corners[0]];
        const Vertex& b = terrain.vertices()[triangle.corners[1]];
        const Vertex& c = terrain.vertices()[triangle.corners[2]];
        const double part = 0.5 * ((b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m));
        EXPECT_GT(part, 0.0);
        area_m2 += part;
    }
    return area_m2;
}

/// Each neighbour shares the edge and knows of it.
void expect_joined(const Terrain& terrain) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
    for (std::uint32_t t = 0; t < terrain.triangles().size(); ++t) {
        const Triangle& triangle = terrain.triangles()[t];
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_new =
                edges.emplace(std::pair{triangle.corners[i], triangle.corners[(i + 1) % 3]}, t).second;
            ASSERT_TRUE(is_new);
        }
    }
    for (const auto& [edge, t] : edges) {
        const auto across = edges.find({edge.second, edge.first});
        const Triangle& triangle = terrain.triangles()[t];
        for (std::size_t i = 0; i < 3; ++i) {
            if (triangle.corners[i] == edge.first) {
                ASSERT_EQ(triangle.neighbours[i], across == edges.end() ? no_triangle : across->second);
            }
        }
    }
}

/// Across a plane slope, in closed form: the area between crown, faces and ground. `g`: how the ground rises
/// to the uphill side.
double section_m2(const Embankment& dam, double g) {
    const double h = std::abs(dam.rise_m);
    const double half = 0.5 * dam.width_m;
    const double up = dam.rise_m > 0.0 ? dam.uphill_tangent + g : dam.uphill_tangent - g;
    const double down = dam.rise_m > 0.0 ? dam.downhill_tangent - g : dam.downhill_tangent + g;
    const double high_up = dam.rise_m > 0.0 ? h - g * half : h + g * half;
    const double high_down = dam.rise_m > 0.0 ? h + g * half : h - g * half;
    return dam.width_m * h + 0.5 * high_up * high_up / up + 0.5 * high_down * high_down / down;
}

RC_GTEST_PROP(PlacedEmbankment, HasTheVolumeOfItsTrapezoidOnAPlaneInAnyDirection, ()) {
    const double towards = 0.01 * *rc::gen::inRange(0, 628);
    const double tangent = 0.01 * *rc::gen::inRange(5, 60);
    const bool is_dam = *rc::gen::arbitrary<bool>();
    // Across the slope, give or take 30 degrees.
    const double angle = towards + 1.5707963 + 0.01 * *rc::gen::inRange(-52, 53);
    const double rise = 0.1 * *rc::gen::inRange(15, 40);
    const Terrain ground = plane(tangent, towards);
    const Embankment dam{axis_through_middle(ground, angle, 23.7), is_dam ? rise : -rise,
                         0.1 * *rc::gen::inRange(10, 30), 0.01 * *rc::gen::inRange(90, 500),
                         0.01 * *rc::gen::inRange(90, 300)};
    const EmbankmentResult result = place(dam, ground);
    RC_ASSERT(result.placed.has_value());
    const double g = tangent * std::abs(std::sin(angle - towards));
    const double section = section_m2(dam, g);
    const double along = std::abs(std::cos(angle - towards));
    // Ends lean by 5 cm; their feet lie a little higher or lower along a line that is not level.
    const double lean = end_lean_m * 0.5 * 2.0;
    const double expected = (23.7 + lean) * section;
    RC_ASSERT(std::abs(result.placed->volume_m3 - expected) < 1e-3 * (1.0 + along * tangent) * expected);

    const Terrain carved = with_embankment(ground, *result.placed, 0);
    RC_ASSERT(std::abs(plan_area_of(carved) - plan_area_of(ground)) < 1e-6);
    const double heaped = (volume_of(carved) - volume_of(ground)) * (is_dam ? 1.0 : -1.0);
    RC_ASSERT(std::abs(heaped - expected) < 1e-3 * (1.0 + along * tangent) * expected);
    expect_joined(carved);
}

TEST(PlacedEmbankment, LeavesTheGroundBesideItAsItIsToTheLastBit) {
    const Terrain ground = plane(0.5, 0.3, 2.0);
    const Embankment dam{axis_through_middle(ground, 0.3 + 1.2, 30.0), 4.0, 2.0, 2.0, 1.0};
    const EmbankmentResult result = place(dam, ground);
    ASSERT_TRUE(result.placed.has_value());
    const Terrain carved = with_embankment(ground, *result.placed, 7);
    EXPECT_EQ(carved.origin_m(), ground.origin_m());

    Target outline;
    outline.parts = {result.placed->outline_m};
    using Corners = std::set<std::tuple<double, double, double>>;
    const auto corners_of = [](const Terrain& terrain, const Triangle& triangle) {
        Corners corners;
        for (const std::uint32_t corner : triangle.corners) {
            const Vertex& v = terrain.vertices()[corner];
            corners.insert({v.x_m, v.y_m, v.z_m});
        }
        return corners;
    };
    std::set<Corners> before;
    for (const Triangle& triangle : ground.triangles()) {
        before.insert(corners_of(ground, triangle));
    }
    std::size_t kept = 0;
    double faces_m2 = 0.0;
    for (const Triangle& triangle : carved.triangles()) {
        kept += before.contains(corners_of(carved, triangle)) ? 1 : 0;
        if (triangle.surface == 7) {
            const Vertex& a = carved.vertices()[triangle.corners[0]];
            const Vertex& b = carved.vertices()[triangle.corners[1]];
            const Vertex& c = carved.vertices()[triangle.corners[2]];
            faces_m2 += 0.5 * ((b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m));
        }
    }
    EXPECT_NEAR(faces_m2, result.placed->area_m2, 1e-6) << "the new ground, and nothing beside it";
    EXPECT_GT(kept, ground.triangles().size() * 8 / 10);

    // Far from it every place has the height that it had.
    for (double x = 1.0; x < 99.0; x += 3.7) {
        for (double y = 1.0; y < 99.0; y += 3.1) {
            const Eigen::Vector2d place = Eigen::Vector2d{x, y} - ground.origin_m();
            if (!ground.locate(place.x(), place.y())) {
                continue;
            }
            ASSERT_TRUE(carved.locate(place.x(), place.y()).has_value());
            const double difference_m =
                carved.height_m(place.x(), place.y()).value() - ground.height_m(place.x(), place.y()).value();
            if (is_inside(outline, place)) {
                EXPECT_GT(difference_m, -1e-9);
            } else {
                EXPECT_NEAR(difference_m, 0.0, 1e-9);
            }
        }
    }
}

TEST(PlacedEmbankment, FollowsABendWithFacesOfOneSlope) {
    const Terrain ground = plane(0.4, 0.0, 2.0);
    const Eigen::Vector2d origin_m = ground.origin_m();
    // Across the slope, which falls towards +x; the bend is open to the uphill side.
    const Embankment dam{{Eigen::Vector2d{42.0, 25.0} - origin_m, Eigen::Vector2d{50.0, 50.0} - origin_m,
                          Eigen::Vector2d{42.0, 75.0} - origin_m},
                         3.0,
                         2.0,
                         2.0,
                         1.2};
    const EmbankmentResult result = place(dam, ground);
    ASSERT_TRUE(result.placed.has_value());
    const PlacedEmbankment& placed = *result.placed;
    EXPECT_DOUBLE_EQ(placed.side_ends_m[3], [&] {
        double length_m = 0.0;
        for (std::size_t i = 1; i < placed.outline_m.size(); ++i) {
            length_m += (placed.outline_m[i] - placed.outline_m[i - 1]).norm();
        }
        return length_m;
    }());
    EXPECT_EQ(placed.outline_m.front(), placed.outline_m.back());
    const Terrain carved = with_embankment(ground, placed, 3);
    expect_joined(carved);
    const auto gradient_at = [&](double x, double y) {
        const auto triangle = carved.locate(x - origin_m.x(), y - origin_m.y());
        return carved.plane_of(triangle.value()).gradient;
    };
    // Perpendicular to either half of the axis, whose direction is (8, 25): the slopes that were asked for.
    const double length = std::hypot(8.0, 25.0);
    const Eigen::Vector2d left{-25.0 / length, 8.0 / length};
    const Eigen::Vector2d on_first{46.0, 37.5};
    const Eigen::Vector2d uphill = on_first + 1.5 * left;
    const Eigen::Vector2d downhill = on_first - 2.0 * left;
    EXPECT_NEAR(gradient_at(uphill.x(), uphill.y()).dot(left), -2.0, 1e-6);
    EXPECT_NEAR(gradient_at(downhill.x(), downhill.y()).dot(left), 1.2, 1e-6);
}

TEST(PlacedEmbankment, SaysWhyItCannotStandThere) {
    const Terrain slope = plane(0.7, 0.0);
    const Terrain level = plane(0.0, 0.0);
    const auto across = [&](double x, double y_from, double y_to) {
        return std::vector<Eigen::Vector2d>{Eigen::Vector2d{x, y_from} - slope.origin_m(),
                                            Eigen::Vector2d{x, y_to} - slope.origin_m()};
    };
    const auto fault_of = [](const Embankment& dam, const Terrain& ground) {
        const EmbankmentResult result = place(dam, ground);
        EXPECT_FALSE(result.placed.has_value());
        return result.problem.value().fault;
    };
    EXPECT_EQ(fault_of({across(50.0, 30.0, 70.0), 3.0, 2.0, 2.0, 0.69}, slope),
              EmbankmentFault::face_too_flat);
    EXPECT_EQ(fault_of({across(50.0, 30.0, 70.0), -3.0, 2.0, 0.69, 2.0}, slope),
              EmbankmentFault::face_too_flat);
    EXPECT_EQ(fault_of({across(50.0, 30.0, 70.0), 1.0, 3.0, 2.0, 2.0}, slope),
              EmbankmentFault::edge_in_ground);
    EXPECT_EQ(fault_of({across(50.0, 30.0, 120.0), 3.0, 2.0, 2.0, 2.0}, slope), EmbankmentFault::off_terrain);
    EXPECT_EQ(fault_of({across(50.0, 2.6, 70.0), 3.0, 2.0, 2.0, 2.0}, slope), EmbankmentFault::off_terrain);
    EXPECT_EQ(fault_of({across(50.0, 30.0, 70.0), 3.0, 2.0, 2.0, 1.0}, level), EmbankmentFault::no_uphill);
    EXPECT_TRUE(place({across(50.0, 30.0, 70.0), 3.0, 2.0, 1.0, 1.0}, level).placed.has_value());
    const std::vector<Eigen::Vector2d> hairpin{Eigen::Vector2d{50.0, 30.0} - slope.origin_m(),
                                               Eigen::Vector2d{50.0, 60.0} - slope.origin_m(),
                                               Eigen::Vector2d{53.0, 32.0} - slope.origin_m()};
    EXPECT_EQ(fault_of({hairpin, 3.0, 2.0, 2.0, 2.0}, slope), EmbankmentFault::bend);
}

}  // namespace
}  // namespace rockfall::embankment_test
