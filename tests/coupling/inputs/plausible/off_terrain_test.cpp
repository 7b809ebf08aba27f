#include "coupling/inputs/plausible/off_terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::plausible::off_terrain_test {
namespace {

// The slope of the example project, in MGI / Austria Lambert.
constexpr Extent tyrolean_slope{177'198.0, 178'298.0, 376'898.0, 378'102.0};

/// Places on the slope, their coordinates changed.
template <class Change>
std::vector<config::Point2> changed_places(const Extent& terrain, Change change) {
    std::vector<config::Point2> places;
    for (const double share : {0.1, 0.4, 0.7}) {
        places.push_back(
            change(config::Point2{terrain.west_m + share * (terrain.east_m - terrain.west_m),
                                  terrain.south_m + share * (terrain.north_m - terrain.south_m)}));
    }
    return places;
}

template <class Change>
std::string reason_of(const Extent& terrain, Change change) {
    return cause_off_terrain(terrain, changed_places(terrain, change), "exchange them").reason;
}

TEST(CauseOffTerrain, FindsSwappedAxes) {
    const auto swapped = [](config::Point2 p) { return config::Point2{p.y_m, p.x_m}; };
    const OffCause cause =
        cause_off_terrain(tyrolean_slope, changed_places(tyrolean_slope, swapped), "exchange them");
    EXPECT_EQ(cause.reason, "x and y look swapped");
    EXPECT_EQ(cause.advice, "exchange them");
}

TEST(CauseOffTerrain, FindsDegreesAndOtherUnits) {
    EXPECT_EQ(reason_of(tyrolean_slope,
                        [](config::Point2) {
                            return config::Point2{10.4, 47.2};
                        }),
              "they look like degrees of longitude and latitude");
    EXPECT_EQ(reason_of(tyrolean_slope,
                        [](config::Point2 p) {
                            return config::Point2{1e3 * p.x_m, 1e3 * p.y_m};
                        }),
              "they look like millimetres");
}

TEST(CauseOffTerrain, FindsTheShiftsBetweenNationalSystems) {
    const Extent swiss{2'600'000.0, 2'601'000.0, 1'200'000.0, 1'201'000.0};
    EXPECT_EQ(reason_of(swiss,
                        [](config::Point2 p) {
                            return config::Point2{p.x_m - 2e6, p.y_m - 1e6};
                        }),
              "they look like Swiss LV03 while the terrain is in LV95");
    const Extent old_swiss{600'000.0, 601'000.0, 200'000.0, 201'000.0};
    EXPECT_EQ(reason_of(old_swiss,
                        [](config::Point2 p) {
                            return config::Point2{p.x_m + 2e6, p.y_m + 1e6};
                        }),
              "they look like Swiss LV95 while the terrain is in LV03");
    EXPECT_EQ(reason_of(tyrolean_slope,
                        [](config::Point2 p) {
                            return config::Point2{p.x_m + 2e6, p.y_m + 1e6};
                        }),
              "their easting has 2 000 000 m and their northing 1 000 000 m more (Swiss LV03, LV95)");
    const Extent austrian{79'000.0, 80'000.0, 237'000.0, 238'000.0};
    EXPECT_NE(reason_of(austrian,
                        [](config::Point2 p) {
                            return config::Point2{p.x_m, p.y_m + 5e6};
                        })
                  .find("5 000 000 m more"),
              std::string::npos);
    EXPECT_NE(reason_of(austrian,
                        [](config::Point2 p) {
                            return config::Point2{p.x_m + 150e3, p.y_m};
                        })
                  .find("M28"),
              std::string::npos);
    const Extent bavarian{4'430'000.0, 4'431'000.0, 5'270'000.0, 5'271'000.0};
    EXPECT_EQ(reason_of(bavarian,
                        [](config::Point2 p) {
                            return config::Point2{p.x_m - 4e6, p.y_m};
                        }),
              "their easting lacks the number of the zone, 4, before it");
}

TEST(CauseOffTerrain, NamesTheSystemsOfBothWhereItKnowsThem) {
    const std::string reason = reason_of(tyrolean_slope, [](config::Point2) {
        return config::Point2{2'700'000.0, 1'150'000.0};
    });
    EXPECT_EQ(
        reason,
        "another coordinate system: they would fit CH1903+ / LV95 (EPSG 2056), the terrain MGI / Austria "
        "Lambert (EPSG 31287)");
}

TEST(CauseOffTerrain, SaysThatAListMayReachBeyondTheTerrain) {
    const std::vector<config::Point2> around{
        {177'000.0, 376'000.0}, {177'500.0, 377'000.0}, {180'000.0, 380'000.0}};
    EXPECT_EQ(cause_off_terrain(tyrolean_slope, around, "").reason, "they reach beyond the terrain");
}

TEST(CauseOffTerrain, SaysHowFarBeyondTheEdgeNearThingsLie) {
    const std::vector<config::Point2> house{{177'150.0, 377'780.0}, {177'166.0, 377'800.0}};
    const OffCause cause = cause_off_terrain(tyrolean_slope, house, "");
    EXPECT_EQ(cause.reason, "they lie 32 m beyond its edge");
    EXPECT_EQ(cause.advice, "take a larger terrain, or delete them from the file");
    const std::vector<config::Point2> far_away{{170'000.0, 377'780.0}};
    EXPECT_EQ(cause_off_terrain(tyrolean_slope, far_away, "").reason,
              "perhaps another coordinate system or another place");
}

/// What terrain.extent_m cuts off was stated by the user: notes, however much it is.
TEST(JudgeOffTerrain, NotesWhatTheStatedExtentLeavesOut) {
    const SampleProject project;
    std::string trees = "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    for (int i = 0; i < 12; ++i) {
        trees += std::to_string(i) + "," + std::to_string(1035 + 7 * (i % 9)) + "," +
                 std::to_string(2022 + 4 * i) + ",PIAB,30,22\n";
    }
    project.write("trees.csv", trees);
    project.write("targets.csv", "target_id,name,wkt\nroad,road,\"LINESTRING (1030 2050, 1110 2050)\"\n");
    const Opened cut = open(project, {"terrain.extent_m=1000, 2000, 1060, 2100"});
    ASSERT_TRUE(cut.site) << cut.errors;
    EXPECT_LT(cut.site->trees.size(), 8U);
    std::string notes;
    for (const std::string& sentence : cut.warnings) {
        notes += sentence + "\n";
        EXPECT_EQ(sentence.find("off the terrain"), std::string::npos) << sentence;
    }
    EXPECT_NE(notes.find("trees.csv: "), std::string::npos);
    EXPECT_NE(notes.find(" of 12 trees outside of terrain.extent_m, left out"), std::string::npos) << notes;
    EXPECT_NE(notes.find("of its length outside of terrain.extent_m: no rock is counted there"),
              std::string::npos)
        << notes;
    // Trees that are elsewhere in the part that was stated are still said.
    project.write("trees.csv", trees + "99,1030,2900,PIAB,30,22\n");
    const Opened whole = open(project);
    ASSERT_TRUE(whole.site) << whole.errors;
    EXPECT_NE(std::find_if(whole.warnings.begin(), whole.warnings.end(),
                           [](const std::string& sentence) {
                               return sentence.find("1 of 13 trees off the terrain") != std::string::npos;
                           }),
              whole.warnings.end());
}

TEST(SlipOfCoordinates, IsNoneOfPlacesThatLieElsewhere) {
    const std::vector<config::Point2> valley{{170'000.0, 370'000.0}, {171'000.0, 371'000.0}};
    EXPECT_FALSE(slip_of_coordinates(tyrolean_slope, valley, "").has_value());
    const std::vector<config::Point2> swapped{{377'500.0, 177'700.0}};
    ASSERT_TRUE(slip_of_coordinates(tyrolean_slope, swapped, "exchange them").has_value());
    EXPECT_EQ(slip_of_coordinates(tyrolean_slope, swapped, "exchange them")->advice, "exchange them");
}

TEST(LiesBeside, ReachesHalfASideOfTheTerrain) {
    const auto beside = [](double west_m) {
        return lies_beside(tyrolean_slope, {west_m, west_m + 10.0, 377'000.0, 377'010.0});
    };
    EXPECT_TRUE(beside(178'298.0 + 600.0));  // half of 1204 m
    EXPECT_FALSE(beside(178'298.0 + 605.0));
}

TEST(InWords, GroupsLongNumbersAndKeepsTheDecimalsOfShortOnes) {
    EXPECT_EQ(in_words(Extent{2'600'000.4, 2'600'999.6, -5'000.0, 80.0}),
              "2 600 000 to 2 601 000 east, -5 000 to 80 north");
    EXPECT_EQ(in_words(Extent{10.25, 10.5, 47.0, 47.123456}), "10.25 to 10.5 east, 47 to 47.1235 north");
}

}  // namespace
}  // namespace coupling::plausible::off_terrain_test
