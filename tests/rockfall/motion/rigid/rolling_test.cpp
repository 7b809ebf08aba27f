// Polyhedra that roll over their edges and corners: where they go on and where their landings stop them.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "config/random/stream.hpp"
#include "tests/rockfall/motion/rigid/scene.hpp"

namespace rockfall::rigid {
namespace {

using namespace testing;
using config::gravity_mps2;

/// Friction that lets nothing slide.
constexpr double sticks = 20.0;

/// A block that rolls in one plane, face after face: what of it the closed forms need.
struct Roller {
    solids::Solid solid;
    double height_m;  ///< of the centre above a face
    double behind_m;  ///< from the foot of the centre back to the support that it came over
    double ahead_m;   ///< and forth to the next one
    double gyration_m2;

    [[nodiscard]] double about_m2(double support_m) const {
        return gyration_m2 + height_m * height_m + support_m * support_m;
    }
    /// Spin that brings it just over a support so far ahead, by energy.
    [[nodiscard]] double least_spin_radps(double support_m, double slope_rad) const {
        const double arm_m = std::hypot(height_m, support_m);
        const double rise_m = arm_m * (1.0 - std::cos(std::atan2(support_m, height_m) - slope_rad));
        return std::sqrt(2.0 * gravity_mps2 * rise_m / about_m2(support_m));
    }
    /// Share of the spin that a landing leaves: angular momentum about the next support is kept.
    [[nodiscard]] double kept_spin() const {
        return (gyration_m2 + height_m * height_m - behind_m * ahead_m) / about_m2(ahead_m);
    }
};

double gyration_m2(const solids::Solid& solid) {
    return solid.inertia_kgm2.x() / solid.mass_kg;
}

Roller rolling_cube() {
    const solids::Solid solid = cube(1.0);
    return {solid, 0.5, 0.5, 0.5, gyration_m2(solid)};
}

/// A regular octahedron with sides of 1 m: behind it an edge, ahead a corner of its face.
Roller rolling_octahedron() {
    std::vector<Vector3d> corners_m;
    for (int k = 0; k < 3; ++k) {
        for (const double sign : {-1.0, 1.0}) {
            corners_m.emplace_back(sign / std::numbers::sqrt2 * Vector3d::Unit(k));
        }
    }
    const solids::Solid solid = solids::solid_of(solids::convex_hull(corners_m), 2700.0);
    return {solid, 1.0 / std::sqrt(6.0), 0.5 / std::sqrt(3.0), 1.0 / std::sqrt(3.0), gyration_m2(solid)};
}

/// Turned so that a face lies on the plane and a corner or the middle of an edge of it points downhill.
Eigen::Quaterniond on_face(const solids::Solid& solid, std::size_t number, bool edge_ahead, double yaw_rad) {
    const solids::Face& face = solid.hull.faces[number];
    const Eigen::Quaterniond down = Eigen::Quaterniond::FromTwoVectors(face.normal, -Vector3d::UnitZ());
    const Vector3d a = down * solid.hull.vertices_m[face.corners[0]];
    const Vector3d b = down * solid.hull.vertices_m[face.corners[1]];
    const Vector3d ahead = edge_ahead ? Vector3d{a + b} : a;
    const double turn_rad = yaw_rad - std::atan2(ahead.y(), ahead.x());
    return Eigen::AngleAxisd{turn_rad, Vector3d::UnitZ()} * down * solid.from_given;
}

/// A block on a face that begins to turn about a support so far downhill.
Body turning_over(const Slope& slope, const Roller& roller, double slope_deg, double support_m,
                  bool over_edge, double spin_radps) {
    Body start = lying(slope, roller.solid, slope_deg, 20.0, 10.0, on_face(roller.solid, 0, over_edge, 0.0));
    const Vector3d down{std::cos(radians(slope_deg)), 0.0, -std::sin(radians(slope_deg))};
    const Vector3d normal{std::sin(radians(slope_deg)), 0.0, std::cos(radians(slope_deg))};
    const Vector3d spin = spin_radps * Vector3d::UnitY();
    start.velocity_mps = spin.cross(roller.height_m * normal - support_m * down);
    start.rotation.momentum_nms =
        roller.solid.inertia_kgm2.cwiseProduct(start.rotation.attitude.conjugate() * spin);
    return start;
}

double way_after_m(const Slope& slope, const Roller& roller, const Body& start, double time_s) {
    return way_m(slope, law_of(sticks, 0.0), roller.solid, start, time_s);
}

TEST(RollingBlocks, KeepTheSpinAboutTheNextSupportWhenTheyLand) {
    // Housner (1963, Bull. Seismol. Soc. Am. 53:403): angular momentum about the edge or corner ahead.
    const Slope flat = plane(0.0, 100.0);
    for (const auto& [roller, kept] :
         {std::pair{rolling_cube(), 1.0 / 4.0}, std::pair{rolling_octahedron(), 1.0 / 6.0}}) {
        EXPECT_NEAR(roller.kept_spin(), kept, 1e-9);
        // Lifted by 8 degrees about the support behind, which is an edge: a face with an edge uphill.
        const Eigen::Quaterniond lifted{Eigen::AngleAxisd{radians(-8.0), Vector3d::UnitY()}};
        const bool edge_ahead = roller.ahead_m == roller.behind_m;
        const Body start =
            lying(flat, roller.solid, 0.0, 20.0, 10.0, lifted * on_face(roller.solid, 0, edge_ahead, 0.0));
        BlockScratch scratch;
        const Law law = law_of(sticks, 0.0);
        Block block{flat, law, roller.solid, start, flat.terrain.locate(20.0, 10.0).value(), scratch};
        double before_radps = 0.0, after_radps = 0.0;
        for (bool inside = true; after_radps == 0.0;) {
            const Touchdown touchdown = block.step(law.step_s, inside);
            ASSERT_TRUE(inside && touchdown.touched && touchdown.lasts);
            const double spin_radps = block.body().spin_radps(roller.solid).y();
            after_radps = spin_radps < 0.7 * before_radps ? spin_radps : 0.0;
            before_radps = after_radps == 0.0 ? spin_radps : before_radps;
        }
        EXPECT_NEAR(after_radps / before_radps, kept, 0.02) << roller.ahead_m;
    }
}

TEST(RollingBlocks, PassTheSupportAheadFromTheSpinThatLiftsThem) {
    for (const double slope_deg : {20.0, 27.0, 34.0}) {
        const Slope slope = plane(slope_deg, 100.0);
        for (const Roller& roller : {rolling_cube(), rolling_octahedron()}) {
            const bool over_edge = roller.ahead_m == roller.behind_m;
            const double least_radps = roller.least_spin_radps(roller.ahead_m, radians(slope_deg));
            for (const double share : {0.97, 1.03}) {
                const Body start =
                    turning_over(slope, roller, slope_deg, roller.ahead_m, over_edge, share * least_radps);
                const double way_m = way_after_m(slope, roller, start, 3.0);
                EXPECT_EQ(way_m > roller.ahead_m, share > 1.0) << slope_deg << " " << roller.ahead_m;
            }
        }
    }
}

TEST(RollingBlocks, OctahedraAreHeldByTheCornerAheadWhereCubesRollOn) {
    // Both come over an edge with hardly any motion. The octahedron lands with a corner ahead: it keeps less
    // of its spin and has more to climb than the cube, whose edges are all alike. Nothing slides or rolls
    // with resistance.
    const Roller cubes = rolling_cube(), octahedra = rolling_octahedron();
    const auto rolls_on = [](const Roller& roller, double slope_deg) {
        const Slope slope = plane(slope_deg, 100.0);
        const double spin_radps = 1.03 * roller.least_spin_radps(roller.behind_m, radians(slope_deg));
        const double way_m = way_after_m(
            slope, roller,
            turning_over(slope, roller, slope_deg, roller.behind_m, true, std::max(0.1, spin_radps)), 8.0);
        EXPECT_GT(way_m, roller.behind_m) << slope_deg;
        return way_m > 2.0 * (roller.behind_m + roller.ahead_m);
    };
    EXPECT_TRUE(rolls_on(cubes, 34.0));
    EXPECT_FALSE(rolls_on(octahedra, 34.0));
    EXPECT_TRUE(rolls_on(octahedra, 45.0));
}

TEST(RollingBlocks, NeverStopWhereNoFaceHoldsThem) {
    // Beyond the tilt at which the weight leaves each face over its farthest corner nothing can stop a block,
    // whatever it lies on, however it is turned.
    int tried = 0;
    for (std::uint64_t trial = 0; trial < 12; ++trial) {
        config::RandomStream draws{{29, 0, 0, trial}, config::Purpose::test};
        const auto between = [&](double low, double high) { return low + (high - low) * draws.uniform(); };
        std::vector<Vector3d> points_m;
        for (int k = 0; k < 30; ++k) {
            const double x = between(-1.0, 1.0), y = between(-1.0, 1.0), z = between(-1.0, 1.0);
            points_m.emplace_back(0.6 * Vector3d{x, y, z}.normalized());
        }
        const solids::Solid solid = trial < 2 ? (trial == 0 ? rolling_cube() : rolling_octahedron()).solid
                                              : solids::solid_of(solids::convex_hull(points_m), 2700.0);
        double tips_rad = 0.0;
        for (const solids::Face& face : solid.hull.faces) {
            for (const std::uint32_t corner : face.corners) {
                const Vector3d& corner_m = solid.hull.vertices_m[corner];
                tips_rad = std::max(tips_rad, std::acos(face.offset_m / corner_m.norm()));
            }
        }
        const double slope_deg = config::Angle::from_radians(tips_rad).in_degrees() + 1.0;
        ASSERT_LT(slope_deg, 70.0);
        const Slope slope = plane(slope_deg, 600.0, 400.0);
        for (const double restitution : {0.0, 0.3}) {
            const std::size_t face =
                static_cast<std::size_t>(between(0.0, 0.999) * static_cast<double>(solid.hull.faces.size()));
            const Body start = lying(slope, solid, slope_deg, 20.0, 200.0,
                                     on_face(solid, face, false, between(0.0, 2.0 * std::numbers::pi)));
            BlockScratch scratch;
            const Law law = law_of(sticks, restitution);
            Block block{slope, law, solid, start, slope.terrain.locate(20.0, 200.0).value(), scratch};
            const Body end = moved(block, law, 6.0, true);
            EXPECT_GT((end.centre_m - start.centre_m).norm(), 5.0) << trial << " " << slope_deg;
            EXPECT_GT(end.velocity_mps.norm(), 0.5) << trial << " " << slope_deg;
            ++tried;
        }
    }
    EXPECT_EQ(tried, 24);
}

}  // namespace
}  // namespace rockfall::rigid
