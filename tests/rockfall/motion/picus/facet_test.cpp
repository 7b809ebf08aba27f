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

const config::RandomStream draws_of_one{{.seed = 5, .id = 1}, config::Purpose::facet};

/// Mean and mean square of the tilt towards the path, as tangents, over many facets.
struct Tilts {
    double towards = 0.0;
    double aside = 0.0;
    double squared_aside = 0.0;
};

Tilts tilts_of(double impact_deg, double deviation_deg, int facets) {
    const double impact = degrees(impact_deg).in_radians();
    const Eigen::Vector3d velocity_mps{10.0 * std::cos(impact), 0.0, -10.0 * std::sin(impact)};
    Tilts sum;
    for (int i = 0; i < facets; ++i) {
        const Eigen::Vector3d normal =
            facet_normal(velocity_mps, Eigen::Vector3d::UnitZ(), {degrees(deviation_deg)}, draws_of_one,
                         static_cast<std::uint32_t>(i));
        EXPECT_NEAR(normal.norm(), 1.0, 3e-11) << "sines of the fall are good to 1e-11";
        EXPECT_LE(std::acos(std::min(normal.z(), 1.0)), 2.0 * degrees(deviation_deg).in_radians() + 1e-9);
        EXPECT_LT(velocity_mps.dot(normal), 0.0) << "a facet that the path cannot reach";
        sum.towards -= normal.x() / normal.z() / facets;
        sum.aside += normal.y() / normal.z() / facets;
        sum.squared_aside += normal.y() * normal.y() / (normal.z() * normal.z()) / facets;
    }
    return sum;
}

TEST(Facets, StraightFromAboveLeanNoWay) {
    constexpr int facets = 20'000;
    const Tilts tilts = tilts_of(90.0, 10.0, facets);
    // Of the tilt's square half lies aside; its variance, cut at two deviations, is 0.774 of the whole one.
    const double spread = std::sqrt(0.5 * 0.774) * std::tan(degrees(10.0).in_radians());
    EXPECT_NEAR(tilts.towards, 0.0, 4.0 * spread / std::sqrt(facets));
    EXPECT_NEAR(tilts.aside, 0.0, 4.0 * spread / std::sqrt(facets));
    EXPECT_NEAR(std::sqrt(tilts.squared_aside), spread, 0.03 * spread);
}

TEST(Facets, ThatFaceTheRockAreHitMoreOften) {
    // With s the tangent of the tilt towards the path, the share of area in sight is sin(a) + cos(a) s: where
    // no facet is hidden, its mean under that weight is cot(a) <s^2>.
    constexpr int facets = 20'000;
    const Tilts steep = tilts_of(60.0, 5.0, facets);
    const double variance = 0.5 * 0.774 * std::pow(std::tan(degrees(5.0).in_radians()), 2);
    const double expected = variance / std::tan(degrees(60.0).in_radians());
    EXPECT_NEAR(steep.towards, expected, 4.0 * std::sqrt(variance / facets));
    EXPECT_GT(tilts_of(15.0, 15.0, 2000).towards, tilts_of(60.0, 15.0, 2000).towards);
}

RC_GTEST_PROP(Facets, NeverAddEnergy, (std::uint32_t contact)) {
    const Eigen::Vector3d normal = Eigen::Vector3d{0.3, 0.1, 1.0}.normalized();
    const double impact = degrees(*rc::gen::inRange(2, 89)).in_radians();
    const Eigen::Vector3d along = normal.unitOrthogonal();
    const double speed_mps = *rc::gen::inRange(1, 300) / 10.0;
    const Eigen::Vector3d velocity_mps = speed_mps * (std::cos(impact) * along - std::sin(impact) * normal);
    Law law;
    law.facets.deviation = degrees(15.0);
    const Rock rock = Rock::sphere(0.8, 2700.0);
    const Eigen::Vector3d face =
        facet_normal(velocity_mps, normal, law.facets, draws_of_one, contact % 100'000);
    const Contact after = on_ground(
        meet_ground(velocity_mps, 3.0, face, {0.4, 0.9}, 0.0, rock, law, {0.3, -0.4, 1.0, 0.7}), normal);
    RC_ASSERT(kinetic_energy_j(rock, after.velocity_mps.squaredNorm(), after.spin_radps) <=
              kinetic_energy_j(rock, velocity_mps.squaredNorm(), 3.0) * (1.0 + 1e-12));
    RC_ASSERT(after.velocity_mps.dot(normal) >= -1e-9);
}

}  // namespace
}  // namespace rockfall::picus
