#include "coupling/results/colours.hpp"

#include <gtest/gtest.h>

namespace coupling::colours_test {
namespace {

TEST(Palettes, GrowDarkerFromEndToEndSoThatBlackAndWhiteKeepsTheirOrder) {
    for (const Palette palette :
         {Palette::reach, Palette::passages, Palette::impacts, Palette::deposits, Palette::height}) {
        const auto colours = colours_of(palette);
        for (std::size_t i = 1; i < colours.size(); ++i) {
            EXPECT_LT(luminance(colours[i]), luminance(colours[i - 1]))
                << static_cast<int>(palette) << ' ' << i;
        }
    }
}

TEST(EnergyClassColours, GrowDarkerWithEnergy) {
    EXPECT_GT(luminance(energy_class_colours[0]), 2.0 * luminance(energy_class_colours[1]));
    EXPECT_GT(luminance(energy_class_colours[1]), 2.0 * luminance(energy_class_colours[2]));
}

TEST(EnergyClass, ChangesAtThirtyAndAboveThreeHundredKilojoules) {
    EXPECT_EQ(energy_class(29.9), 0U);
    EXPECT_EQ(energy_class(30.0), 1U);
    EXPECT_EQ(energy_class(300.0), 1U);
    EXPECT_EQ(energy_class(300.1), 2U);
}

TEST(ColourAt, MeetsTheEndsAndTheMiddleOfAPalette) {
    const auto colours = colours_of(Palette::difference);
    EXPECT_EQ(colour_at(Palette::difference, -1.0), colours.front());
    EXPECT_EQ(colour_at(Palette::difference, 0.5), colours[5]);
    EXPECT_EQ(colour_at(Palette::difference, 1.0), colours.back());
}

TEST(ToHex, IsWhatHtmlReads) {
    EXPECT_EQ(to_hex({0x0a, 0xff, 0x00}), "#0aff00");
}

}  // namespace
}  // namespace coupling::colours_test
