#include "coupling/results/figures/colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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
    // Six steps share the range that three had: each still darkens by more than two fifths.
    for (std::size_t i = 1; i < energy_class_colours.size(); ++i) {
        EXPECT_GT(luminance(energy_class_colours[i - 1]), 1.7 * luminance(energy_class_colours[i])) << i;
    }
    for (std::size_t i = 1; i < intensity_class_colours.size(); ++i) {
        EXPECT_GT(luminance(intensity_class_colours[i - 1]), 2.0 * luminance(intensity_class_colours[i]));
    }
}

TEST(EnergyClass, ChangesAtThirtyAndAboveTheLimitsThatFollow) {
    EXPECT_EQ(energy_class(0.0), 0U);
    EXPECT_EQ(energy_class(29.9), 0U);
    EXPECT_EQ(energy_class(30.0), 1U);
    for (std::size_t i = 1; i < energy_class_limits_kj.size(); ++i) {
        EXPECT_EQ(energy_class(energy_class_limits_kj[i]), i);
        EXPECT_EQ(energy_class(energy_class_limits_kj[i] + 0.1), i + 1);
    }
    EXPECT_EQ(energy_class(1e9), 5U);
}

TEST(EnergyClass, KeepsTheLimitsOfIntensities) {
    for (const double limit_kj : intensity_limits_kj) {
        EXPECT_NE(std::find(energy_class_limits_kj.begin(), energy_class_limits_kj.end(), limit_kj),
                  energy_class_limits_kj.end());
    }
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
