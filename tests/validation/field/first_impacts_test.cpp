#include "validation/engine/field/first_impacts.hpp"

#include <gtest/gtest.h>

namespace coupling::validation::first_impacts_test {
namespace {

rockfall::GroundImpact impact(rockfall::Speeds before, rockfall::Speeds after) {
    rockfall::GroundImpact made;
    made.before = before;
    made.after = after;
    return made;
}

rockfall::RockImpacts rock(rockfall::Cover cover, std::vector<rockfall::GroundImpact> impacts) {
    rockfall::RockImpacts made;
    made.cover = cover;
    made.impacts = std::move(impacts);
    return made;
}

TEST(FirstImpacts, AreTheFirstOfEachRockOverTheAskedSlope) {
    const std::vector<rockfall::RockImpacts> rocks{
        rock(rockfall::Cover::forest, {impact({3.0, 4.0}, {1.5, 1.0}), impact({8.0, 8.0}, {8.0, 8.0})}),
        rock(rockfall::Cover::forest, {impact({0.1, 5.0}, {0.0, 0.0})}), rock(rockfall::Cover::forest, {}),
        rock(rockfall::Cover::bare, {impact({1.0, 1.0}, {1.0, 1.0})})};
    const FirstImpacts first = first_impacts_of(rocks, rockfall::Cover::forest);
    ASSERT_EQ(first.normal_ratios.size(), 2U);
    EXPECT_DOUBLE_EQ(first.normal_ratios[0], 0.25);
    EXPECT_EQ(first.normal_ratios[1], 0.0) << "a rock that stops there counts";
    ASSERT_EQ(first.tangential_ratios.size(), 1U) << "hardly any speed along the face: no ratio";
    EXPECT_DOUBLE_EQ(first.tangential_ratios[0], 0.5);
    EXPECT_NEAR(first.angles_in_deg[0], 53.1301, 1e-4);
    EXPECT_DOUBLE_EQ(first.speeds_in_mps[0], 5.0);
}

TEST(FirstImpacts, AreFiguresOfTheirState) {
    Comparison comparison;
    name_first_impacts("steep", "rock, steep", comparison);
    EXPECT_EQ(comparison.figures.size(), 8U);
    EXPECT_EQ(comparison.figure("first_normal_ratio_mean:steep").unit, "-");
    Outcome outcome;
    take_first_impacts("steep", {{0.1, 0.2, 0.3}, {}, {80.0, 82.0, 84.0}, {9.0, 10.0, 11.0}}, outcome);
    EXPECT_NEAR(outcome.values.at("first_normal_ratio_mean:steep"), 0.2, 1e-12);
    EXPECT_NEAR(outcome.values.at("first_angle_in_deg:steep"), 82.0, 1e-12);
    EXPECT_EQ(outcome.values.count("first_tangential_ratio_mean:steep"), 0U) << "an empty sample has none";
    for (const auto& [name, value] : outcome.values) {
        EXPECT_FALSE(comparison.figure(name).name.empty()) << name;
    }
}

}  // namespace
}  // namespace coupling::validation::first_impacts_test
