#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::paths_test {
namespace {

TEST(Paths, OfRocksThatTheUserNamesAreKept) {
    const SampleProject project;
    const Outcome outcome = call(project,
                                 "run scenario.ini --quiet --set output.sample_paths=0 --set "
                                 "\"output.path_rocks=11, 3\" --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table corners = table(project, "out/tables/trajectories.csv");
    std::set<std::string> kept;
    for (std::size_t row = 0; row < corners.rows(); ++row) {
        kept.insert(corners.text(row, "rock") + " " + corners.text(row, "cover"));
    }
    EXPECT_EQ(kept, (std::set<std::string>{"11 bare", "11 forest", "3 bare", "3 forest"}));
    EXPECT_NE(project.read("out/report.html").find("rock 11: output.path_rocks"), std::string::npos);
}

TEST(Paths, OfRocksThatThereAreNotAreRefused) {
    const SampleProject project;
    const Outcome outcome = call(project, "run scenario.ini --quiet --set output.path_rocks=20 --out out");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("found rock 20, expected rocks from 0 to 19"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("out")));
    EXPECT_EQ(call(project, "run scenario.ini --quiet --set output.path_rocks=1.5 --out out").code, 2);
}

}  // namespace
}  // namespace coupling::paths_test
