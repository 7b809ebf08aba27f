#include "rockfall/motion/fall_doubts.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace rockfall::fall_doubts_test {
namespace {

MotionLaws laws_of(std::string_view name) {
    MotionLaws laws;
    for (const MotionModel model : all_models()) {
        if (description_of(model).name == name) {
            laws.model = model;
        }
    }
    return laws;
}

TEST(FallDoubts, AreAboutFastRocksOfPir3d) {
    const auto doubts = doubts_of_falls(laws_of("pir3d"), {84.4, 0.0});
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_TRUE(doubts.front().starts_with("pir3d: the fastest rock reaches 84 m/s;")) << doubts.front();
    EXPECT_TRUE(doubts_of_falls(laws_of("pir3d"), {40.0, 0.0}).empty());
    EXPECT_TRUE(doubts_of_falls(laws_of("picus"), {84.4, 0.9}).empty());
}

TEST(FallDoubts, AreAboutClassicalRocksThatSlideOffTheTerrain) {
    MotionLaws laws = laws_of("classical");
    laws.of<classical::Model>().friction = classical::Friction::from_rt;
    const auto doubts = doubts_of_falls(laws, {20.0, 0.58});
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_TRUE(doubts.front().starts_with("classical: 58 % of the rocks leave the terrain;"))
        << doubts.front();
    EXPECT_TRUE(doubts_of_falls(laws, {20.0, 0.2}).empty());
    laws.of<classical::Model>().friction = classical::Friction::ground;
    EXPECT_TRUE(doubts_of_falls(laws, {20.0, 0.58}).empty()) << "its friction stops them";
}

}  // namespace
}  // namespace rockfall::fall_doubts_test
