#include "coupling/inputs/scenario/block_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/scenario/block_grounds.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::block_shapes_test {
namespace {

/// A project of blocks with these settings.
Opened open_blocks(const SampleProject& project, std::vector<std::string> settings) {
    settings.insert(settings.begin(), "rockfall.motion=rigid");
    return open(project, settings);
}

rockfall::DrawnBlock drawn(const Opened& opened, std::uint64_t rock = 1) {
    const rockfall::StartLaw law = start_law(opened.scenario->release);
    return law.shape->draw(1.0, 2700.0, {1, 0, 0, rock});
}

const char* const tetrahedron = "x_m,y_m,z_m\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n";

TEST(BlockShapes, AreSettingsThatTheirModelNames) {
    const SampleProject project;
    const Opened opened = open_blocks(project, {});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto rows = opened.scenario->options->rows();
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        for (const std::string& key : rockfall::description_of(model).shared_settings) {
            EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
                return row.key == key;
            })) << key;
        }
    }
}

TEST(BlockShapes, HaveNoEffectUnderOtherModels) {
    const SampleProject project;
    const Opened opened = open(project, {"release.shape=plate"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(start_law(opened.scenario->release).shape, nullptr);
}

TEST(BlockShapes, HaveTheVolumeOfTheSphereOfTheirDiameter) {
    const SampleProject project;
    project.write("hull.csv", tetrahedron);
    for (const std::string shape : {"cube", "plate", "column", "octahedron", "compact", "very-elongate",
                                    "hull", "box", "rounded", "ellipsoid"}) {
        const Opened opened = open_blocks(
            project, {"release.shape=" + shape, "release.shape_file=hull.csv", "release.sides=3, 2, 1"});
        ASSERT_TRUE(opened.site) << shape << opened.errors;
        EXPECT_NEAR(drawn(opened).solid->mass_kg, 2700.0 * M_PI / 6.0, 1e-6) << shape;
    }
}

TEST(BlockShapes, OfGivenSidesReplaceTheDiameter) {
    const SampleProject project;
    const Opened opened = open_blocks(project, {"release.shape=box", "release.sides_m=1, 0.8, 0.5"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_NEAR(drawn(opened).solid->mass_kg, 2700.0 * 0.4, 1e-9);
}

TEST(BlockShapes, ScatterEachSideWithinItsShare) {
    const SampleProject project;
    const Opened opened =
        open_blocks(project, {"release.shape=box", "release.sides_m=1, 1, 1", "release.sides_scatter=0.3"});
    ASSERT_TRUE(opened.site) << opened.errors;
    double smallest_kg = 1e9, largest_kg = 0.0;
    for (std::uint64_t rock = 0; rock < 500; ++rock) {
        const double mass_kg = drawn(opened, rock).solid->mass_kg;
        smallest_kg = std::min(smallest_kg, mass_kg);
        largest_kg = std::max(largest_kg, mass_kg);
    }
    EXPECT_GE(smallest_kg, 2700.0 * 0.343);
    EXPECT_LT(smallest_kg, 2700.0 * 0.55);
    EXPECT_LE(largest_kg, 2700.0 * 2.197);
    EXPECT_GT(largest_kg, 2700.0 * 1.7);
}

TEST(BlockShapes, ComeFromColumnsOfTheSources) {
    const SampleProject project;
    project.write("cliffs.csv",
                  "zone,wkt,shape,side_a_m,side_b_m,side_c_m\n"
                  "1,\"LINESTRING (1020 2030, 1020 2060)\",,2,1,0.5\n"
                  "2,\"LINESTRING (1030 2030, 1030 2040)\",plate,,,\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = cliffs.csv");
    const Opened opened = open_blocks(project, {});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto& sources = opened.site->sources;
    ASSERT_GE(sources.size(), 2U);
    EXPECT_NEAR(sources.front().own_start->shape->draw(0.5, 2700.0, {1, 0, 0, 1}).solid->mass_kg, 2700.0,
                1e-6);
    EXPECT_EQ(sources.back().own_start->shape->shapes().front().name, "plate");
}

TEST(BlockShapes, OfSidesBesideAMassHaveThatMass) {
    const SampleProject project;
    project.write("cliffs.csv",
                  "zone,wkt,shape,side_a_m,side_b_m,side_c_m,mass_t\n"
                  "1,\"LINESTRING (1020 2030, 1020 2060)\",rounded,0.5,0.3,0.39,0.079\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = cliffs.csv");
    const Opened opened = open_blocks(project, {});
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::StartLaw& law = *opened.site->sources.front().own_start;
    const rockfall::DrawnBlock block = law.shape->draw(law.diameter.at(0.5), law.density_kgpm3, {1, 0, 0, 1});
    EXPECT_NEAR(block.solid->mass_kg, 79.0, 1e-6);
}

TEST(BlockPresets, UnityCompatIsChosenInAScenario) {
    const SampleProject project;
    project.replace("scenario.ini", "[targets]",
                    "[rockfall]\nmotion = rigid\npreset = unity_compat\n[targets]");
    const Opened opened = open(project, {});
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::rigid::Law& law = opened.scenario->rockfall.fall.motion.of<rockfall::rigid::Model>();
    const rockfall::BlockGround ground = rockfall::rigid::ground_under(law, {});
    // tan(35 degrees) / 2, twice where two points touch; 7 rad/s at most; nothing else that brakes.
    EXPECT_NEAR(ground.friction, 0.5 * std::tan(35.0 * M_PI / 180.0), 1e-12);
    EXPECT_EQ(ground.law, rockfall::FrictionLaw::constant);
    EXPECT_EQ(ground.restitution, 0.0);
    EXPECT_EQ(ground.drag_ps, 0.0);
    EXPECT_EQ(ground.rolling_resistance, 0.0);
    EXPECT_TRUE(law.double_friction);
    EXPECT_EQ(law.spin_cap_radps, 7.0);

    const Opened physical = open_blocks(project, {"rockfall.preset=default"});
    ASSERT_TRUE(physical.site) << physical.errors;
    const auto& other = physical.scenario->rockfall.fall.motion.of<rockfall::rigid::Model>();
    EXPECT_FALSE(other.double_friction);
    EXPECT_EQ(other.spin_cap_radps, 0.0);
}

TEST(BlockGrounds, ComeFromTheShippedTypeTheClassAndSingleColumns) {
    const SampleProject project;
    project.write(
        "surface_types.csv",
        "code,like,r_n,r_t,p_stop,rigid_ground,friction\n1,solid_rock,,,,,\n3,,0.3,0.8,0.01,soft,0.4\n");
    const Opened opened = open_blocks(project, {});
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::BlockGround& rock = opened.site->slope.types[0].block;
    EXPECT_EQ(rock.name, "extra_hard");
    EXPECT_EQ(rock.friction, 0.80);
    const rockfall::BlockGround& soil = opened.site->slope.types[1].block;
    EXPECT_EQ(soil.friction, 0.4);
    EXPECT_EQ(soil.slip_kappa_pm, 1.25);
}

TEST(BlockGrounds, AreHardUnlessSaid) {
    const rockfall::BlockGround unsaid;
    for (const rockfall::BlockGround& shipped : shipped_block_grounds()) {
        if (shipped.name == "hard") {
            EXPECT_EQ(unsaid.law, shipped.law);
            EXPECT_EQ(unsaid.friction, shipped.friction);
            EXPECT_EQ(unsaid.friction_max, shipped.friction_max);
            EXPECT_EQ(unsaid.slip_beta_ps, shipped.slip_beta_ps);
            EXPECT_EQ(unsaid.slip_kappa_pm, shipped.slip_kappa_pm);
            EXPECT_EQ(unsaid.drag_ps, shipped.drag_ps);
            EXPECT_EQ(unsaid.restitution, shipped.restitution);
            EXPECT_EQ(unsaid.rolling_resistance, shipped.rolling_resistance);
            return;
        }
    }
    FAIL() << "no class hard";
}

TEST(BlockGrounds, OfTheClassHardAreThoseOfLuAndOthers) {
    // The only confirmed class: 0.55, 2, 185 1/s, 3 1/m, 0.5 1/s.
    const auto& grounds = shipped_block_grounds();
    const auto hard =
        std::find_if(grounds.begin(), grounds.end(), [](const auto& g) { return g.name == "hard"; });
    ASSERT_NE(hard, grounds.end());
    EXPECT_EQ(hard->friction, 0.55);
    EXPECT_EQ(hard->friction_max, 2.0);
    EXPECT_EQ(hard->slip_beta_ps, 185.0);
    EXPECT_EQ(hard->slip_kappa_pm, 3.0);
    EXPECT_EQ(hard->drag_ps, 0.5);
}

}  // namespace
}  // namespace coupling::block_shapes_test
