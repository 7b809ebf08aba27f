#include "rockfall/parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace rockfall::parameters_test {
namespace {

/// The settings of a scenario that says this about rockfall.
Parameters settings_of(const std::string& text) {
    Parameters parameters;
    std::string preset = "default";
    config::Options options;
    options.text("rockfall.preset", preset, {.meaning = "named set"});
    declare(options, parameters);
    std::istringstream in{text};
    options.read(in, "scenario.ini", {}, "rockfall.preset");
    take_over(parameters, options);
    return parameters;
}

Parameters preset(const std::string& name) {
    return settings_of("[rockfall]\npreset = " + name + "\n");
}

std::string message_of(const std::string& text) {
    try {
        settings_of(text);
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::settings);
        return error.what();
    }
    return "";
}

TEST(RockfallParameters, StrictIsWhatThePaperStates) {
    const Parameters strict = preset("strict");
    EXPECT_EQ(strict.ground.contact_radius_m, 0.0);
    EXPECT_EQ(strict.fall.motion.of<picus::Model>().jump_angle.scatter, 0.0);
    EXPECT_FALSE(strict.fall.motion.of<picus::Model>().blend_steep_impacts);
    EXPECT_FALSE(strict.fall.motion.of<picus::Model>().impact_friction);
    EXPECT_FALSE(strict.fall.tree.taper);
    EXPECT_FALSE(strict.fall.tree.height_effect);
    EXPECT_TRUE(strict.fall.motion.of<picus::Model>().restitution.damping);
    EXPECT_EQ(strict.fall.motion.of<picus::Model>().angle, ReboundAngle::jump_angle_law);
    EXPECT_TRUE(strict.fall.motion.of<picus::Model>().stopping.by_chance);
    EXPECT_FALSE(strict.fall.motion.of<picus::Model>().stopping.catches_rolling);
    EXPECT_FALSE(strict.fall.motion.of<picus::Model>().stops_by_hop_length);
    EXPECT_FALSE(strict.fall.motion.of<picus::Model>().restitution.fitted);
    EXPECT_EQ(strict.fall.motion.of<picus::Model>().restitution.normal_halved_mps, 0.0);
    EXPECT_EQ(strict.fall.motion.of<picus::Model>().restitution.tangential_noise, 0.05);
    EXPECT_EQ(strict.fall.motion.of<picus::Model>().noise, picus::NoiseScope::impact);
}

TEST(RockfallParameters, TheEarlierVariantsOfThePaperLeaveOutItsLaterSteps) {
    const Parameters rebound = preset("paper_rebound");
    EXPECT_TRUE(rebound.fall.motion.of<picus::Model>().restitution.damping);
    EXPECT_EQ(rebound.fall.motion.of<picus::Model>().angle, ReboundAngle::jump_angle_law);
    EXPECT_FALSE(rebound.fall.motion.of<picus::Model>().stopping.by_chance);

    const Parameters initial = preset("paper_initial");
    EXPECT_FALSE(initial.fall.motion.of<picus::Model>().restitution.damping);
    EXPECT_EQ(initial.fall.motion.of<picus::Model>().jump_angle.exponent, 0.0) << "a constant angle";
    EXPECT_FALSE(initial.fall.motion.of<picus::Model>().stopping.by_chance);
    EXPECT_EQ(initial.ground.contact_radius_m, 0.0);
}

TEST(RockfallParameters, OfRocksWithAShapeTakeTheTerrainAsItIs) {
    EXPECT_FALSE(settings_of("[rockfall]\nmotion = picus\n").ground.contact_law(1.0).moves_nothing());
    EXPECT_TRUE(settings_of("[rockfall]\nmotion = rigid\ncontact_radius_m = 3\n")
                    .ground.contact_law(1.0)
                    .moves_nothing());
}

TEST(RockfallParameters, WhatTheUserSetsWinsOverThePreset) {
    const Parameters parameters = settings_of("[rockfall]\ncontact_radius_m = 3\npreset = strict\n");
    EXPECT_EQ(parameters.ground.contact_radius_m, 3.0);
    EXPECT_EQ(parameters.fall.motion.of<picus::Model>().jump_angle.scatter, 0.0);
}

TEST(RockfallParameters, TheDefaultsOfTheLawsAreThoseOfTheSettings) {
    const Parameters read = settings_of("");
    const picus::Law law;
    EXPECT_DOUBLE_EQ(read.fall.motion.of<picus::Model>().jump_angle.coefficient.in_degrees(),
                     law.jump_angle.coefficient.in_degrees());
    EXPECT_DOUBLE_EQ(read.fall.motion.of<picus::Model>().jump_angle.cap.in_degrees(),
                     law.jump_angle.cap.in_degrees());
    EXPECT_DOUBLE_EQ(read.fall.motion.of<picus::Model>().lateral.at_rest.in_degrees(),
                     law.lateral.at_rest.in_degrees());
    EXPECT_DOUBLE_EQ(read.fall.motion.of<picus::Model>().lateral.when_fast.in_degrees(),
                     law.lateral.when_fast.in_degrees());
    EXPECT_NEAR(read.fall.motion.of<picus::Model>().rolling.edge_angle_tangent,
                law.rolling.edge_angle_tangent, 1e-4);
    EXPECT_EQ(read.fall.motion.of<picus::Model>().stopping.most_impacts, law.stopping.most_impacts);
}

TEST(RockfallParameters, AnglesAreWrittenInDegrees) {
    const Parameters parameters =
        settings_of("[picus]\njump_angle_cap_deg = 45\n[rockfall]\nrolling_edge_deg = 45\n");
    EXPECT_DOUBLE_EQ(parameters.fall.motion.of<picus::Model>().jump_angle.cap.in_degrees(), 45.0);
    EXPECT_DOUBLE_EQ(parameters.fall.motion.of<picus::Model>().rolling.edge_angle_tangent, 1.0);
}

TEST(RockfallParameters, EarlierNamesOfSettingsStillWork) {
    const Parameters earlier =
        settings_of("[rockfall]\nrt_noise_scope = rock\nstopping = no\nlateral_fast_mps = 12\n");
    EXPECT_EQ(earlier.fall.motion.of<picus::Model>().noise, picus::NoiseScope::rock);
    EXPECT_FALSE(earlier.fall.motion.of<picus::Model>().stopping.by_chance);
    EXPECT_EQ(earlier.fall.motion.of<picus::Model>().lateral.fast_mps, 12.0);
}

TEST(RockfallParameters, EachMotionModelHasASectionOfItsOwn) {
    Parameters parameters;
    config::Options options;
    declare(options, parameters);
    const std::vector<config::ParameterRow> rows = options.rows();
    const auto is_set_in = [&](const std::string& begin) {
        return std::any_of(rows.begin(), rows.end(),
                           [&](const config::ParameterRow& row) { return row.key.starts_with(begin); });
    };
    for (const MotionModel model : all_models()) {
        const ModelDescription& description = description_of(model);
        EXPECT_TRUE(is_set_in(std::string{description.name} + ".")) << description.name;
        for (const std::vector<std::string>* settings :
             {&description.shared_settings, &description.sideways_settings}) {
            for (const std::string& key : *settings) {
                if (key.starts_with("release.")) {
                    continue;  // not declared in this room:
                               // tests/coupling/inputs/scenario/block_shapes_test.cpp
                }
                EXPECT_TRUE(is_set_in(key)) << description.name << " names " << key;
            }
        }
    }
}

TEST(RockfallParameters, InAPlaneNoModelTurnsRocksSideways) {
    Parameters parameters;
    stay_in_plane(parameters);
    config::Options options;
    Parameters declared;
    declare(options, declared);
    take_over(parameters, options);
    const MotionLaws& laws = parameters.fall.motion;
    EXPECT_EQ(laws.of<picus::Model>().lateral.at_rest.in_radians(), 0.0);
    EXPECT_EQ(laws.of<picus::Model>().lateral.when_fast.in_radians(), 0.0);
    EXPECT_FALSE(laws.of<pir3d::Model>().turns_sideways);
    EXPECT_EQ(laws.of<classical::Model>().lateral.in_radians(), 0.0);
}

TEST(RockfallParameters, EachSettingSaysWhatItMeansAndWhereItComesFrom) {
    Parameters parameters;
    config::Options options;
    declare(options, parameters);
    for (const config::ParameterRow& row : options.rows()) {
        EXPECT_FALSE(row.meaning.empty()) << row.key;
        EXPECT_FALSE(row.source.empty()) << row.key;
    }
}

TEST(RockfallParameters, RefusesSettingsThatContradictEachOther) {
    EXPECT_EQ(message_of("[picus]\nrolling_launch_factor = 0.5\n"),
              "scenario.ini:2:25: found picus.rolling_launch_factor not above picus.rolling_start_factor, "
              "expected a rock that just began to roll not to jump at once");
    EXPECT_EQ(message_of("[tree_impact]\nscratch_limit = 0.3\n"),
              "scenario.ini:2:17: found tree_impact.scratch_limit below tree_impact.frontal_limit, expected "
              "lateral "
              "hits between frontal hits and scratches");
}

TEST(DeviationMatrix, HasThePublishedShares) {
    const DeviationMatrix matrix = shipped_deviation_matrix();
    EXPECT_DOUBLE_EQ(matrix.shares[static_cast<std::size_t>(HitType::frontal)][0], 0.44);
    EXPECT_DOUBLE_EQ(matrix.shares[static_cast<std::size_t>(HitType::lateral)][1], 0.76);
    EXPECT_DOUBLE_EQ(matrix.shares[static_cast<std::size_t>(HitType::scratch)][2], 0.04);
    EXPECT_DOUBLE_EQ(matrix.limits[1].in_degrees(), 22.5);
    EXPECT_DOUBLE_EQ(matrix.limits[3].in_degrees(), 76.0);
    for (const auto& shares : matrix.shares) {
        EXPECT_NEAR(shares[0] + shares[1] + shares[2], 1.0, 1e-12);
    }
}

TEST(DeviationMatrix, RefusesSharesThatDoNotSumToOne) {
    const std::string table =
        "hit_type,from_deg,to_deg,share\n"
        "frontal,0,22.5,0.5\nfrontal,22.5,67.5,0.5\nfrontal,67.5,76,0.5\n";
    EXPECT_THROW(read_deviation_matrix(table, "deviation.csv"), config::InputError);
}

}  // namespace
}  // namespace rockfall::parameters_test
