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

/// The sample with a source point and points or contours instead of its grid.
void take_instead_of_dem(const SampleProject& project, const std::string& setting, const std::string& text) {
    project.write("heights.csv", text);
    project.write("source.csv", "wkt\nPOINT (1030 2050)\n");
    project.write("scenario.ini",
                  "[terrain]\n" + setting +
                      " = heights.csv\nground = fine_debris_and_soil\n[release]\nsource_shapes = "
                      "source.csv\nrocks = 10\ndiameter_m = 0.5\n");
}

std::string slope_points(double spacing_m) {
    std::string text;
    for (double x_m = 1000.0; x_m <= 1100.0; x_m += spacing_m) {
        for (double y_m = 2000.0; y_m <= 2100.0; y_m += spacing_m) {
            text += std::to_string(x_m) + " " + std::to_string(y_m) + " " +
                    std::to_string(400.0 - 0.7 * (x_m - 1000.0)) + "\n";
        }
    }
    return text;
}

TEST(GroundShare, RefusesALongestEdgeBelowTheSpacing) {
    const SampleProject project;
    take_instead_of_dem(project, "points", slope_points(10.0));
    EXPECT_TRUE(open(project).site) << open(project).errors;
    const Opened opened = open(project, {"terrain.longest_edge_m=5"});
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_NE(
        opened.errors.find("a terrain without a face: terrain.longest_edge_m is 5, the points lie about "),
        std::string::npos)
        << opened.errors;
}

TEST(GroundShare, WarnsOfSomeGapsAndRefusesMany) {
    const SampleProject project;
    // A gap that hangs together with the rim is no hole, but narrower than a border.
    project.write("dem.asc", slope_of([](int column, int row) { return column != 4 || row < 3; }));
    const Opened some = open(project);
    ASSERT_TRUE(some.site) << some.errors;
    EXPECT_NE(some.warnings.front().find("of the area inside the outline without ground"), std::string::npos)
        << some.warnings.front();
    project.write("dem.asc", slope_of([](int column, int row) { return (column + 2 * row) % 5 < 3; }));
    const Opened many = open(project);
    EXPECT_EQ(many.code, ExitCode::data);
    EXPECT_NE(many.errors.find("of the area inside the outline without ground"), std::string::npos)
        << many.errors;
}

TEST(GroundShare, IsSilentAboutAPartOfAGrid) {
    const SampleProject project;
    project.write("dem.asc", slope_of([](int column, int row) { return column < 8 || row > 4; }));
    project.write("targets.csv", "target_id,wkt\nroad,\"LINESTRING (1070 2010, 1070 2090)\"\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    for (const std::string& warning : opened.warnings) {
        EXPECT_EQ(warning.find("without ground"), std::string::npos) << warning;
    }
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
