#include "coupling/inputs/systems/same_system.hpp"

#include <gtest/gtest.h>

#include <string>

#include "coupling/inputs/formats/system_text.hpp"

namespace coupling::plausible::same_system_test {
namespace {

std::string epsg(int code) {
    return formats::esri_text_of("EPSG:" + std::to_string(code));
}

/// As version 1 of the Open Geospatial Consortium, with the codes of EPSG.
constexpr const char* gk_west =
    "PROJCS[\"MGI / Austria GK "
    "West\",GEOGCS[\"MGI\",DATUM[\"Militar-Geographische_Institut\",SPHEROID[\"Bessel "
    "1841\",6377397.155,299.1528128,AUTHORITY[\"EPSG\",\"7004\"]],AUTHORITY[\"EPSG\",\"6312\"]],PRIMEM["
    "\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4312\"]],PROJECTION["
    "\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\","
    "10.3333333333333],PARAMETER[\"scale_factor\",1],PARAMETER[\"false_easting\",0],PARAMETER[\"false_"
    "northing\",-5000000],UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"31254\"]]";

TEST(CompareSystems, KnowsOneSystemInEachVersion) {
    EXPECT_EQ(compare_systems(epsg(31254), gk_west), Sameness::same);
    EXPECT_EQ(compare_systems(epsg(2056), epsg(2056) + "\n"), Sameness::same);
    EXPECT_EQ(compare_systems(gk_west, gk_west), Sameness::same);
}

TEST(CompareSystems, TellsSystemsApart) {
    const int codes[] = {31254, 31255, 31256, 31257, 31287, 2056, 21781,
                         25832, 25833, 2154,  3003,  3035,  4326};
    for (const int one : codes) {
        ASSERT_NE(epsg(one), "") << one;
        for (const int two : codes) {
            EXPECT_EQ(compare_systems(epsg(one), epsg(two)), one == two ? Sameness::same : Sameness::other)
                << one << " and " << two;
        }
    }
    // ED50 has the meridian and origin of ETRS89, but another figure of the earth.
    EXPECT_EQ(compare_systems(epsg(23032), epsg(25832)), Sameness::other);
}

TEST(CompareSystems, CallsDatumsNearEachOtherNearlyTheSame) {
    EXPECT_EQ(compare_systems(epsg(25832), epsg(32632)), Sameness::nearly);
}

TEST(CompareSystems, JudgesNothingThatItCannotRead) {
    EXPECT_EQ(compare_systems("", gk_west), Sameness::silent);
    EXPECT_EQ(compare_systems(gk_west, " \n"), Sameness::silent);
    EXPECT_EQ(compare_systems("GCS is unknown", gk_west), Sameness::unknown);
    EXPECT_EQ(compare_systems("PROJCS[\"Sample\"]", gk_west), Sameness::unknown);
    EXPECT_EQ(compare_systems("PROJCS[\"Sample\"]", "PROJCS[\"sample\",UNIT[\"m\",1]]"), Sameness::same);
}

TEST(NameOfSystem, HasTheCodeWhereItIsKnown) {
    EXPECT_EQ(name_of_system(gk_west), "'MGI / Austria GK West' (EPSG 31254)");
    EXPECT_EQ(name_of_system(epsg(31254)), "'MGI_Austria_GK_West' (EPSG 31254)");
    EXPECT_EQ(name_of_system("PROJCS[\"Own\"]"), "'Own'");
    EXPECT_EQ(name_of_system("no text"), "a system that cannot be read");
}

TEST(EsriTextOf, KnowsCodesAndDefinitionsAndNothingElse) {
    EXPECT_NE(epsg(31254).find("PROJCS[\"MGI_Austria_GK_West\""), std::string::npos);
    EXPECT_EQ(epsg(5555555), "");
    EXPECT_EQ(formats::esri_text_of(""), "");
    EXPECT_NE(formats::esri_text_of("+proj=tmerc +lon_0=10 +ellps=bessel +type=crs"), "");
    // Of a system with heights the plan.
    EXPECT_EQ(epsg(5972).find("VERT"), std::string::npos) << epsg(5972);
}

}  // namespace
}  // namespace coupling::plausible::same_system_test
