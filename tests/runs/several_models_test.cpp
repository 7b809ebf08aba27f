#include <gtest/gtest.h>

#include "tests/runs/program.hpp"

namespace coupling::several_models_test {
namespace {

constexpr const char* two_models = "run scenario.ini --set release.rocks=200 --motion picus,pir3d --out out";

TEST(RunOfSeveralModels, PutsThemSideBySideWithTheSameRocks) {
    const SampleProject project;
    const Outcome outcome = call(project, two_models);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = project.read("out/comparison/report.html");
    EXPECT_NE(page.find("Which model for what"), std::string::npos);
    EXPECT_NE(page.find("pir3d"), std::string::npos);
    EXPECT_EQ(page.find("Not comparable"), std::string::npos);
    EXPECT_NE(project.read("out/comparison/compare.csv").find("reached_bare"), std::string::npos);
    // As each of them alone.
    ASSERT_EQ(
        call(project, "run scenario.ini --set release.rocks=200 --set rockfall.motion=pir3d --out alone")
            .code,
        0);
    EXPECT_EQ(project.read("out/pir3d/tables/rocks.csv"), project.read("alone/tables/rocks.csv"));
}

TEST(RunOfSeveralModels, GoesOnWithWhatIsNotFinished) {
    const SampleProject project;
    ASSERT_EQ(call(project, two_models).code, 0);
    const Outcome again = call(project, two_models);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("picus: finished before"), std::string::npos) << again.out;
    EXPECT_NE(again.out.find("pir3d: finished before"), std::string::npos);
    // Other rocks are another run: its results are not taken for this one's.
    const Outcome other = call(project, std::string{two_models} + " --set release.rocks=100");
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("--overwrite"), std::string::npos) << other.err;
    ASSERT_EQ(call(project, std::string{two_models} + " --seed 2 --overwrite").code, 0);
}

}  // namespace
}  // namespace coupling::several_models_test
