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
    project.write("profile.csv", "distance_m,height_m,surface\n0,500,1\n100,416,3\n300,300,\n");
    const OpenedProfile usual = open_profile_of(project, {"rockfall.contact_radius_m=4"});
    const OpenedProfile strict = open_profile_of(project, {"rockfall.preset=strict"});
    ASSERT_TRUE(usual.site && strict.site) << usual.errors << strict.errors;
    EXPECT_EQ(strict.site->slope.terrain.vertices().size(), 6U);
    EXPECT_GT(usual.site->slope.terrain.vertices().size(), 600U);
    EXPECT_EQ(strict.site->slope.terrain.height_m(100.0, 0.0), 416.0);
    EXPECT_GT(usual.site->slope.terrain.height_m(100.0, 0.0).value(), 416.05);  // the bend is filled a little
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
}

TEST(ProfileSettings, KnowTheKeysThatPlayNoPart) {
    // That each is refused is a case of tests/refusals/profile.cases.
    for (const char* key :
         {"terrain.dem", "terrain.points", "terrain.surface", "terrain.surface_polygons", "trees.file",
          "release.source", "release.source_shapes", "release.rocks_per_source", "release.random_place",
          "release.start_scatter_deg", "targets.file", "output.cell_size_m", "output.percentiles",
          "output.tree_hit_table", "picus.lateral_slow_deg", "picus.lateral_fast_deg",
          "picus.lateral_fast_mps", "rockfall.vertical_tolerance_m", "tree_impact.taper"}) {
        EXPECT_TRUE(plays_no_part(key)) << key;
    }
}

}  // namespace
}  // namespace coupling::profile::profile_site_test
