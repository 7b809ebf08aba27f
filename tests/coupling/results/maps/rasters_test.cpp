#include "coupling/results/maps/rasters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "config/errors/input_error.hpp"
#include "config/grid/ascii_grid.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::rasters_test {
namespace {

using small_runs::SmallRun;
using small_runs::TestFolder;

constexpr config::Cell here{3, 4};

SmallRun two_rocks_here() {
    SmallRun run;
    run.pass(Cover::bare, here, 30000.0F, 10.0F, 0.5F);
    run.pass(Cover::bare, here, 90000.0F, 20.0F, 1.5F);
    run.pass(Cover::forest, here, 20000.0F, 8.0F, 0.25F);
    return run;
}

float value(const SmallRun& run, const char* stem, Cover cover = Cover::bare) {
    return raster_of(raster_kind(stem), run.results(), cover).at(here);
}

TEST(RasterOf, HoldsMeansAndExtremesInTheUnitsOfRockyfor3d) {
    const SmallRun run = two_rocks_here();
    EXPECT_FLOAT_EQ(value(run, "E_mean"), 60.0F);
    EXPECT_FLOAT_EQ(value(run, "E_max"), 90.0F);
    EXPECT_FLOAT_EQ(value(run, "V_mean"), 15.0F);
    EXPECT_FLOAT_EQ(value(run, "V_max"), 20.0F);
    EXPECT_FLOAT_EQ(value(run, "Ph_mean"), 1.0F);
    EXPECT_FLOAT_EQ(value(run, "Ph_max"), 1.5F);
    EXPECT_FLOAT_EQ(value(run, "Nr_passages"), 2.0F);
    EXPECT_FLOAT_EQ(value(run, "Nr_deposited"), 0.0F);
    EXPECT_FLOAT_EQ(value(run, "Nr_tree_impacts", Cover::forest), 1.0F);
    EXPECT_FLOAT_EQ(value(run, "Reach_probability"), 2.0F);
    EXPECT_NEAR(value(run, "EL_angles"), std::atan(0.75) * 180.0 / M_PI, 1e-4);
}

TEST(RasterOf, PercentilesLieWithinABinOfTheTruthAndNeverAboveTheMaximum) {
    SmallRun run;
    for (int i = 1; i <= 1000; ++i) {
        const auto size = static_cast<float>(i);
        run.pass(Cover::bare, here, 1000.0F * size, 0.02F * size, 0.005F * size);
    }
    // 16 bins to a doubling, straight inside a bin: at most 6.3 % off.
    EXPECT_NEAR(value(run, "E_50"), 500.0, 0.063 * 500.0);
    EXPECT_NEAR(value(run, "E_95"), 950.0, 0.063 * 950.0);
    EXPECT_NEAR(value(run, "V_90"), 18.0, 0.063 * 18.0);
    EXPECT_NEAR(value(run, "Ph_98"), 4.9, 0.063 * 4.9);
    for (const char* quantity : {"E", "V", "Ph"}) {
        float last = 0.0F;
        for (const char* figure : {"50", "90", "95", "98", "99", "max"}) {
            const float now = value(run, (std::string{quantity} + "_" + figure).c_str());
            EXPECT_GE(now, last) << quantity << '_' << figure;
            last = now;
        }
    }
}

TEST(RasterOf, IsEmptyWhereNoRockPassed) {
    const SmallRun run = two_rocks_here();
    for (const RasterKind& kind : raster_kinds()) {
        const config::Raster<float> raster = raster_of(kind, run.results(), Cover::bare);
        for (std::size_t i = 0; i < raster.values.size(); ++i) {
            EXPECT_EQ(std::isnan(raster.values[i]), i != raster.frame.index(here)) << kind.stem;
        }
    }
}

TEST(RasterOf, LiesOnTheMapFrameInAbsoluteCoordinates) {
    const SmallRun run = two_rocks_here();
    EXPECT_EQ(raster_of(raster_kind("E_max"), run.results(), Cover::bare).frame, run.site.map_frame);
}

TEST(ReachProbability, NeverExceedsAHundredPercent) {
    SmallRun run;
    for (int rock = 0; rock < 100; ++rock) {
        run.pass(Cover::bare, here, 1000.0F, 5.0F, 0.1F);
    }
    EXPECT_FLOAT_EQ(value(run, "Reach_probability"), 100.0F);
    run.tally.cells[index_of(Cover::bare)].cells[run.site.map_frame.index(here)].fed_rocks = 50;
    EXPECT_FLOAT_EQ(value(run, "Reach_probability"), 100.0F);
}

TEST(Density, IsTheShareOfAllRocks) {
    SmallRun run = two_rocks_here();
    run.rocks = 40;
    const RunResults results = run.results();
    for (const Cover cover : {Cover::forest, Cover::bare}) {
        EXPECT_FLOAT_EQ(value(run, "Density", cover),
                        100.0F * value(run, "Nr_passages", cover) / static_cast<float>(results.rocks));
    }
    EXPECT_FLOAT_EQ(difference_of(raster_kind("Density"), results).at(here),
                    -100.0F / static_cast<float>(results.rocks));
}

TEST(EnergyLineAngles, AreUnknownWhereARockHasNotYetMovedInPlan) {
    SmallRun run = two_rocks_here();
    run.tally.cells[index_of(Cover::bare)].cells[run.site.map_frame.index(here)].energy_line_slope_min =
        std::numeric_limits<float>::infinity();
    EXPECT_TRUE(std::isnan(value(run, "EL_angles")));
}

TEST(DifferenceOf, IsForestMinusBare) {
    const SmallRun run = two_rocks_here();
    EXPECT_FLOAT_EQ(difference_of(raster_kind("E_max"), run.results()).at(here), -70.0F);
    EXPECT_FLOAT_EQ(difference_of(raster_kind("Nr_passages"), run.results()).at(here), -1.0F);
}

TEST(DifferenceOf, CountsNoRockAsNoEnergy) {
    SmallRun run = two_rocks_here();
    run.pass(Cover::bare, {0, 0}, 40000.0F, 10.0F, 1.0F);
    run.pass(Cover::forest, {1, 0}, 50000.0F, 10.0F, 1.0F);
    const config::Raster<float> difference = difference_of(raster_kind("E_95"), run.results());
    EXPECT_FLOAT_EQ(difference.at({0, 0}), -40.0F);
    EXPECT_FLOAT_EQ(difference.at({1, 0}), 50.0F);
    EXPECT_TRUE(std::isnan(difference.at({2, 0})));
}

TEST(DifferenceOf, TakesReachProbabilitiesAsSharesOfTheSameRocks) {
    // One rock less passes with forest, but from half the sources: its reach probability rises, its effect
    // must not.
    SmallRun run = two_rocks_here();
    const std::size_t cell = run.site.map_frame.index(here);
    run.tally.cells[index_of(Cover::forest)].cells[cell].fed_rocks = 25;
    EXPECT_GT(value(run, "Reach_probability", Cover::forest), value(run, "Reach_probability", Cover::bare));
    EXPECT_FLOAT_EQ(difference_of(raster_kind("Reach_probability"), run.results()).at(here), -1.0F);
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

TEST(WriteRasters, WritesEveryNameOfRockyfor3dWithProjectionAndStyle) {
    const SmallRun run = two_rocks_here();
    const TestFolder folder;
    write_rasters(run.results(), folder.path());
    const std::vector<std::string> names = names_in(folder.path() / "rasters/forest");
    for (const char* stem : {"E_mean", "E_50", "E_90", "E_95", "E_98", "E_99", "E_max", "V_mean", "V_max",
                             "Ph_mean", "Ph_50", "Ph_90", "Ph_99", "Ph_max", "Nr_passages", "Nr_deposited",
                             "Nr_tree_impacts", "Reach_probability", "EL_angles"}) {
        for (const char* ending : {".asc", ".prj", ".qml"}) {
            EXPECT_TRUE(std::binary_search(names.begin(), names.end(), std::string{stem} + ending))
                << stem << ending;
        }
    }
    for (const char* stem :
         {"E_95", "E_mean", "E_max", "V_max", "Ph_95", "Reach_probability", "Nr_passages"}) {
        EXPECT_TRUE(
            std::filesystem::exists(folder.path() / "rasters/difference" / (std::string{stem} + ".asc")))
            << stem;
    }
}

TEST(WriteRasters, ReadBackAreTheSameNumbers) {
    const SmallRun run = two_rocks_here();
    const TestFolder folder;
    write_rasters(run.results(), folder.path());
    const std::string text = small_runs::text_of(folder.path() / "rasters/bare/E_mean.asc");
    EXPECT_NE(text.find("NODATA_value -9999"), std::string::npos);
    const config::Raster<double> read = config::read_ascii_grid(text, "E_mean.asc");
    EXPECT_TRUE(config::same_place(read.frame, run.site.map_frame));
    EXPECT_EQ(read.at(here), 60.0);
    EXPECT_TRUE(std::isnan(read.at({0, 0})));
}

TEST(WriteRasters, WritesNoPercentilesWithoutDistributionsAndNoForestWithoutTrees) {
    SmallRun run = two_rocks_here();
    run.with_forest = false;
    run.histograms[1].reset();
    const TestFolder folder;
    write_rasters(run.results(), folder.path());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "rasters/bare/E_mean.asc"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "rasters/bare/E_95.asc"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "rasters/forest"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "rasters/difference"));
}

TEST(WriteRasters, WritesNoProjectionWhereTheDemHasNone) {
    SmallRun run = two_rocks_here();
    run.site.projection.clear();
    const TestFolder folder;
    write_rasters(run.results(), folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "rasters/bare/E_mean.prj"));
}

TEST(WriteRasters, AreReadByGdalWithTheRightProjection) {
    const SmallRun run = two_rocks_here();
    const TestFolder folder;
    write_rasters(run.results(), folder.path());
    const std::string said = small_runs::gdalinfo(folder.path() / "rasters/bare/E_95.asc");
    if (said.empty()) {
        GTEST_SKIP() << "gdalinfo is not installed";
    }
    EXPECT_NE(said.find("Size is 8, 8"), std::string::npos) << said;
    EXPECT_NE(said.find("Austria Lambert"), std::string::npos) << said;
    EXPECT_NE(said.find("Pixel Size = (10.0"), std::string::npos) << said;
    EXPECT_NE(said.find("Origin = (177000.0"), std::string::npos) << said;
    EXPECT_NE(said.find("NoData Value=-9999"), std::string::npos) << said;
}

TEST(WriteRasters, TellsWhichFileCannotBeWritten) {
    const SmallRun run = two_rocks_here();
    const TestFolder folder;
    std::filesystem::create_directories(folder.path() /
                                        "rasters/forest/E_mean.asc");  // a folder in its place
    try {
        write_rasters(run.results(), folder.path());
        FAIL() << "written";
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("E_mean.asc"), std::string::npos);
    }
}

}  // namespace
}  // namespace coupling::rasters_test
