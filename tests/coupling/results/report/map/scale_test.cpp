#include "coupling/results/report/map/scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <string>

#include "coupling/results/tables/text_layout.hpp"
#include "tests/coupling/results/markup_checks.hpp"

namespace coupling::report::scale_test {
namespace {

TEST(ColourScale, ShowsNothingWhereThereIsNoValue) {
    EXPECT_EQ(ColourScale::energy_classes().index_of(std::nanf("")), 0);
    EXPECT_EQ(ColourScale::linear(Palette::height, 10.0, "m").index_of(std::nanf("")), 0);
}

TEST(ColourScale, OfEnergyHasSixColours) {
    const ColourScale scale = ColourScale::energy_classes();
    EXPECT_EQ(scale.palette().size(), 7U);
    EXPECT_EQ(scale.index_of(10.0F), 1);
    EXPECT_EQ(scale.index_of(30.0F), 2);
    EXPECT_EQ(scale.index_of(1000.0F), 4);
    EXPECT_EQ(scale.index_of(5000.0F), 6);
}

TEST(ColourScale, ByPowersOfTenPutsTheGeometricMeanInTheMiddle) {
    const ColourScale scale = ColourScale::logarithmic(Palette::passages, 1.0, 10000.0, "rocks");
    const int middle = (scale.index_of(1.0F) + scale.index_of(10000.0F)) / 2;
    EXPECT_NEAR(scale.index_of(100.0F), middle, 1);
    EXPECT_EQ(scale.index_of(0.5F), scale.index_of(1.0F));
}

TEST(ColourScale, OfADifferenceIsPaleAtZero) {
    const ColourScale scale = ColourScale::difference(80.0, "kJ");
    EXPECT_GT(luminance(scale.palette()[scale.index_of(0.0F)]), 0.85);
    EXPECT_GT(scale.palette()[scale.index_of(-90.0F)].blue, 80) << "less is blue";
    EXPECT_GT(scale.palette()[scale.index_of(90.0F)].red, 80) << "more is red";
}

TEST(Legend, NamesUnitAndRoundNumbers) {
    const std::string legend = ColourScale::linear(Palette::height, 73.0, "m").legend("ramp1");
    EXPECT_NE(legend.find(">m</text>"), std::string::npos) << legend;
    EXPECT_NE(legend.find(">100</text>"), std::string::npos) << legend;
    EXPECT_NE(ColourScale::energy_classes().legend("ramp2").find("30 to 100 kJ"), std::string::npos);
}

TEST(Legend, KeepsNamesOfClassesApart) {
    // Type of 13 units is about 7 units a letter wide; a row is 400 wide.
    const std::regex entry{R"(translate\((\d+) (\d+)\).*?<text[^>]*>([^<]*)<)"};
    for (const char* longest :
         {"low", "residual", "Restgefährdung", "a very long name of one class of four"}) {
        const std::string legend =
            ColourScale::classes(
                {{1.0, longest, {}}, {2.0, "low", {}}, {3.0, "moderate", {}}, {4.0, "high", {}}})
                .legend("levels");
        std::map<int, double> end_of_row;
        std::size_t entries = 0;
        for (std::sregex_iterator found{legend.begin(), legend.end(), entry}; found != std::sregex_iterator{};
             ++found, ++entries) {
            double& end = end_of_row[std::stoi((*found)[2])];
            const double x = std::stod((*found)[1]);
            EXPECT_GE(x, end) << longest;
            end = x + 31.0 + 7.0 * static_cast<double>(width_of((*found)[3]));
            EXPECT_LE(end, 400.0) << longest;
        }
        EXPECT_EQ(entries, 4U);
    }
}

TEST(Legend, IsWellFormed) {
    for (const ColourScale& scale :
         {ColourScale::energy_classes(), ColourScale::linear(Palette::height, 0.0, "m"),
          ColourScale::logarithmic(Palette::reach, 0.1, 3.0, "%"), ColourScale::difference(0.0, "kJ")}) {
        EXPECT_EQ(text_checks::markup_fault(scale.legend("ramp")), "");
    }
}

}  // namespace
}  // namespace coupling::report::scale_test
