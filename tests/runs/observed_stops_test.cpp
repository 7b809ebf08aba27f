// Stops that were observed in the field, through the program.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/coupling/inputs/sample_project.hpp"
#include "tests/runs/program.hpp"

namespace coupling::observed_stops_test {
namespace {

const std::string with_stops = "run scenario.ini --quiet --set observed.stops=stops.csv ";

TEST(ObservedStops, StandBesideTheSimulatedOnes) {
    const SampleProject project;
    project.write("stops.csv",
                  "x_m,y_m,zone,group,x_release_m,y_release_m\n"
                  "1100,2050,1,round,1025,2050\n1090,2045,1,round,1025,2045\n1060,2055,1,plate,1025,2055\n");
    const Outcome run = call(project, with_stops + "--out out");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string table = project.read("out/tables/observed_stops.csv");
    // Mean of 75, 65 and 35 m; standard deviation with n - 1.
    EXPECT_NE(table.find("all,observed,3,58.33,20.82,"), std::string::npos) << table;
    EXPECT_NE(table.find("plate,observed,1,35.00,,35.00,"), std::string::npos) << table;
    EXPECT_NE(table.find("all,simulated,20,"), std::string::npos) << table;
    EXPECT_NE(project.read("out/summary.json").find("\"observed_stops\""), std::string::npos);
    EXPECT_NE(project.read("out/report.html").find("Observed and simulated stops"), std::string::npos);
    EXPECT_NE(project.read("out/tables/data_dictionary.csv").find("observed_stops.csv,"), std::string::npos);

    ASSERT_EQ(call(project, "run scenario.ini --quiet --out without").code, 0);
    EXPECT_EQ(project.read("out/tables/rocks.csv"), project.read("without/tables/rocks.csv"))
        << "what was observed changes no rock";
}

TEST(ObservedEvents, StandBesideTheSimulatedOnes) {
    const SampleProject project;
    project.write("passages.csv",
                  "target_id,speed_mps,height_m,group\nroad,8.5,0.2,a\nroad,11.5,,b\nroad,,,b\n");
    project.write("impacts.csv", "speed_in_mps,speed_out_mps,angle_out_deg,ground\n9,6,14,3\n7,5.6,22,3\n");
    const std::string with_events =
        "run scenario.ini --quiet --set observed.passages=passages.csv --set observed.impacts=impacts.csv "
        "--set observed.rocks=12 ";
    const Outcome run = call(project, with_events + "--out out");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string table = project.read("out/tables/observed_events.csv");
    EXPECT_NE(table.find("passage,road,all,speed_mps,m/s,observed,2,10.0000,2.1213,"), std::string::npos)
        << table;
    EXPECT_NE(table.find("passage,road,all,passing_share,-,observed,3,0.2500,"), std::string::npos) << table;
    EXPECT_NE(table.find("impact,,all,speed_ratio,-,observed,2,0.7333,"), std::string::npos) << table;
    EXPECT_NE(table.find("impact,,all,speed_ratio,-,simulated,"), std::string::npos) << table;
    EXPECT_NE(project.read("out/report.html").find("Observed and simulated passages and impacts"),
              std::string::npos);
    EXPECT_NE(project.read("out/summary.json").find("\"passage.speed_mps:road\""), std::string::npos);
    // The simulated share is that of the rows of arrivals.csv.
    std::istringstream arrivals{project.read("out/tables/arrivals.csv")};
    std::size_t at_road = 0;
    for (std::string line; std::getline(arrivals, line);) {
        at_road += line.find(",road,forest,") != std::string::npos ? 1 : 0;
    }
    EXPECT_NE(table.find("passing_share,-,simulated," + std::to_string(at_road) + ","), std::string::npos)
        << table;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --out without").code, 0);
    EXPECT_EQ(project.read("out/tables/rocks.csv"), project.read("without/tables/rocks.csv"));
}

TEST(Repeats, AreMappedAsShares) {
    const SampleProject project;
    const Outcome run = call(project, "run scenario.ini --quiet --set output.repeats=5 --out out");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string grid = project.read("out/rasters/bare/Reached_in_repeats.asc");
    EXPECT_NE(grid.find("100"), std::string::npos) << grid;
    EXPECT_NE(project.read("out/tables/raster_dictionary.csv").find("Reached_in_repeats"), std::string::npos);
    const Outcome few = call(project, "run scenario.ini --quiet --set output.repeats=6 --out few");
    EXPECT_EQ(few.code, 2);
    EXPECT_NE(few.err.find("output.repeats 6 with release.rocks_per_source 5"), std::string::npos) << few.err;
}

TEST(ObservedStops, AreTheSameFromALayerOfPoints) {
    const SampleProject project;
    project.write("stops.csv", "x_m,y_m\n1100,2050\n1090,2045\n");
    ASSERT_EQ(call(project, with_stops + "--out by_columns").code, 0);
    project.write("stops.csv", "wkt\nPOINT (1100 2050)\nPOINT (1090 2045)\n");
    ASSERT_EQ(call(project, with_stops + "--out by_points").code, 0);
    EXPECT_EQ(project.read("by_columns/tables/observed_stops.csv"),
              project.read("by_points/tables/observed_stops.csv"));
}

TEST(ObservedStops, ShowInACaseOfTheirOwnForEachMotionModel) {
    const SampleProject project;
    project.write("stops.csv", "x_m,y_m,zone\n1100,2050,1\n1090,2045,1\n1060,2055,1\n");
    project.write("scenario.ini", project.read("scenario.ini") + "[observed]\nstops = stops.csv\n");
    project.write("case.ini", "[case]\ntitle = a meadow\nkind = field\n");
    project.write("criteria.csv",
                  "quantity,low,high,rests_on,rule\nrun_out_mean_m,0,500,independent,any\n"
                  "pir3d.ks,0,1,independent,any\n");
    const Outcome run = call(project, "validate --cases . --quiet --out results");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string verdicts = project.read("results/verdicts.csv");
    EXPECT_NE(verdicts.find("run_out_mean_m"), std::string::npos) << verdicts;
    EXPECT_NE(verdicts.find("pir3d.ks"), std::string::npos) << verdicts;
    const std::string page = project.read("results/report.html");
    for (const char* model : {"picus", "pir3d", "classical"}) {
        EXPECT_NE(page.find(model), std::string::npos) << model;
    }

    const Outcome slower = call(project, "validate --cases . --quiet --out slower --set ground.3.r_t=0.3");
    ASSERT_EQ(slower.code, 0) << slower.err;
    EXPECT_NE(project.read("slower/verdicts.csv"), verdicts) << "settings reach the scenario";

    project.replace("scenario.ini", "[observed]\nstops = stops.csv\n", "");
    const Outcome without = call(project, "validate --cases . --quiet --out nothing");
    EXPECT_EQ(without.code, 2);
    EXPECT_NE(without.err.find(
                  "found neither observed.stops nor observed.passages nor observed.impacts, expected a "
                  "table of what was observed"),
              std::string::npos)
        << without.err;
}

}  // namespace
}  // namespace coupling::observed_stops_test
