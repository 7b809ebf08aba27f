#include "coupling/inputs/formats/system_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/inputs/formats/height_unit.hpp"
#include "coupling/inputs/formats/system_text.hpp"

namespace coupling::formats::system_scale_test {
namespace {

/// How much lengths differ at most from those on the ground, of a system by its code [-].
double off_by(const char* code, double x_m, double y_m) {
    const auto scale = system_scale(esri_text_of(code), x_m, y_m);
    return scale ? std::max(std::abs(scale->longest - 1.0), std::abs(scale->shortest - 1.0)) : -1.0;
}

TEST(SystemScale, IsThatOfItsProjection) {
    // Web Mercator stretches by 1 / cos(latitude), here 47.05 degrees north.
    EXPECT_NEAR(off_by("EPSG:3857", 1'300'000.0, 5'950'000.0), 1.0 / std::cos(47.0485 * M_PI / 180.0) - 1.0,
                5e-3);
    // On its central meridian UTM has 0.9996 by definition.
    EXPECT_NEAR(off_by("EPSG:32632", 500'000.0, 5'200'000.0), 4e-4, 1e-6);
}

TEST(SystemScale, OfNationalSystemsIsNearlyOneInTheirCountry) {
    EXPECT_LT(off_by("EPSG:31287", 177'500.0, 377'000.0), 1e-3);
    EXPECT_LT(off_by("EPSG:31254", 184'000.0, 190'000.0), 1e-3);
    EXPECT_LT(off_by("EPSG:2056", 2'700'000.0, 1'200'000.0), 1e-3);
    EXPECT_LT(off_by("EPSG:2154", 974'400.0, 6'581'650.0), 1.5e-3);
    // Grads from the meridian of Paris, Chamonix.
    EXPECT_LT(off_by("EPSG:27572", 952'000.0, 2'109'000.0), 1.5e-3);
    EXPECT_GE(off_by("EPSG:27572", 952'000.0, 2'109'000.0), 0.0);
    EXPECT_LT(off_by("EPSG:3035", 4'400'000.0, 2'700'000.0), 1.5e-3);
    // UTM 450 km from the middle of its zone is still one of two per mille.
    EXPECT_LT(off_by("EPSG:32632", 950'000.0, 5'200'000.0), 3e-3);
    // Europe's conformal system shrinks the Alps by 3 %.
    EXPECT_GT(off_by("EPSG:3034", 4'100'000.0, 2'300'000.0), 0.03);
}

TEST(SystemScale, PassesOverASystemOfHeightsBehindIt) {
    const std::string text = esri_text_of("EPSG:3857") + ",VERTCS[\"EVRF2007\",UNIT[\"Meter\",1.0]]";
    EXPECT_TRUE(system_scale(text, 1'300'000.0, 5'950'000.0));
}

TEST(SystemScale, IsSilentAboutOtherTexts) {
    EXPECT_FALSE(system_scale("", 0.0, 0.0));
    EXPECT_FALSE(system_scale("PROJCS[\"Sample\"]", 0.0, 0.0));
    EXPECT_FALSE(system_scale("GEOGCS[\"WGS 84\"]", 11.0, 47.0));
    EXPECT_FALSE(system_scale("+proj=merc +type=crs", 0.0, 0.0));
    EXPECT_FALSE(system_scale("EPSG:3857", 0.0, 0.0)) << "well-known text alone";
}

TEST(HeightUnits, AreThoseOfTheTablesOfEpsg) {
    ASSERT_TRUE(height_unit_of_system(6360));
    EXPECT_NEAR(height_unit_of_system(6360)->metres, 1200.0 / 3937.0, 1e-9);
    ASSERT_TRUE(height_unit_of_system(5621));
    EXPECT_TRUE(height_unit_of_system(5621)->is_metres_upwards()) << "EVRF2007 height";
    ASSERT_TRUE(height_unit_of_system(5336));
    EXPECT_TRUE(height_unit_of_system(5336)->is_depth) << "Black Sea depth";
    EXPECT_FALSE(height_unit_of_system(31287)) << "a system of plan coordinates";
    ASSERT_TRUE(height_unit_of_unit(9003));
    EXPECT_NEAR(height_unit_of_unit(9003)->metres, 1200.0 / 3937.0, 1e-9);
    EXPECT_FALSE(height_unit_of_unit(9102)) << "degrees";
    EXPECT_NEAR(height_unit_in_words("US survey foot")->metres, 0.3048006, 1e-7);
    EXPECT_TRUE(height_unit_in_words("Metre")->is_metres_upwards());
    EXPECT_FALSE(height_unit_in_words("furlong"));
}

}  // namespace
}  // namespace coupling::formats::system_scale_test
