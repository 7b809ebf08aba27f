// `bannwald collapse` from end to end, on a small SYNTHETIC cliff.

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include "config/table/table.hpp"
#include "coupling/inputs/formats/json_library.hpp"
#include "tests/runs/program.hpp"

namespace coupling::collapse_runs_test {
namespace {

/// Few large blocks for a short time.
const std::string few =
    "collapse p/scenario.ini --quiet --set collapse.duration_s=0.2 --set collapse.frame_s=0.05 "
    "--set collapse.depth_m=8 --set collapse.least_block_m=2 --set collapse.settle_s=0.1 --out ";

/// Some forty blocks of which a few leave the mass and come back, the first ones before the first of two
/// frames.
const std::string handing =
    "collapse p/scenario.ini --quiet --set collapse.duration_s=7 --set collapse.frame_s=5.5 "
    "--set collapse.depth_m=8 --set collapse.least_block_m=3 --set collapse.hand_over=rigid "
    "--set collapse.hand_over_after_s=0.1 --set terrain.ground=coarse_debris --set output.vtp=yes --out ";

double number_of(const config::Table& table, std::size_t row, const std::string& column) {
    config::Problems problems;
    return table.number(row, column, {}, problems).value_or(-1e99);
}

config::Table table_of(const SampleProject& project, const std::string& file) {
    std::istringstream in{project.read(file)};
    return config::Table::read(in, file);
}

/// Falls of handed_falls.csv after which the block came back into the mass before a time.
std::size_t returns_before(const config::Table& falls, double time_s) {
    std::size_t count = 0;
    for (std::size_t row = 0; row < falls.rows(); ++row) {
        count +=
            !falls.text(row, "returned_s").empty() && number_of(falls, row, "returned_s") < time_s ? 1 : 0;
    }
    return count;
}

class CollapseRuns : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(call(project, "init p --example collapse-small --quiet").code, 0); }
    SampleProject project;
};

TEST_F(CollapseRuns, WritesTheSameBytesOnAnyNumberOfThreads) {
    ASSERT_EQ(call(project, few + "one --threads 1").code, 0);
    for (const char* threads : {"2", "4"}) {
        const std::string out = std::string{"on_"} + threads;
        ASSERT_EQ(call(project, few + out + " --threads " + threads).code, 0);
        const auto differences = shell(project, "diff -r one " + out + "\n");
        EXPECT_EQ(differences.code, 0) << threads << " threads: " << differences.out;
    }
}

TEST_F(CollapseRuns, WritesTablesForExcelAndAWorkbookAsOtherRunsDo) {
    ASSERT_EQ(call(project, few + "out --set output.csv=excel --set output.xlsx=yes").code, 0);
    EXPECT_TRUE(project.read("out/results.xlsx").starts_with("PK"));
    std::size_t tables = 0;
    for (const auto& entry : std::filesystem::directory_iterator{project.file("out/tables")}) {
        const std::string name = "out/tables/" + entry.path().filename().string();
        EXPECT_TRUE(project.read(name).starts_with("\xEF\xBB\xBF")) << name;
        ++tables;
    }
    EXPECT_GT(tables, 3U);
}

TEST_F(CollapseRuns, GoesOnAfterItWasKilledWithTheSameBytes) {
    ASSERT_EQ(call(project, few + "whole").code, 0);
    // Killed once the state of the first frame is on the disk: there is no time to tidy up.
    EXPECT_EQ(shell(project, interrupted_once("parts/parts/mass.part", few + "parts", "KILL")).code, 137);
    ASSERT_EQ(call(project, few + "parts").code, 0);
    const auto differences = shell(project, "diff -r whole parts\n");
    EXPECT_EQ(differences.code, 0) << differences.out;
}

TEST_F(CollapseRuns, HandsBlocksOverWithTheSameBytesOnAnyNumberOfThreads) {
    ASSERT_EQ(call(project, handing + "one --threads 1").code, 0);
    const config::Table falls = table_of(project, "one/tables/handed_falls.csv");
    ASSERT_GT(falls.rows(), 2U);
    ASSERT_GT(returns_before(falls, 1e9), 0U);
    for (const std::string threads : {"2", "4"}) {
        // Threads that wait must not take the time of those that work.
        ASSERT_EQ(shell(project, "OMP_WAIT_POLICY=passive \"$bannwald\" " + handing + "on_" + threads +
                                     " --threads " + threads + "\n")
                      .code,
                  0);
        const auto differences = shell(project, "diff -r one on_" + threads + "\n");
        EXPECT_EQ(differences.code, 0) << threads << " threads: " << differences.out;
    }
}

TEST_F(CollapseRuns, GoesOnWithHandedBlocksAfterItWasKilledWithTheSameBytes) {
    ASSERT_EQ(call(project, handing + "whole").code, 0);
    const config::Table falls = table_of(project, "whole/tables/handed_falls.csv");
    const config::Table energies = table_of(project, "whole/tables/energies.csv");
    ASSERT_GE(energies.rows(), 3U);
    ASSERT_LT(number_of(falls, 0, "handed_over_s"), number_of(energies, 1, "time_s"));
    ASSERT_GT(returns_before(falls, number_of(energies, 1, "time_s")), 0U) << "before the state is kept";
    ASSERT_GT(returns_before(falls, 1e9), returns_before(falls, number_of(energies, 1, "time_s"))) << "after";
    EXPECT_EQ(shell(project, interrupted_once("parts/parts/mass.part", handing + "parts", "KILL")).code, 137);
    ASSERT_EQ(call(project, handing + "parts").code, 0);
    const auto differences = shell(project, "diff -r whole parts\n");
    EXPECT_EQ(differences.code, 0) << differences.out;
}

TEST_F(CollapseRuns, ClosesTheLedgersOfTheMassAndOfTheBlocksThatItHandsOver) {
    ASSERT_EQ(call(project, handing + "out").code, 0);
    const config::Table energies = table_of(project, "out/tables/energies.csv");
    for (std::size_t row = 0; row < energies.rows(); ++row) {
        EXPECT_LE(std::abs(number_of(energies, row, "residual_percent")), 2.0);
    }
    const config::Table falls = table_of(project, "out/tables/handed_falls.csv");
    double motion_kj = 0.0, motion_end_kj = 0.0;
    for (std::size_t row = 0; row < falls.rows(); ++row) {
        motion_kj += number_of(falls, row, "motion_kj");
        const double given_kj = number_of(falls, row, "given_kj");
        EXPECT_LE(std::abs(number_of(falls, row, "residual_kj")), 0.01 * given_kj);
        const std::string_view end = falls.text(row, "end");
        if (end == "at_rest" || end == "on_way") {
            EXPECT_NEAR(given_kj + number_of(falls, row, "corrected_kj") -
                            number_of(falls, row, "dissipated_kj") - number_of(falls, row, "motion_end_kj"),
                        -number_of(falls, row, "residual_kj"), 0.004);  // of digits
        }
        motion_end_kj += falls.text(row, "returned_s").empty() ? 0.0 : number_of(falls, row, "motion_end_kj");
    }
    EXPECT_NEAR(number_of(energies, energies.rows() - 1, "handed_motion_mj"), 1e-3 * motion_kj,
                1e-6 * static_cast<double>(falls.rows() + 1));
    // What came back is what they had left, less what lifts out of the ground cost.
    const double back_kj = 1e3 * number_of(energies, energies.rows() - 1, "back_motion_mj");
    EXPECT_GT(back_kj, 0.8 * motion_end_kj);
    EXPECT_LT(back_kj, motion_end_kj + 0.01);
    EXPECT_EQ(number_of(energies, energies.rows() - 1, "back_strain_mj"), 0.0);
    std::size_t rigid = 0;
    const config::Table blocks = table_of(project, "out/tables/blocks.csv");
    for (std::size_t row = 0; row < blocks.rows(); ++row) {
        rigid += blocks.text(row, "model") == "rigid" ? 1 : 0;
    }
    EXPECT_EQ(rigid, falls.rows() - returns_before(falls, 1e9));
    EXPECT_NE(project.read("out/frames/blocks_00001.vtp").find("Name=\"single\""), std::string::npos);
    EXPECT_NE(project.read("out/summary.json").find("\"hand_over\""), std::string::npos);
}

/// The first columns of a grid.
std::string cut_grid(const std::string& grid, int columns) {
    std::istringstream in{grid};
    std::string line, cut;
    while (std::getline(in, line)) {
        if (line.starts_with("ncols")) {
            cut += "ncols " + std::to_string(columns) + "\n";
        } else if (std::isalpha(static_cast<unsigned char>(line.front())) != 0) {
            cut += line + "\n";
        } else {
            std::istringstream cells{line};
            std::string cell;
            for (int k = 0; k < columns && cells >> cell; ++k) {
                cut += cell + " ";
            }
            cut += "\n";
        }
    }
    return cut;
}

TEST_F(CollapseRuns, ClosesTheSumOfTheLedgersOfBlocksOfWhichSomeLeaveTheTerrain) {
    project.write("p/dem.asc", cut_grid(project.read("p/dem.asc"), 29));  // up to 40 m before the cliff
    ASSERT_EQ(call(project, handing + "out --set trees.file= --set targets.file=").code, 0);
    const config::Table falls = table_of(project, "out/tables/handed_falls.csv");
    std::size_t left = 0;
    for (std::size_t row = 0; row < falls.rows(); ++row) {
        left += falls.text(row, "end") == "left_terrain" && number_of(falls, row, "motion_end_kj") > 1.0;
    }
    ASSERT_GT(left, 0U);
    const auto sums = coupling::Json::parse(project.read("out/summary.json"))["hand_over"];
    const auto mj = [&](const char* name) { return sums.at(name).get<double>(); };
    EXPECT_GT(mj("motion_at_end_mj"), mj("motion_at_return_mj") + 1e-3);
    EXPECT_NEAR(mj("given_mj") + mj("corrected_mj"),
                mj("dissipated_mj") + mj("motion_at_end_mj") - mj("residual_mj"), 1e-7 * mj("given_mj"));
}

TEST_F(CollapseRuns, HasTheFramesOfItsSettingWhetherOrNotItHandsBlocksOver) {
    // Of four or five steps.
    const std::string rigid_set = " --set collapse.hand_over=rigid --set terrain.ground=coarse_debris";
    for (const std::string frame_s : {"0.01", "0.012"}) {
        const std::string frames = " --set collapse.duration_s=0.1 --set collapse.frame_s=" + frame_s;
        const std::string plain = "none_" + frame_s, handing_over = "rigid_" + frame_s;
        ASSERT_EQ(call(project, few + plain + frames).code, 0);
        ASSERT_EQ(call(project, few + handing_over + frames + rigid_set).code, 0);
        const config::Table none = table_of(project, plain + "/tables/energies.csv");
        const config::Table rigid = table_of(project, handing_over + "/tables/energies.csv");
        ASSERT_GT(none.rows(), 5U);
        ASSERT_EQ(rigid.rows(), none.rows());
        for (std::size_t row = 0; row < none.rows(); ++row) {
            EXPECT_EQ(rigid.text(row, "time_s"), none.text(row, "time_s"));
        }
    }
}

TEST_F(CollapseRuns, HasTheMeanDisplacementOfItsBlocks) {
    ASSERT_EQ(call(project, handing + "out").code, 0);
    const config::Table blocks = table_of(project, "out/tables/blocks.csv");
    double volume_m3 = 0.0;
    double sum = 0.0;
    for (std::size_t row = 0; row < blocks.rows(); ++row) {
        const auto way = [&](const std::string& axis) {
            return number_of(blocks, row, axis + "_m") - number_of(blocks, row, axis + "_start_m");
        };
        volume_m3 += number_of(blocks, row, "volume_m3");
        sum += number_of(blocks, row, "volume_m3") * std::hypot(way("x"), way("y"), way("z"));
    }
    const config::Table energies = table_of(project, "out/tables/energies.csv");
    double before_m = 0.0;
    for (std::size_t row = 0; row < energies.rows(); ++row) {
        EXPECT_GE(number_of(energies, row, "mean_displacement_m"), before_m) << "the mass comes down";
        before_m = number_of(energies, row, "mean_displacement_m");
    }
    ASSERT_GT(sum, 0.0);
    EXPECT_NEAR(before_m, sum / volume_m3, 0.02) << "places to hundredths of a metre";
}

TEST_F(CollapseRuns, HasEveryBlockOverTimeAndItsMean) {
    ASSERT_EQ(call(project,
                   "collapse p/scenario.ini --quiet --out out --set collapse.depth_m=8 "
                   "--set collapse.least_block_m=3 --set collapse.duration_s=4 "
                   "--set collapse.block_series=all --set \"collapse.picture_times_s=0 2.5 4\"")
                  .code,
              0);
    const config::Table series = table_of(project, "out/tables/block_series.csv");
    const config::Table energies = table_of(project, "out/tables/energies.csv");
    const config::Table mean = table_of(project, "out/tables/mean_block.csv");
    const config::Table blocks = table_of(project, "out/tables/blocks.csv");
    ASSERT_EQ(mean.rows(), energies.rows());
    ASSERT_EQ(series.rows(), energies.rows() * blocks.rows());
    const std::size_t frames = energies.rows();
    for (std::size_t frame = 0; frame < frames; ++frame) {
        double kinetic_kj = 0.0;
        double given_up_kj = 0.0;
        for (std::size_t block = 0; block < blocks.rows(); ++block) {
            kinetic_kj += number_of(series, block * frames + frame, "kinetic_kj");
            given_up_kj += number_of(series, block * frames + frame, "given_up_kj");
        }
        const auto number = static_cast<double>(blocks.rows());
        const double moves_mj =
            number_of(energies, frame, "translation_mj") + number_of(energies, frame, "rotation_mj");
        EXPECT_NEAR(1e-3 * kinetic_kj, moves_mj, 1e-4 * moves_mj + 1e-5 * number);
        EXPECT_NEAR(number_of(mean, frame, "kinetic_kj"), kinetic_kj / number,
                    1e-4 * kinetic_kj / number + 0.002);
        EXPECT_NEAR(number_of(mean, frame, "given_up_kj"), given_up_kj / number,
                    1e-4 * std::abs(given_up_kj) / number + 0.2);  // places are kept to tens of micrometres
        EXPECT_NEAR(number_of(mean, frame, "friction_kj") * number,
                    1e3 * number_of(energies, frame, "friction_mj"), 0.01 * number);
    }
    std::string chosen;
    for (std::size_t block = 0; block < blocks.rows(); ++block) {
        chosen += series.text(block * frames, "chosen") + " ";
    }
    for (const char* reason : {"fastest", "farthest", "median"}) {
        EXPECT_NE(chosen.find(reason), std::string::npos) << reason;
    }
    // Pictures at three times: maps of both fields, and both views from the side.
    for (const char* field : {"Speed_1", "Speed_2", "Speed_3", "Displacement_1", "Displacement_3"}) {
        EXPECT_TRUE(
            std::filesystem::exists(project.file("out/rasters/collapse/" + std::string{field} + ".asc")))
            << field;
    }
    EXPECT_FALSE(std::filesystem::exists(project.file("out/rasters/collapse/Speed_4.asc")));
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("Displacement after 2.5 s"), std::string::npos);
}

TEST_F(CollapseRuns, TellsWhatBlocksDidToAHouseBelowTheCliff) {
    project.write("p/house.csv", "target_id,name,wkt\nhouse,below the cliff,\"" +
                                     std::string{"POLYGON ((1085 2040, 1125 2040, 1125 2080, 1085 2080, "
                                                 "1085 2040))\"\n"});
    ASSERT_EQ(call(project,
                   "collapse p/scenario.ini --quiet --out out --set collapse.depth_m=8 "
                   "--set collapse.least_block_m=3 --set collapse.duration_s=6 "
                   "--set targets.file=house.csv")
                  .code,
              0);
    const config::Table buildings = table_of(project, "out/tables/collapse_buildings.csv");
    const config::Table walls = table_of(project, "out/tables/collapse_walls.csv");
    const config::Table targets = table_of(project, "out/tables/collapse_targets.csv");
    ASSERT_EQ(buildings.rows(), 1U);
    ASSERT_EQ(walls.rows(), 4U);
    EXPECT_NEAR(number_of(buildings, 0, "floor_m2"), 1600.0, 1e-6);
    EXPECT_GT(number_of(buildings, 0, "reached_m2"), 0.0);
    EXPECT_LE(number_of(buildings, 0, "reached_300_kj_m2"), number_of(buildings, 0, "reached_30_kj_m2"));
    EXPECT_LE(number_of(buildings, 0, "reached_30_kj_m2"), number_of(buildings, 0, "reached_m2"));
    double blocks = 0.0;
    double sum_mj = 0.0;
    for (std::size_t wall = 0; wall < 4; ++wall) {
        EXPECT_NEAR(number_of(walls, wall, "length_m"), 40.0, 1e-9);
        blocks += number_of(walls, wall, "blocks");
        sum_mj += number_of(walls, wall, "energy_sum_mj");
    }
    EXPECT_EQ(blocks, number_of(targets, 0, "blocks"));
    EXPECT_GT(blocks, 0.0);
    EXPECT_NEAR(sum_mj, number_of(targets, 0, "energy_sum_mj"), 3e-4);
    EXPECT_NE(project.read("out/report.html").find("Damage at buildings"), std::string::npos);
}

TEST_F(CollapseRuns, HandsNothingOverUnlessAsked) {
    ASSERT_EQ(call(project, few + "plain").code, 0);
    ASSERT_EQ(call(project, few + "none --set collapse.hand_over=none --set collapse.hand_over_after_s=0 "
                                  "--set terrain.ground=coarse_debris")
                  .code,
              0);
    const auto differences =
        shell(project, "diff -r plain/tables none/tables && diff -r plain/rasters none/rasters\n");
    EXPECT_EQ(differences.code, 0) << differences.out;
    EXPECT_EQ(project.read("plain/tables/blocks.csv").find("rigid"), std::string::npos);
}

TEST_F(CollapseRuns, WarnsWhereTheMassStillMovesAtTheEnd) {
    const std::string warning = "of the volume still moves";
    const auto early = call(project,
                            "collapse p/scenario.ini --quiet --out early --set collapse.depth_m=8 "
                            "--set collapse.least_block_m=3 --set collapse.duration_s=3");
    ASSERT_EQ(early.code, 0);
    EXPECT_NE(early.err.find(warning), std::string::npos) << early.err;
    EXPECT_NE(early.err.find("collapse.duration_s"), std::string::npos) << early.err;
    EXPECT_NE(project.read("early/report.html").find(warning), std::string::npos);
    EXPECT_NE(project.read("early/summary.json").find(warning), std::string::npos);
}

TEST_F(CollapseRuns, ComesToRestWithinTheTimeOfTheExample) {
    const auto whole = call(project, "collapse p/scenario.ini --quiet --out whole --threads 1");
    ASSERT_EQ(whole.code, 0);
    EXPECT_EQ(whole.err.find("still moves"), std::string::npos) << whole.err;
    const config::Table table = table_of(project, "whole/tables/energies.csv");
    // What the example promises of its step factor of 0.2.
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_LE(std::abs(number_of(table, row, "residual_percent")), 2.0);
    }
}

TEST_F(CollapseRuns, HasAThirdOfAPercentOfResidualWithAShortStep) {
    // The first seconds, with most of the breaking and the first impacts.
    ASSERT_EQ(call(project,
                   "collapse p/scenario.ini --quiet --out fine --threads 1 "
                   "--set collapse.duration_s=4 --set collapse.step_factor=0.05")
                  .code,
              0);
    const config::Table table = table_of(project, "fine/tables/energies.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_LE(std::abs(number_of(table, row, "residual_percent")), 0.3);
    }
}

TEST_F(CollapseRuns, ClosesItsLedger) {
    ASSERT_EQ(call(project, few + "out").code, 0);
    const config::Table table = table_of(project, "out/tables/energies.csv");
    ASSERT_GE(table.rows(), 4U);
    config::Problems problems;
    double fracture = 0.0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_LE(std::abs(table.number(row, "residual_percent", {}, problems).value_or(100.0)), 2.0);
        const double now = table.number(row, "fracture_mj", {}, problems).value_or(-1.0);
        EXPECT_GE(now, fracture);
        fracture = now;
    }
    EXPECT_LT(table.number(table.rows() - 1, "gravity_mj", {}, problems).value_or(0.0), 0.0);
}

TEST_F(CollapseRuns, GoesOnAfterAnInterruptionWithTheSameBytes) {
    ASSERT_EQ(call(project, few + "whole").code, 0);
    // A state on the disk comes with the interruption; at once there may be none yet, and the run begins
    // again.
    EXPECT_EQ(shell(project, interrupted_at_once(few + "parts")).code, 75);
    ASSERT_EQ(call(project, few + "parts").code, 0);
    EXPECT_EQ(project.read("whole/tables/energies.csv"), project.read("parts/tables/energies.csv"));
    EXPECT_EQ(project.read("whole/tables/blocks.csv"), project.read("parts/tables/blocks.csv"));
}

TEST_F(CollapseRuns, CheckTellsBlocksMemoryAndTime) {
    const auto result = call(project, "check p/scenario.ini");
    EXPECT_EQ(result.code, 0);
    for (const char* word : {"blocks", "bonds", "steps", "memory", "time"}) {
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
    }
}

TEST_F(CollapseRuns, WritesItsPageInTheLanguageOfTheScenario) {
    ASSERT_EQ(call(project, few + "german --set report.language=de").code, 0);
    const std::string page = project.read("german/report.html");
    EXPECT_NE(page.find("<html lang=\"de\""), std::string::npos);
    EXPECT_NE(page.find("Eine Felsmasse zerf"), std::string::npos);
}

}  // namespace
}  // namespace coupling::collapse_runs_test
