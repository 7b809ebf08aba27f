#include "coupling/inputs/terrain/ground_share.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::plausible::ground_share_test {
namespace {

using config::ExitCode;

/// The even slope of the sample, of which only the cells that `is_known` names are known.
template <class IsKnown>
std::string slope_of(IsKnown is_known) {
    return SampleProject::header() + SampleProject::rows([&](int column, int row) {
               return is_known(column, row) ? std::to_string(400 - 7 * column) : std::string{"-9999"};
           });
}

TEST(GroundShare, OfAnyCheckerboardIsASoundTerrainOrAnError) {
    std::mt19937 random{11};
    int refused = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const double known = std::generate_canonical<double, 32>(random);
        const SampleProject project;
        project.write("dem.asc", slope_of([&](int, int) {
                          return std::generate_canonical<double, 32>(random) < known;
                      }));
        project.write("source.csv", "wkt\nPOINT (1030 2050)\n");
        project.replace("scenario.ini", "source = source.asc", "source_shapes = source.csv");
        const Opened opened = open(project);
        EXPECT_TRUE(opened.site || opened.code == ExitCode::data) << opened.errors;
        EXPECT_TRUE(!opened.site || !opened.site->slope.terrain.triangles().empty());
        refused += opened.site ? 0 : 1;
    }
    EXPECT_GT(refused, 20);
    EXPECT_LT(refused, 60);
}

}  // namespace
}  // namespace coupling::plausible::ground_share_test
