#include "coupling/assessments/profile/falls/profile_site.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "coupling/inputs/scenario/profile_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/coupling/assessments/profile/profile_project.hpp"

namespace coupling::profile::profile_site_test {
namespace {

struct Project : SampleProject {
    Project() { make_profile_project(*this); }
};

TEST(OpenProfile, ReadsCornersTypesAndStations) {
    const Project project;
    const OpenedProfile opened = open_profile_of(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ProfileSite& site = *opened.site;
    ASSERT_EQ(site.corners.size(), 5U);
    EXPECT_EQ(site.slope.type_at(50.0, 0.0).label, "rock");
    EXPECT_EQ(site.slope.type_at(102.0, 0.0).label, "forest road");
    EXPECT_EQ(site.slope.type_at(110.0, 0.0).label, "soil");
    EXPECT_EQ(site.slope.type_at(299.0, 0.0).label, "soil");
    EXPECT_EQ(site.start_m, 0.0);
    ASSERT_EQ(site.stations.size(), 2U);
    EXPECT_EQ(site.stations[0].name, "road");
    EXPECT_EQ(site.inputs.size(), 3U);
    EXPECT_TRUE(opened.warnings.all().empty());
}

TEST(OpenProfile, MeasuresAlongTheSlope) {
    const Project project;
    const OpenedProfile opened = open_profile_of(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ProfileSite& site = *opened.site;
    const double first_m = std::hypot(100.0, 84.0);
    EXPECT_DOUBLE_EQ(site.slope_length_m(0.0), 0.0);
    EXPECT_DOUBLE_EQ(site.slope_length_m(-5.0), 0.0);
    EXPECT_DOUBLE_EQ(site.slope_length_m(50.0), 0.5 * first_m);
    EXPECT_DOUBLE_EQ(site.slope_length_m(104.0), first_m + 4.0);
    for (const double distance_m : {0.0, 17.0, 100.0, 102.5, 200.0, 300.0}) {
        EXPECT_NEAR(site.distance_at_m(site.slope_length_m(distance_m)), distance_m, 1e-9);
    }
    EXPECT_DOUBLE_EQ(site.height_m(50.0), 458.0);
    EXPECT_DOUBLE_EQ(site.height_m(-5.0), 500.0);
    EXPECT_DOUBLE_EQ(site.height_m(500.0), 337.5);
}

TEST(OpenProfile, FeelsTheContactZoneUnlessStrict) {
    const Project project;
    const OpenedProfile usual = open_profile_of(project);
    const OpenedProfile strict = open_profile_of(project, {"rockfall.preset=strict"});
    ASSERT_TRUE(usual.site && strict.site);
    EXPECT_EQ(strict.site->slope.terrain.vertices().size(), 10U);
    EXPECT_GT(usual.site->slope.terrain.vertices().size(), 600U);
    EXPECT_EQ(strict.site->slope.terrain.height_m(240.0, 0.0), 337.5);
    EXPECT_GT(usual.site->slope.terrain.height_m(240.0, 0.0).value(), 337.6);  // the foot is filled a little
}

TEST(OpenProfile, TurnsDeviationOffInEverySet) {
    const Project project;
    for (const std::string preset : {"default", "strict", "paper_rebound", "paper_initial"}) {
        const OpenedProfile opened = open_profile_of(project, {"rockfall.preset=" + preset});
        ASSERT_TRUE(opened.scenario) << opened.errors;
        EXPECT_EQ(
            opened.scenario->rockfall.fall.motion.of<rockfall::picus::Model>().lateral.at_rest.in_radians(),
            0.0);
        EXPECT_EQ(
            opened.scenario->rockfall.fall.motion.of<rockfall::picus::Model>().lateral.when_fast.in_radians(),
            0.0);
    }
}

TEST(OpenProfile, StartsAtItsUpperEndUnlessToldOtherwise) {
    const Project project;
    project.write("profile.csv", "distance_m,height_m,surface\n1000,500,1\n1100,416,road\n1300,300,\n");
    project.write("stations.csv", "name,distance_m\nroad,1100\n");
    EXPECT_EQ(open_profile_of(project).site->start_m, 1000.0);
    EXPECT_EQ(open_profile_of(project, {"profile.start_m=1005"}).site->start_m, 1005.0);
    const OpenedProfile before = open_profile_of(project, {"profile.start_m=0"});
    EXPECT_NE(before.errors.find(
                  "profile.start_m at 0 m beyond the profile, expected a distance in [1000, 1300] m"),
              std::string::npos)
        << before.errors;
}

TEST(OpenProfile, TellsOfStartsThatRiseAndOfTypesTooNarrowToSee) {
    const Project project;
    project.write("profile.csv",
                  "distance_m,height_m,surface\n0,500,1\n50,510,1\n100,416,road\n100.01,410,3\n300,337.5,\n");
    const OpenedProfile opened = open_profile_of(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.warnings.all().size(), 2U);
    // What is doubtful comes before what is only noted.
    EXPECT_NE(opened.warnings.all()[1].find("100 m reaches over 0.01 m only"), std::string::npos);
    EXPECT_NE(opened.warnings.all()[0].find("rises with distance at the start"), std::string::npos);
}

TEST(ProfileSettings, RefuseEachKeyWithoutMeaning) {
    const Project project;
    for (const std::string setting :
         {"terrain.dem=dem.asc", "terrain.points=p.xyz", "terrain.surface=s.asc",
          "terrain.surface_polygons=s.csv", "trees.file=trees.csv", "release.source=source.asc",
          "release.source_shapes=s.csv", "release.rocks_per_source=10", "release.random_place=yes",
          "release.start_scatter_deg=5", "targets.file=targets.csv", "output.cell_size_m=5",
          "output.percentiles=no", "output.tree_hit_table=no", "picus.lateral_slow_deg=16",
          "picus.lateral_fast_deg=11", "picus.lateral_fast_mps=10", "rockfall.vertical_tolerance_m=0.1",
          "tree_impact.taper=no"}) {
        const std::string key = setting.substr(0, setting.find('='));
        const OpenedProfile opened = open_profile_of(project, {setting});
        EXPECT_NE(opened.errors.find(key + " beside terrain.profile"), std::string::npos) << opened.errors;
        EXPECT_TRUE(plays_no_part(key)) << key;
    }
    const OpenedProfile both = open_profile_of(project, {"profile.stations_m=50"});
    EXPECT_NE(both.errors.find("profile.stations beside profile.stations_m"), std::string::npos)
        << both.errors;
}

TEST(ProfileSettings, NeedAProfile) {
    const SampleProject project;
    const OpenedProfile opened = open_profile_of(project, {"profile.segment_m=5"});
    EXPECT_NE(opened.errors.find("profile.segment_m without terrain.profile"), std::string::npos)
        << opened.errors;
}

}  // namespace
}  // namespace coupling::profile::profile_site_test
