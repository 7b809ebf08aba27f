#include "rockfall/motion/pir3d/impact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::pir3d::impact_test {
namespace {

using rockfall::testing::test_soil;

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

TEST(WidthAt, FallsStraightToTheLimitSpeedAndStays) {
    // Eqs. 6-9 with 12 % at rest and 8 % from 10 m/s on.
    const Width width{0.12, 0.08, 10.0};
    EXPECT_DOUBLE_EQ(width_at(width, 0.0, Uncertainty::by_speed), 0.12);
    EXPECT_DOUBLE_EQ(width_at(width, 5.0, Uncertainty::by_speed), 0.10);
    EXPECT_DOUBLE_EQ(width_at(width, 10.0, Uncertainty::by_speed), 0.08);
    EXPECT_DOUBLE_EQ(width_at(width, 40.0, Uncertainty::by_speed), 0.08);
    EXPECT_DOUBLE_EQ(width_at(width, 40.0, Uncertainty::constant), 0.12);
    EXPECT_DOUBLE_EQ(width_at(width, 40.0, Uncertainty::off), 0.0);
}

TEST(Deviate, HasTheMomentsOfItsDistribution) {
    constexpr int draws = 100'000;
    config::RandomStream stream{{1, 0, 0, 7}, config::Purpose::test};
    // Variances: 1/3; of a standard normal cut at 3 deviations 1 - 6 phi(3) / (2 Phi(3) - 1) = 0.97333.
    for (const auto& [spread, variance] :
         {std::pair{Spread::uniform, 1.0 / 3.0}, std::pair{Spread::normal, 0.97333}}) {
        double sum = 0.0, squares = 0.0, largest = 0.0;
        for (int i = 0; i < draws; ++i) {
            const double value = deviate(stream.uniform(), spread);
            sum += value;
            squares += value * value;
            largest = std::max(largest, std::abs(value));
        }
        EXPECT_NEAR(sum / draws, 0.0, 4.0 * std::sqrt(variance / draws));
        // The variance of a square is below 2 for either.
        EXPECT_NEAR(squares / draws, variance, 4.0 * std::sqrt(2.0 / draws));
        EXPECT_LE(largest, spread == Spread::uniform ? 1.0 : 3.0);
    }
}

TEST(Reflected, IsTheClassicalReboundWithoutChance) {
    // R_T along the face, R_N across it (Cottaz et al. 2010, 2.3.2).
    const ImpactParameters mean =
        impact_parameters(test_soil(), 8.0, {.uncertainty = Uncertainty::off}, {1, 1, 1, 1});
    const Eigen::Vector3d leaving = reflected({6.0, 0.0, -4.0}, up, mean);
    EXPECT_NEAR(leaving.x(), 0.85 * 6.0, 1e-12);
    EXPECT_NEAR(leaving.y(), 0.0, 1e-12);
    EXPECT_NEAR(leaving.z(), 0.35 * 4.0, 1e-12);
}

TEST(Reflected, TurnsAboutTheVerticalAndInItsVerticalPlane) {
    ImpactParameters parameters{{0.5, 0.8}, config::Angle::from_degrees(90.0), config::Angle{}};
    const Eigen::Vector3d aside = reflected({5.0, 0.0, -4.0}, up, parameters);
    EXPECT_NEAR((aside - Eigen::Vector3d{0.0, 4.0, 2.0}).norm(), 0.0, 1e-9);  // to the left
    parameters = {{0.5, 0.8}, config::Angle{}, config::Angle::from_degrees(20.0)};
    const Eigen::Vector3d raised = reflected({5.0, 0.0, -4.0}, up, parameters);
    EXPECT_NEAR(std::atan2(raised.z(), raised.x()) - std::atan2(2.0, 4.0),
                config::Angle::from_degrees(20.0).in_radians(), 1e-9);
    EXPECT_NEAR(raised.norm(), std::hypot(4.0, 2.0), 1e-9);
}

TEST(Reflected, IsLaidOnTheFaceWhereItWouldEnterTheGround) {
    const ImpactParameters down{{0.1, 0.9}, config::Angle{}, config::Angle::from_degrees(-20.0)};
    const double b = config::Angle::from_degrees(30.0).in_radians();
    const Eigen::Vector3d normal{std::sin(b), 0.0, std::cos(b)};
    const Eigen::Vector3d incoming = 10.0 * Eigen::Vector3d{std::cos(b + 0.1), 0.0, -std::sin(b + 0.1)};
    const Eigen::Vector3d leaving = reflected(incoming, normal, down);
    EXPECT_NEAR(leaving.dot(normal), 0.0, 1e-12);
    // Its speed is that before it was laid down.
    EXPECT_NEAR(leaving.norm(), 10.0 * std::hypot(0.9 * std::cos(0.1), 0.1 * std::sin(0.1)), 1e-9);
}

RC_GTEST_PROP(ReflectedByChance, NeverGainsEnergyAndNeverEntersTheGround, ()) {
    const auto key = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    config::RandomStream stream{{key, 0, 0, 1}, config::Purpose::test};
    const auto one = [&] { return 2.0 * stream.uniform() - 1.0; };
    const Eigen::Vector3d normal = Eigen::Vector3d{2.0 * one(), 2.0 * one(), 1.0}.normalized();
    Eigen::Vector3d velocity = 30.0 * Eigen::Vector3d{one(), one(), one()};
    if (velocity.dot(normal) > 0.0) {
        velocity = -velocity;
    }
    for (const Spread spread : {Spread::uniform, Spread::normal}) {
        const Law law{.spread = spread};
        const ImpactDraws draws =
            impact_draws({stream.uniform(), stream.uniform(), stream.uniform(), stream.uniform()}, law);
        const ImpactParameters parameters = impact_parameters(test_soil(), velocity.norm(), law, draws);
        RC_ASSERT(parameters.restitution.normal >= 0.0 && parameters.restitution.normal < 1.0);
        const Eigen::Vector3d leaving = reflected(velocity, normal, parameters);
        RC_ASSERT(leaving.dot(normal) >= -1e-9);
        RC_ASSERT(leaving.norm() <= velocity.norm() * (1.0 + 1e-12));
    }
}

TEST(ExceedsThreshold, MeasuresTheAngleToTheVerticalProjection) {
    const double b = config::Angle::from_degrees(30.0).in_radians();
    const Eigen::Vector3d normal{std::sin(b), 0.0, std::cos(b)};
    const double threshold = std::tan(config::Angle::from_degrees(5.0).in_radians());
    for (const auto& [above_deg, exceeds] :
         {std::pair{4.9, false}, std::pair{5.1, true}, std::pair{-4.9, false}, std::pair{-5.1, true}}) {
        const double angle = b - config::Angle::from_degrees(above_deg).in_radians();
        EXPECT_EQ(exceeds_threshold(7.0 * Eigen::Vector3d{std::cos(angle), 0.0, -std::sin(angle)}, normal,
                                    threshold),
                  exceeds)
            << above_deg << " degrees above the face";
    }
    EXPECT_TRUE(exceeds_threshold({0.0, 0.0, 3.0}, normal, threshold));  // straight up
}

}  // namespace
}  // namespace rockfall::pir3d::impact_test
