#include "coupling/inputs/ground/ground_soils.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/motion/classical/friction.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::ground_soils_test {
namespace {

using config::ExitCode;

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

TEST(Pir3dSoils, OfASurfaceThatHasNoneAreAskedForByThatModelOnly) {
    const SampleProject project;
    project.write("surface_types.csv",
                  "code,label,r_n,r_t,p_stop\n1,rock,0.40,0.90,0\n3,soil,0.30,0.80,0.01\n");
    EXPECT_TRUE(open(project).site);
    const Opened opened = open(project, with_pir3d);
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_EQ(opened.errors,
              "surface_types.csv:2:1: found code 1 without soil, expected a soil in a column soil, as "
              "rockfall.motion = pir3d needs it; write soil = sound_rock_step_1 (nearest in r_n and r_t), or "
              "another name of `bannwald info pir3d_soils` or of terrain.soils\n"
              "surface_types.csv:3:1: found code 3 without soil, expected a soil in a column soil, as "
              "rockfall.motion = pir3d needs it; write soil = soft_soil_step_1 (nearest in r_n and r_t), or "
              "another name of `bannwald info pir3d_soils` or of terrain.soils");
}

TEST(Pir3dSoils, OfAnUnknownNameAreRefusedWithTheNearest) {
    const SampleProject project;
    project.write("surface_types.csv",
                  "code,soil,r_n,r_t,p_stop\n1,scree_step2,0.4,0.9,0\n3,scree_step_1,0.3,0.8,0\n");
    const Opened opened = open(project, with_pir3d);
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_EQ(
        opened.errors,
        "surface_types.csv:2:3: found soil 'scree_step2', expected a soil of `bannwald info pir3d_soils` or "
        "of terrain.soils (scree_step_2?)");
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
    EXPECT_EQ(opened.warnings,
              std::vector<std::string>{
                  "soils.csv:3:1: soil 'scree_step_1' replaces the shipped soil of that name"});

    project.write("soils.csv", "name,like,r_t,friction\nmeadow,softsoil_step_1,0.75,\nclay,,1.5,0.6\n");
    const std::string errors = open(project, settings).errors;
    EXPECT_TRUE(
        errors.starts_with("soils.csv:2:8: found 'softsoil_step_1', expected a soil of "
                           "`bannwald info pir3d_soils` or of terrain.soils (soft_soil_step_1?)\n"
                           "soils.csv:3:1: found soil 'clay' without r_n, expected a column "
                           "r_n, or a shipped soil in a column like\n"))
        << errors;
    EXPECT_NE(errors.find("soils.csv:3:7: found r_t '1.5', expected a number in [0, 0.99]"),
              std::string::npos)
        << errors;
}

TEST(MotionModel, TellsOfSettingsOfTheOther) {
    const SampleProject project;
    const Opened slides = open(project, {"rockfall.motion=pir3d", "picus.rolling_friction=0.4"});
    ASSERT_TRUE(slides.site) << slides.errors;
    EXPECT_EQ(slides.warnings,
              std::vector<std::string>{"rockfall.motion is pir3d: picus.rolling_friction has no effect"});
    const Opened rolls = open(project, {"pir3d.least_hop=0.2", "pir3d.spread=normal"});
    EXPECT_EQ(rolls.warnings, std::vector<std::string>{
                                  "rockfall.motion is picus: pir3d.spread, pir3d.least_hop have no effect"});
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

    project.write("soils.csv", "name,like,limit_angels_mps\nmeadow,soft_soil_step_1,15\n");
    EXPECT_NE(open(project, settings)
                  .errors.find("soils.csv: found column 'limit_angels_mps', which has no meaning, expected "
                               "limit_angle_mps; correct its name, or remove it"),
              std::string::npos)
        << open(project, settings).errors;
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

TEST(ModelLimits, AreSaidWhereTheClassicalModelSlidesOffTheSlope) {
    const SampleProject project;  // 35 degrees all over; (1 - r_t) / r_t is 0.11 and 0.25
    const Opened opened = open(project, {"rockfall.motion=classical"});
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.warnings.size(), 1U);
    EXPECT_NE(opened.warnings[0].find("rock 0.11, 100 % of it steeper; soil 0.25, 100 % of it steeper"),
              std::string::npos)
        << opened.warnings[0];
    // A table without soils has no friction of its own.
    project.write("surface_types.csv", "code,label,r_n,r_t,p_stop\n1,rock,0.4,0.9,0\n3,soil,0.3,0.8,0\n");
    const Opened without = open(project, {"rockfall.motion=classical", "classical.friction=ground"});
    ASSERT_EQ(without.warnings.size(), 1U);
    EXPECT_NE(without.warnings[0].find("no sliding_friction and no soil for rock, soil"), std::string::npos)
        << without.warnings[0];
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
