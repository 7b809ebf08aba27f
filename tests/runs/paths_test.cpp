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

}  // namespace
}  // namespace coupling::paths_test
