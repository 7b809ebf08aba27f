#include "coupling/inputs/ground/ground_soils.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/motion/classical/friction.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::ground_soils_test {
namespace {

const std::vector<std::string> with_pir3d{"rockfall.motion=pir3d"};

TEST(Pir3dSoils, AreTheSixOfTheJuraBeforeAndAfterTheFit) {
    const auto soils = shipped_ground_soils();
    ASSERT_EQ(soils.size(), 12U);
    const auto& scree = soils[8];
    EXPECT_EQ(scree.name, "scree_step_1");
    EXPECT_EQ(scree.restitution.normal, 0.31);
    EXPECT_EQ(scree.restitution.tangential, 0.81);
    EXPECT_EQ(scree.friction, 0.60);
    EXPECT_DOUBLE_EQ(scree.normal_share.slow, 0.08);
    EXPECT_DOUBLE_EQ(scree.tangential_share.fast, 0.04);
    EXPECT_NEAR(scree.upwards_rad.slow, 20.0 * M_PI / 180.0, 1e-12);
    EXPECT_NEAR(scree.threshold_tangent, std::tan(6.0 * M_PI / 180.0), 1e-11);
    EXPECT_EQ(scree.normal_share.limit_mps, 10.0);
    EXPECT_EQ(scree.friction_share.limit_mps, 10.0);
    EXPECT_EQ(soils[9].restitution.tangential, 0.71);
}

TEST(Pir3dSoils, AreKnownForEveryShippedSurface) {
    for (const ShippedSurface& surface : shipped_surfaces()) {
        EXPECT_TRUE(surface.type.soil) << surface.name;
    }
}

TEST(Pir3dSoils, AreNamedByTheSurfaceOrComeWithTheShippedType) {
    const SampleProject project;
    project.write("surface_types.csv",
                  "code,like,soil,r_n,r_t,p_stop\n1,solid_rock,,,,\n3,,scree_step_2,0.3,0.8,0.01\n");
    const Opened opened = open(project, with_pir3d);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->slope.types[0].soil->name, "sound_rock_step_2");
    EXPECT_EQ(opened.site->slope.types[1].soil->name, "scree_step_2");
}

TEST(Pir3dSoils, MayBeTheUsersOwn) {
    const SampleProject project;
    project.write(
        "soils.csv",
        "name,like,r_t,threshold_deg\nmeadow,soft_soil_step_1,0.75,5\nscree_step_1,scree_step_2,0.6,\n");
    project.write("surface_types.csv",
                  "code,soil,r_n,r_t,p_stop\n1,scree_step_1,0.4,0.9,0\n3,meadow,0.3,0.8,0\n");
    const std::vector<std::string> settings{"rockfall.motion=pir3d", "terrain.soils=soils.csv"};
    const Opened opened = open(project, settings);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->slope.types[0].soil->restitution.tangential,
              0.6);  // takes the place of the shipped
    EXPECT_EQ(opened.site->slope.types[1].soil->restitution.tangential, 0.75);
    EXPECT_EQ(opened.site->slope.types[1].soil->friction, 0.65);
}

TEST(Pir3dSoils, MayHaveAWidthAndALimitOfTheirOwnForEachParameter) {
    const SampleProject project;
    project.write(
        "soils.csv",
        "name,like,dr_t_fast_percent,angle_v_slow_deg,limit_angle_mps,limit_angle_v_mps,limit_k_mps\n"
        "meadow,soft_soil_step_1,3,25,15,20,5\n");
    project.write("surface_types.csv", "code,soil,r_n,r_t,p_stop\n1,meadow,0.4,0.9,0\n3,meadow,0.3,0.8,0\n");
    const std::vector<std::string> settings{"rockfall.motion=pir3d", "terrain.soils=soils.csv"};
    const Opened opened = open(project, settings);
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::Soil& soil = *opened.site->slope.types[0].soil;
    EXPECT_DOUBLE_EQ(soil.normal_share.fast, 0.06);  // of the pair, as in the shipped soil
    EXPECT_DOUBLE_EQ(soil.tangential_share.slow, 0.10);
    EXPECT_DOUBLE_EQ(soil.tangential_share.fast, 0.03);
    EXPECT_NEAR(soil.sideways_rad.slow, 20.0 * M_PI / 180.0, 1e-12);
    EXPECT_NEAR(soil.upwards_rad.slow, 25.0 * M_PI / 180.0, 1e-12);
    EXPECT_EQ(soil.normal_share.limit_mps, 10.0);
    EXPECT_EQ(soil.sideways_rad.limit_mps, 15.0);
    EXPECT_EQ(soil.upwards_rad.limit_mps, 20.0);
    EXPECT_EQ(soil.friction_share.limit_mps, 5.0);
}

TEST(ClassicalFriction, OfAGroundIsItsOwnElseThatOfItsSoil) {
    const SampleProject project;
    project.write("surface_types.csv",
                  "code,like,soil,r_n,r_t,p_stop,sliding_friction\n1,solid_rock,,,,,\n3,,scree_step_1,0.3,0."
                  "8,0,0.45\n");
    const Opened opened = open(project, {"rockfall.motion=classical", "classical.friction=ground"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.warnings, std::vector<std::string>{});
    const auto& law = opened.scenario->rockfall.fall.motion.of<rockfall::classical::Model>();
    EXPECT_EQ(friction_of(opened.site->slope.types[0], law), 0.50);
    EXPECT_EQ(friction_of(opened.site->slope.types[1], law), 0.45);
}

TEST(ModelLimits, AreSaidWherePir3dHasALongWayDown) {
    const SampleProject project;
    EXPECT_EQ(open(project, with_pir3d).warnings, std::vector<std::string>{});  // 63 m from the sources
    project.write("dem.asc", SampleProject::header() + SampleProject::rows([](int column, int) {
                                 return std::to_string(1400 - 50 * column);
                             }));
    const Opened opened = open(project, with_pir3d);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.warnings.size(), 1U);
    EXPECT_NE(opened.warnings[0].find("they may drop 450 m here"), std::string::npos) << opened.warnings[0];
}

}  // namespace
}  // namespace coupling::ground_soils_test
