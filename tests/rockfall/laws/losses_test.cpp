#include "rockfall/laws/losses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/release/elongation.hpp"
#include "rockfall/solids/block_shape.hpp"
#include "rockfall/solids/shapes.hpp"

namespace rockfall {
namespace {

Rock rock_of(double elongation, double own_losses = 0.0) {
    Rock rock = Rock::sphere(1.0, 2700.0);
    rock.elongation = elongation;
    rock.own_losses = own_losses;
    return rock;
}

TEST(Losses, OfTheUsualRockAreThoseOfTheGround) {
    EXPECT_EQ(loss_factor({}, Rock::sphere(1.0, 2700.0)), 1.0);
    const Restitution ground{0.3, 0.75};
    EXPECT_EQ(with_losses(ground, 1.0).tangential, ground.tangential);
    EXPECT_EQ(with_losses(ground, 1.0).normal, ground.normal);
}

TEST(Losses, GrowWithTheElongationAndWhatIsTheRocksOwn) {
    const LossLaw law{0.5, 0.2};
    EXPECT_NEAR(loss_factor(law, rock_of(4.0 * usual_elongation)), 2.0, 1e-9);
    EXPECT_NEAR(loss_factor(law, rock_of(usual_elongation, 1.0)), std::exp(0.2), 1e-9);
    EXPECT_NEAR(loss_factor(law, rock_of(0.25 * usual_elongation, -1.0)), 0.5 * std::exp(-0.2), 1e-9);
    EXPECT_EQ(loss_factor({0.0, 0.0}, rock_of(5.0, 2.0)), 1.0);
}

TEST(Losses, NeverMakeARestitutionThatNoContactHas) {
    EXPECT_NEAR(with_losses({0.3, 0.8}, 1.5).tangential, 0.7, 1e-12);
    EXPECT_EQ(with_losses({0.3, 0.2}, 4.0).tangential, 0.0);
    EXPECT_EQ(with_losses({0.3, 0.95}, 0.0).tangential, largest_restitution);
}

TEST(Elongation, OfRocksOfUnknownShapeScattersAboutItsMedian) {
    const ElongationLaw law{2.0, 0.25};
    EXPECT_NEAR(law.at(0.3, 0.0), 2.0, 1e-12);
    EXPECT_NEAR(law.at(0.9, 1.0), 2.0 * std::exp(0.25), 1e-9);
    EXPECT_EQ((ElongationLaw{1.1, 0.5}.at(0.5, -2.0)), 1.0) << "no rock is shorter than it is thick";
}

TEST(Elongation, OfGivenShapesIsThatOfTheirSides) {
    const auto box = [](double a, double b, double c, double share) {
        return BlockShape{"box", solids::box({a, b, c}), false, share};
    };
    const ElongationLaw one{ShapeLaw{{box(0.4, 1.0, 0.5, 1.0)}, 0.0, std::nullopt}};
    EXPECT_NEAR(one.at(0.7, 2.0), 2.5, 1e-9);
    const ElongationLaw two{
        ShapeLaw{{box(3.0, 1.0, 1.0, 1.0), {"sphere", std::nullopt, false, 3.0}}, 0.0, std::nullopt}};
    EXPECT_NEAR(two.at(0.24, 0.0), 3.0, 1e-9);
    EXPECT_EQ(two.at(0.26, 0.0), 1.0);
    const ElongationLaw scattered{ShapeLaw{{box(2.0, 1.0, 1.0, 1.0)}, 0.3, std::nullopt}};
    EXPECT_NEAR(scattered.at(0.0, 1.0), 2.0 * std::exp(0.3 * std::sqrt(2.0 / 3.0)), 1e-9);
}

}  // namespace
}  // namespace rockfall
