#include "coupling/results/maps/raster_style.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/coupling/results/markup_checks.hpp"

namespace coupling::raster_style_test {
namespace {

std::string style_of(const char* stem, ValueRange range) {
    std::ostringstream out;
    write_style(out, raster_kind(stem), range);
    return out.str();
}

TEST(WriteStyle, PutsEnergyIntoTheThreeClasses) {
    const std::string style = style_of("E_95", {0.0F, 812.0F});
    EXPECT_NE(style.find("colorRampType=\"DISCRETE\""), std::string::npos);
    for (const char* item : {"value=\"30\" label=\"below 30 kJ\"", "value=\"300\" label=\"30 to 300 kJ\"",
                             "value=\"inf\" label=\"above 300 kJ\""}) {
        EXPECT_NE(style.find(item), std::string::npos) << item << '\n' << style;
    }
}

TEST(WriteStyle, ShowsCountsByPowersOfTenAndNoneAsSeeThrough) {
    const std::string style = style_of("Nr_passages", {1.0F, 5000.0F});
    EXPECT_NE(style.find("value=\"0\" label=\"0 rocks\" color=\"#ece7f2\" alpha=\"0\""), std::string::npos)
        << style;
    EXPECT_NE(style.find("value=\"5000\""), std::string::npos) << style;
}

TEST(WriteStyle, IsWellFormedForEveryRasterEvenAnEmptyOne) {
    for (const RasterKind& kind : raster_kinds()) {
        for (const ValueRange range : {ValueRange{0.0F, 0.0F}, ValueRange{0.0F, 73.25F}}) {
            std::ostringstream values;
            write_style(values, kind, range);
            EXPECT_EQ(text_checks::markup_fault(values.str()), "") << kind.stem;
            std::ostringstream differences;
            write_difference_style(differences, kind, range);
            EXPECT_EQ(text_checks::markup_fault(differences.str()), "") << kind.stem;
        }
    }
}

TEST(WriteDifferenceStyle, HasZeroInTheMiddle) {
    std::ostringstream out;
    write_difference_style(out, raster_kind("E_95"), {-120.0F, 40.0F});
    EXPECT_NE(out.str().find("classificationMin=\"-120\" classificationMax=\"120\""), std::string::npos);
    EXPECT_NE(out.str().find("value=\"0\" label=\"0 kJ\" color=\"#f7f7f7\""), std::string::npos) << out.str();
}

}  // namespace
}  // namespace coupling::raster_style_test
