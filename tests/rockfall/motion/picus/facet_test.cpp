#include "rockfall/motion/picus/facet.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "rockfall/motion/picus/ground_contact.hpp"

namespace rockfall::picus {
namespace {

config::Angle degrees(double value) {
    return config::Angle::from_degrees(value);
}

/// A velocity that falls onto level ground at an angle, towards +x.
Eigen::Vector3d falling_at(double impact_deg) {
    const double impact = degrees(impact_deg).in_radians();
    return {10.0 * std::cos(impact), 0.0, -10.0 * std::sin(impact)};
}

/// Mean slope of the facets that rocks meet, positive where they face the rock. Draws are the middles of
/// equal steps, so that the mean is an integral by the midpoint rule.
double mean_slope(double impact_deg, double steepest) {
    constexpr int steps = 10'000;
    const Eigen::Vector3d velocity_mps = falling_at(impact_deg);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const Eigen::Vector3d facet =
            facet_normal(velocity_mps, Eigen::Vector3d::UnitZ(), steepest, (i + 0.5) / steps);
        EXPECT_NEAR(facet.norm(), 1.0, 1e-12);
        const double slope = -facet.x() / facet.z();
        EXPECT_LE(std::abs(slope), steepest * (1.0 + 1e-9));
        EXPECT_LE(velocity_mps.dot(facet), 1e-9) << "a facet that the path cannot reach";
        sum += slope / steps;
    }
    return sum;
}

TEST(Facets, StraightFromAboveLeanNoWay) {
    const Eigen::Vector3d normal = Eigen::Vector3d{0.2, -0.3, 1.0}.normalized();
    EXPECT_EQ(facet_normal(-7.0 * normal, normal, 0.8, 0.3), normal);
    EXPECT_NEAR(mean_slope(89.99, 0.8), 0.0, 1e-4);
}

TEST(Facets, ThatFaceTheRockAreMetMoreOften) {
    // In sight is sin a + s cos a of a facet of slope s, uniform within +-S. Where none is hidden the mean of
    // s under that weight is cot(a) S^2 / 3.
    const double cotangent = 1.0 / std::tan(degrees(60.0).in_radians());
    EXPECT_NEAR(mean_slope(60.0, 0.5), cotangent * 0.25 / 3.0, 1e-6);
    // Grazing along the ground, all that lean away are hidden: the weight is s itself, its mean 2/3 S.
    EXPECT_NEAR(mean_slope(1e-6, 0.6), 0.4, 1e-4);
}

TEST(Facets, AreSteeperWhereTheGroundTakesMore) {
    const FacetLaw law;
    EXPECT_EQ(law.steepest(1.0), 0.0);
    EXPECT_NEAR(law.steepest(0.75), 0.25 * law.slope_by_losses, 1e-12);
    EXPECT_FALSE(FacetLaw{0.0}.any());
}

RC_GTEST_PROP(Facets, NeverAddEnergy, ()) {
    const auto share = [] { return *rc::gen::inRange(0, 1000) / 1000.0; };
    // From level ground to a wall, on which facets overhang.
    const Eigen::Vector3d normal = Eigen::Vector3d{0.3 + 5.0 * share(), 0.1, 1.0}.normalized();
    const double impact = degrees(*rc::gen::inRange(2, 89)).in_radians();
    const Eigen::Vector3d along = normal.unitOrthogonal();
    const double speed_mps = *rc::gen::inRange(1, 300) / 10.0;
    const Eigen::Vector3d velocity_mps = speed_mps * (std::cos(impact) * along - std::sin(impact) * normal);
    const Law law;
    const Rock rock = Rock::sphere(0.8, 2700.0);
    const ContactDraws draws{2.0 * share() - 1.0, 2.0 * share() - 1.0, 1.0, 4.0 * share() - 2.0, share()};
    const Contact after = meet_ground(velocity_mps, 3.0, normal, {0.4, share()}, 0.0, rock, law, draws);
    RC_ASSERT(kinetic_energy_j(rock, after.velocity_mps.squaredNorm(), after.spin_radps) <=
              kinetic_energy_j(rock, velocity_mps.squaredNorm(), 3.0) * (1.0 + 1e-12));
    RC_ASSERT(after.velocity_mps.allFinite());
    RC_ASSERT(after.velocity_mps.dot(normal) >= -1e-9);
}

}  // namespace
}  // namespace rockfall::picus
