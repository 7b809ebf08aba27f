#include "coupling/inputs/forest/tops/canopy_input.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::canopy_input_test {
namespace {

const std::vector<std::string> of_canopy{"trees.file=", "trees.canopy=chm.asc", "trees.species=PIAB"};

struct Cone {
    double x_m;
    double y_m;
    double height_m;
};

const std::vector<Cone> cones{{1030.5, 2040.5, 12.0}, {1050.5, 2060.5, 24.0}, {1080.5, 2030.5, 31.0}};

/// Cones of 3 m radius in cells of 1 m; all heights times `factor`, and `added` to them.
std::string canopy_of(const std::vector<Cone>& trees, double factor = 1.0, double added = 0.0, int west = 990,
                      int south = 1990, int columns = 140, int rows = 120) {
    std::ostringstream text;
    text << "ncols " << columns << "\nnrows " << rows << "\nxllcorner " << west << "\nyllcorner " << south
         << "\ncellsize 1\nNODATA_value -9999\n";
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            double height_m = 0.0;
            for (const Cone& tree : trees) {
                const double distance_m =
                    std::hypot(west + column + 0.5 - tree.x_m, south + rows - row - 0.5 - tree.y_m);
                height_m =
                    std::max(height_m, distance_m < 3.0 ? tree.height_m * (1.0 - 0.2 * distance_m) : 0.0);
            }
            text << (column > 0 ? " " : "") << factor * height_m + added;
        }
        text << '\n';
    }
    return text.str();
}

Opened with_canopy(const std::string& text, const std::vector<std::string>& more = {}) {
    const SampleProject project;
    project.write("chm.asc", text);
    std::vector<std::string> settings = of_canopy;
    settings.insert(settings.end(), more.begin(), more.end());
    return open(project, settings);
}

bool says(const Opened& opened, const std::string& part) {
    return std::any_of(opened.warnings.begin(), opened.warnings.end(),
                       [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
}

void expect_refused(const Opened& opened, const std::vector<std::string>& parts) {
    EXPECT_FALSE(opened.site);
    for (const std::string& part : parts) {
        EXPECT_NE(opened.errors.find(part), std::string::npos) << part << " in " << opened.errors;
    }
}

TEST(TreesOfACanopy, StandAtItsTopsWithDiametersByHeight) {
    const Opened opened = with_canopy(canopy_of(cones));
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->trees.size(), cones.size());
    for (const Cone& cone : cones) {
        const auto tree = std::find_if(
            opened.site->trees.begin(), opened.site->trees.end(),
            [&](const TreeRecord& one) { return one.stem.x_m == cone.x_m && one.stem.y_m == cone.y_m; });
        ASSERT_NE(tree, opened.site->trees.end());
        EXPECT_EQ(tree->stem.height_m, cone.height_m);
        EXPECT_EQ(tree->species, "PIAB");
        EXPECT_TRUE(tree->has_derived_dbh);
        // Within four standard deviations of the law.
        EXPECT_LT(std::abs(std::log(tree->stem.dbh_cm / (1.28 * std::pow(cone.height_m, 1.085)))), 0.96);
    }
    EXPECT_TRUE(says(opened, "chm.asc: found 3 tree tops of 5 m and more, taken from a canopy raster"));
    EXPECT_TRUE(says(opened, "trees below the crowns of others and most small ones are missing"));
    EXPECT_TRUE(says(opened, "chm.asc: found 3 trees without dbh_cm"));
}

TEST(TreesOfACanopy, HaveTheirDiametersWhereverTheRasterBegins) {
    const Opened whole = with_canopy(canopy_of(cones));
    const Opened part = with_canopy(canopy_of(cones, 1.0, 0.0, 1040, 2010, 80, 60));
    ASSERT_TRUE(whole.site && part.site) << whole.errors << part.errors;
    ASSERT_EQ(part.site->trees.size(), 2U);
    for (const TreeRecord& tree : part.site->trees) {
        EXPECT_TRUE(
            std::any_of(whole.site->trees.begin(), whole.site->trees.end(), [&](const TreeRecord& other) {
                return other.stem.x_m == tree.stem.x_m && other.stem.dbh_cm == tree.stem.dbh_cm;
            }));
    }
}

TEST(TreesOfACanopy, BeyondTheTerrainAreLeftOutWithANote) {
    std::vector<Cone> more = cones;
    more.push_back({993.5, 2050.5, 20.0});
    const Opened opened = with_canopy(canopy_of(more));
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->trees.size(), cones.size());
    EXPECT_TRUE(says(opened, "chm.asc: 1 tree top beyond the terrain left out"));
    EXPECT_FALSE(with_canopy(canopy_of({{993.5, 2050.5, 20.0}})).site);  // none on it: another place
}

TEST(TreesOfACanopy, AreFoundAcrossSmallHolesAndNotBesideLargeOnes) {
    std::string small = canopy_of(cones);
    const std::size_t tip = small.find(" 24 ");
    ASSERT_NE(tip, std::string::npos);
    small.replace(tip, 4, " -9999 ");
    const Opened filled = with_canopy(small);
    ASSERT_TRUE(filled.site) << filled.errors;
    EXPECT_EQ(filled.site->trees.size(), cones.size());
    EXPECT_TRUE(says(filled, "chm.asc: 1 hole of at most 4 m2 filled from around it"));
    // All of the open ground unknown.
    std::string masked = canopy_of(cones);
    for (std::size_t at = masked.find(" 0"); at != std::string::npos; at = masked.find(" 0", at + 2)) {
        if (masked[at + 2] == ' ' || masked[at + 2] == '\n') {
            masked.replace(at, 2, " -9999");
        }
    }
    const Opened open_ground = with_canopy(masked);
    ASSERT_TRUE(open_ground.site) << open_ground.errors;
    EXPECT_EQ(open_ground.site->trees.size(), cones.size());
}

TEST(TreesOfACanopy, NeedHeightsAboveTheGroundInMetres) {
    expect_refused(with_canopy(canopy_of(cones, 10.0)),
                   {"heights up to", "another unit", "decimetres by 10"});
    expect_refused(with_canopy(canopy_of(cones, 100.0)), {"another unit", "centimetres by 100"});
    expect_refused(with_canopy(canopy_of(cones, 1.0, 800.0)),
                   {"heights from 800 to", "heights above sea", "subtract the terrain"});
    expect_refused(with_canopy(canopy_of(cones, 1.0 / 40.0)), {"crown cover in shares", "stands.cover"});
    EXPECT_TRUE(with_canopy(canopy_of(cones, 2.0)).site);  // 62 m
}

TEST(TreesOfACanopy, NeedCellsOfCrowns) {
    const SampleProject project;
    project.write("chm.asc",
                  SampleProject::header() + SampleProject::rows([](int, int) { return std::string{"20"}; }));
    const Opened opened = open(project, of_canopy);
    expect_refused(opened, {"cells of 10 m", "cells of 2 m or less", "stands.records"});
}

TEST(TreesOfACanopy, NeedASpeciesAndNoList) {
    const SampleProject project;
    project.write("chm.asc", canopy_of(cones));
    expect_refused(open(project, {"trees.canopy=chm.asc", "trees.species=PIAB"}),
                   {"trees.canopy beside trees.file"});
    expect_refused(open(project, {"trees.file=", "trees.canopy=chm.asc"}),
                   {"trees.canopy without trees.species", "trees.species = PIAB"});
}

TEST(TreesOfACanopy, AreWarnedOfWhereHeightsAreOdd) {
    std::string line = canopy_of(cones);
    line.replace(line.find(" 0 0 0 "), 7, " 0 95 0 ");
    EXPECT_TRUE(says(with_canopy(line), "1 cell above 70 m, taken as unknown"));
    EXPECT_TRUE(says(with_canopy(canopy_of({{1050.5, 2050.5, 3.0}})), "found no tree tops"));
    EXPECT_TRUE(says(with_canopy(canopy_of(cones, 1.0, -3.0)), "more than 2 m below the ground"));
    std::string whole = canopy_of({});
    whole.replace(whole.find(" 0 0 0 "), 7, " 0 9 0 ");
    EXPECT_TRUE(says(with_canopy(whole), "heights in whole metres"));
    std::string wide = canopy_of(cones);
    wide.replace(wide.find("cellsize 1\n"), 11, "cellsize 1.5\n");
    EXPECT_TRUE(says(with_canopy(wide), "found cells of 1.5 m, expected cells of 1 m or less"));
}

TEST(TreesOfACanopy, MayHaveAWiderWindowAndAnotherLeastHeight) {
    const std::vector<Cone> pair{{1050.5, 2050.5, 30.0}, {1054.5, 2050.5, 29.0}};  // 3 m and 5.3 m
    EXPECT_EQ(with_canopy(canopy_of(pair)).site->trees.size(), 2U);
    EXPECT_EQ(with_canopy(canopy_of(pair), {"trees.canopy_window=popescu"}).site->trees.size(), 1U);
    EXPECT_EQ(with_canopy(canopy_of(cones), {"trees.canopy_least_height_m=20"}).site->trees.size(), 2U);
}

TEST(TreesOfACanopy, GrowInARunOverYears) {
    const ForestProject project;
    project.write("chm.asc", canopy_of(cones));
    const Opened opened = open(project, of_canopy);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->listed.size() + opened.site->forest->obstacles.size(), cones.size());
    EXPECT_FALSE(says(opened, "begins on bare ground"));
}

}  // namespace
}  // namespace coupling::canopy_input_test
