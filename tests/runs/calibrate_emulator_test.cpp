#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/runs/calibrations.hpp"

namespace coupling::calibrate_emulator_test {
namespace {

/// Stops of rocks that fell with known factors.
class SeenSlope : public SampleProject {
public:
    SeenSlope() {
        simulate_truth(*this, "", "set,weight,losses,stopping\n1,1,1.5,0.3\n");
        write_stops(*this, "");
        write("scenario.ini", read("scenario.ini") + "[observed]\nstops = stops.csv\n");
    }
};

const std::string with = few_sets + "--set calibrate.emulator=yes ";

const std::vector<std::string> losses_on_soil{"losses", "losses_on.3"};

TEST(CalibrationsWithEmulators, FindWhatThoseWithoutThemFind) {
    const SeenSlope project;
    const Outcome outcome = call(project, "calibrate scenario.ini --out with " + with);
    ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("of what the widths allow was ruled out"), std::string::npos) << outcome.out;
    const std::string more = few_sets + "--set calibrate.sets=400 --set calibrate.most_sets=4000 ";
    ASSERT_EQ(call(project, "calibrate scenario.ini --out without " + more).code, 0);
    const config::Table sample = written_table(project, "with/tables/posterior.csv");
    EXPECT_GE(sample.rows(), 60U);
    const Logarithm found = logarithm_of(sample, losses_on_soil);
    const Logarithm known =
        logarithm_of(written_table(project, "without/tables/posterior.csv"), losses_on_soil);
    EXPECT_NEAR(found.mean, known.mean, 4.0 * std::hypot(found.error, known.error));
    EXPECT_LT(found.error, 0.1) << "says nothing";
    const config::Table ruled_out = written_table(project, "with/tables/ruled_out.csv");
    ASSERT_EQ(ruled_out.rows(), 2U) << "stops and run-outs";
    EXPECT_GT(std::stod(ruled_out.text(1, "explained")), 0.0);
    EXPECT_NE(project.read("with/report.html").find("What was not simulated"), std::string::npos);
    EXPECT_NE(project.read("with/summary.json").find("\"beyond_kept\""), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(project.file("without/tables/ruled_out.csv")));
    EXPECT_EQ(project.read("without/report.html").find("What was not simulated"), std::string::npos);
}

TEST(CalibrationsWithEmulators, AreTheSameBytesOnAnyNumberOfThreadsAndAfterAnInterruption) {
    const SeenSlope project;
    const std::string slow = with + "--set calibrate.rocks=400 --set calibrate.sets=150 ";
    ASSERT_EQ(call(project, "calibrate scenario.ini --threads 1 --out whole " + slow).code, 0);
    const Outcome stopped =
        shell(project, interrupted_for_certain("parts", "parts/parts/search.part",
                                               "calibrate scenario.ini --out parts " + slow));
    ASSERT_EQ(stopped.code, 75) << stopped.err;
    const Outcome outcome = shell(project, "\"$bannwald\" calibrate scenario.ini --threads 3 --out parts " +
                                               slow + "&& diff -r -x .bannwald whole parts\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(CalibrationsWithEmulators, AreNotMadeOfFastModelsUnasked) {
    const SeenSlope project;
    const std::string tiny =
        "--set calibrate.sets=50 --set calibrate.first_sets=64 --set calibrate.most_sets=64 "
        "--set calibrate.rocks=50 ";
    ASSERT_EQ(call(project, "calibrate scenario.ini --out picus " + tiny).code, 0);
    EXPECT_FALSE(std::filesystem::exists(project.file("picus/tables/ruled_out.csv")));
    ASSERT_EQ(call(project, "calibrate scenario.ini --out asked --set calibrate.emulator=yes " + tiny).code,
              0);
    EXPECT_TRUE(std::filesystem::exists(project.file("asked/tables/ruled_out.csv")));
}

}  // namespace
}  // namespace coupling::calibrate_emulator_test
