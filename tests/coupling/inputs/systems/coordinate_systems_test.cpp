#include "coupling/inputs/systems/coordinate_systems.hpp"

#include <gtest/gtest.h>

#include <string>

namespace coupling::plausible::coordinate_systems_test {
namespace {

// The slope of the example project, in MGI / Austria Lambert.
constexpr Extent tyrol{177'198.0, 178'298.0, 376'898.0, 378'102.0};

/// As ESRI writes it.
std::string esri_text(const std::string& name, double easting, double northing, double meridian,
                      const std::string& unit = "UNIT[\"Meter\",1.0]") {
    return "PROJCS[\"" + name + "\",GEOGCS[\"GCS\",UNIT[\"Degree\",0.0174532925199433]],PROJECTION[\"P\"]," +
           "PARAMETER[\"False_Easting\"," + std::to_string(easting) + "],PARAMETER[\"False_Northing\"," +
           std::to_string(northing) + "],PARAMETER[\"Central_Meridian\"," + std::to_string(meridian) + "]," +
           unit + "]";
}

TEST(ReadProjection, TakesTheParametersOfVersionOneAndTwo) {
    const auto one = read_projection(esri_text("MGI_Austria_Lambert", 4e5, 4e5, 13.3333333));
    ASSERT_TRUE(one);
    EXPECT_EQ(one->name, "MGI_Austria_Lambert");
    EXPECT_FALSE(one->is_geographic);
    EXPECT_EQ(one->false_easting, 4e5);
    EXPECT_EQ(one->metres_per_unit, 1.0);
    const auto two = read_projection(
        "PROJCRS[\"ETRS89 / UTM zone 32N\",BASEGEOGCRS[\"ETRS89\",DATUM[\"E\",ELLIPSOID[\"GRS "
        "1980\",6378137,298.257222101,LENGTHUNIT[\"metre\",1]]]],CONVERSION[\"UTM zone 32N\","
        "METHOD[\"Transverse Mercator\",ID[\"EPSG\",9807]],PARAMETER[\"Longitude of natural "
        "origin\",9,ANGLEUNIT[\"degree\",0.0174532925199433]],PARAMETER[\"False "
        "easting\",500000,LENGTHUNIT[\"metre\",1]],PARAMETER[\"False northing\",0,LENGTHUNIT[\"metre\",1]]],"
        "CS[Cartesian,2],AXIS[\"(E)\",east],AXIS[\"(N)\",north],LENGTHUNIT[\"metre\",1]]");
    ASSERT_TRUE(two);
    EXPECT_EQ(two->central_meridian_deg, 9.0);
    EXPECT_EQ(two->false_easting, 5e5);
    EXPECT_EQ(two->false_northing, 0.0);
    EXPECT_EQ(two->metres_per_unit, 1.0);
}

TEST(ReadProjection, KnowsNothingOfOtherTexts) {
    EXPECT_FALSE(read_projection(""));
    EXPECT_FALSE(read_projection("Projection    UTM\nZone 32"));
    EXPECT_FALSE(read_projection("LOCAL_CS[\"quarry\"]"));
    EXPECT_FALSE(read_projection("PROJCS[[[\"\"\"((("));
}

TEST(KnownSystems, ContainTheirOwnOriginOrLieBesideIt) {
    for (const KnownSystem& system : known_systems()) {
        EXPECT_LT(system.area.west_m, system.area.east_m) << system.name;
        EXPECT_LT(system.area.south_m, system.area.north_m) << system.name;
        EXPECT_GE(system.false_easting_m, system.area.west_m - 200e3) << system.name;
        EXPECT_LE(system.false_easting_m, system.area.east_m + 200e3) << system.name;
    }
}

TEST(ContradictionOf, AcceptsTheSystemThatTheCoordinatesAreIn) {
    EXPECT_FALSE(contradiction_of(esri_text("MGI_Austria_Lambert", 4e5, 4e5, 13.3333333), tyrol, "dem.prj"));
    const Extent chablais{974'326.0, 974'408.0, 6'581'619.0, 6'581'702.0};
    EXPECT_FALSE(contradiction_of(esri_text("RGF_1993_Lambert_93", 7e5, 6.6e6, 3.0), chablais, "dem.prj"));
    // East Tyrol lies outside the strip, but its maps come in it too.
    const Extent lienz{184'000.0, 186'000.0, 189'000.0, 191'000.0};
    EXPECT_FALSE(contradiction_of(esri_text("MGI_Austria_GK_West", 0.0, -5e6, 10.3333333), lienz, "dem.prj"));
}

TEST(ContradictionOf, NamesBothAndWhatWouldFit) {
    for (const auto& [name, easting, northing, meridian] :
         {std::tuple{"WGS_1984_UTM_Zone_32N", 5e5, 0.0, 9.0},
          {"ETRS_1989_UTM_Zone_33N", 5e5, 0.0, 15.0},
          {"CH1903_LV03", 6e5, 2e5, 7.43958333},
          {"CH1903+_LV95", 2.6e6, 1.2e6, 7.43958333},
          {"MGI_Austria_GK_West", 0.0, -5e6, 10.3333333},
          {"MGI_Austria_GK_M31", 4.5e5, -5e6, 13.3333333},
          {"MGI_M28", 1.5e5, 0.0, 10.3333333},
          {"DHDN_3_Degree_Gauss_Zone_4", 4.5e6, 0.0, 12.0},
          {"RGF_1993_Lambert_93", 7e5, 6.6e6, 3.0}}) {
        const auto wrong = contradiction_of(esri_text(name, easting, northing, meridian), tyrol, "dem.prj");
        ASSERT_TRUE(wrong) << name;
        EXPECT_NE(wrong->found.find(name), std::string::npos) << wrong->found;
        EXPECT_NE(wrong->found.find("376 898 to 378 102 north"), std::string::npos) << wrong->found;
        EXPECT_NE(wrong->expected.find(" north"), std::string::npos) << wrong->expected;
        EXPECT_EQ(
            wrong->advice,
            "replace dem.prj: the coordinates would fit MGI / Austria Lambert (EPSG 31287), or delete it: "
            "the results then name no projection")
            << name;
    }
}

TEST(ContradictionOf, RefusesDegreesAndFeet) {
    const auto degrees = contradiction_of("GEOGCS[\"WGS 84\",UNIT[\"degree\",0.01745]]", tyrol, "dem.prj");
    ASSERT_TRUE(degrees);
    EXPECT_EQ(degrees->expected, "degrees with this geographic system");
    const auto feet = contradiction_of(
        esri_text("State Plane", 5e5, 0.0, -120.5, "UNIT[\"Foot_US\",0.304800609601219]"), tyrol, "dem.prj");
    ASSERT_TRUE(feet);
    EXPECT_NE(feet->found.find("0.304800609601219 m"), std::string::npos) << feet->found;
}

TEST(ContradictionOf, SaysNothingOfSystemsThatItDoesNotKnow) {
    EXPECT_FALSE(contradiction_of(esri_text("Local", 123.0, 456.0, 7.0), tyrol, "dem.prj"));
    EXPECT_FALSE(contradiction_of("PROJCS[\"Sample\"]", {0.0, 100.0, 0.0, 100.0}, "dem.prj"));
    // The Andes lie in UTM with northings of a few hundred kilometres.
    EXPECT_FALSE(contradiction_of(esri_text("WGS_1984_UTM_Zone_18N", 5e5, 0.0, -75.0), tyrol, "dem.prj"));
}

TEST(ContradictionOf, RefusesDegreesThatAreDegrees) {
    const auto wrong = contradiction_of("GEOGCS[\"WGS 84\"]", {11.0, 11.1, 47.0, 47.1}, "dem.tif");
    ASSERT_TRUE(wrong);
    EXPECT_EQ(wrong->expected, "metres of a projected system, not degrees");
    EXPECT_NE(wrong->advice.find("gdalwarp -t_srs EPSG:32632 -r bilinear -dstnodata -9999 dem.tif "),
              std::string::npos)
        << wrong->advice;
}

// Each place on earth between the polar circles of UTM, by the definition of its zones.
TEST(ContradictionOf, NamesTheZoneOfUtmThatDegreesLieIn) {
    for (int zone = 1; zone <= 60; ++zone) {
        for (const double latitude_deg : {-60.0, -0.5, 0.5, 46.0, 80.0}) {
            const double west_deg = -180.0 + 6.0 * (zone - 1);
            const auto wrong = contradiction_of(
                "GEOGCS[\"WGS 84\"]", {west_deg + 2.0, west_deg + 2.1, latitude_deg, latitude_deg + 0.1},
                "dem.tif");
            ASSERT_TRUE(wrong);
            const int code = (latitude_deg < 0.0 ? 32700 : 32600) + zone;
            EXPECT_NE(wrong->advice.find("EPSG:" + std::to_string(code) + " "), std::string::npos)
                << zone << ": " << wrong->advice;
        }
    }
}

TEST(ContradictionOf, SaysHowToTakeASystemOffTheHeightsThemselves) {
    const auto wrong =
        contradiction_of(esri_text("CH1903_LV03", 6e5, 2e5, 7.43958333), {0.0, 300.0, 0.0, 300.0}, "dem.tif");
    ASSERT_TRUE(wrong);
    EXPECT_NE(wrong->advice.find("gdal_translate -of AAIGrid dem.tif local.asc"), std::string::npos)
        << wrong->advice;
    EXPECT_EQ(wrong->advice.find("delete"), std::string::npos) << wrong->advice;
}

TEST(HeightUnitIn, ReadsTheVerticalPartOfEachVersion) {
    const std::string plan = esri_text("MGI_Austria_Lambert", 4e5, 4e5, 13.3333333);
    EXPECT_FALSE(height_unit_in(plan));
    const std::string feet = "UNIT[\"Foot_US\",0.304800609601219]";
    const auto esri = height_unit_in(
        plan + ",VERTCS[\"NAVD_1988\",VDATUM[\"N\"],PARAMETER[\"Direction\",1.0]," + feet + "]");
    ASSERT_TRUE(esri);
    EXPECT_EQ(esri->name, "NAVD_1988");
    EXPECT_DOUBLE_EQ(esri->metres, 0.304800609601219);
    const auto one =
        height_unit_in("COMPD_CS[\"both\"," + plan + ",VERT_CS[\"NAVD88\",VERT_DATUM[\"N\",2005]," + feet +
                       ",AXIS[\"Up\",UP]]]");
    ASSERT_TRUE(one);
    EXPECT_FALSE(one->is_metres_upwards());
    const auto two = height_unit_in("COMPOUNDCRS[\"both\"," + plan +
                                    ",VERTCRS[\"EVRF\",VDATUM[\"E\"],CS[vertical,1],AXIS[\"height\",up],"
                                    "LENGTHUNIT[\"metre\",1]]]");
    ASSERT_TRUE(two);
    EXPECT_TRUE(two->is_metres_upwards());
    const auto depth =
        height_unit_in("VERTCRS[\"depth\",CS[vertical,1],AXIS[\"depth\",down],LENGTHUNIT[\"m\",1]]");
    ASSERT_TRUE(depth);
    EXPECT_TRUE(depth->is_depth);
    EXPECT_TRUE(contradiction_of_heights(*depth));
    EXPECT_NE(contradiction_of_heights(*one)->found.find("units of 0.304801 m"), std::string::npos);
    EXPECT_FALSE(contradiction_of_heights(*two));
}

}  // namespace
}  // namespace coupling::plausible::coordinate_systems_test
