// Trees that are derived have bounds: some rocks fall past the thinnest and the thickest forest, too.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "tests/runs/program.hpp"
#include "tests/runs/years.hpp"

namespace coupling::forest_bounds_runs_test {
namespace {

constexpr const char* run = "run scenario.ini --quiet --set release.rocks_per_source=500 ";

/// A stand of trees of which a laser scan knows the heights.
void write_tops(const SampleProject& project, const std::string& columns, const std::string& rest) {
    std::string rows = "x_m,y_m,species," + columns + "\n";
    for (int x = 1030; x < 1100; x += 5) {
        for (int y = 2005; y < 2100; y += 5) {
            rows += std::to_string(x) + "," + std::to_string(y) + ",PIAB," + rest + "\n";
        }
    }
    project.write("tops.csv", rows);
}

double value(const config::Table& bounds, std::size_t row, const char* column) {
    return std::stod(bounds.text(row, column));
}

TEST(ForestBounds, HoldTheFigureOfTheDerivedTrees) {
    const SampleProject project;
    write_tops(project, "height_m", "18");
    const Outcome outcome = call(project, std::string{run} + "--set trees.file=tops.csv --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("trees are taken from their tops: with diameters 30 % thinner"),
              std::string::npos)
        << outcome.err;
    const config::Table bounds = table(project, "out/tables/forest_bounds.csv");
    ASSERT_GE(bounds.rows(), 2U);  // road, perhaps house, all rocks
    EXPECT_EQ(bounds.text(0, "target_id"), "road");
    EXPECT_LT(value(bounds, 0, "thin"), value(bounds, 0, "derived"));
    EXPECT_GT(value(bounds, 0, "thick"), value(bounds, 0, "derived"));
    // The same figure as everywhere.
    const config::Table protection = table(project, "out/tables/protection.csv");
    EXPECT_EQ(bounds.text(0, "derived"), protection.text(0, "protection_percent"));
    const std::size_t last = bounds.rows() - 1;
    EXPECT_EQ(bounds.text(last, "quantity"), "run_out");
    EXPECT_GT(value(bounds, last, "thin"), value(bounds, last, "thick"));
}

TEST(ForestBounds, ChangeNothingElseAndAreTheSameOnAnyNumberOfThreads) {
    const SampleProject project;
    write_tops(project, "height_m", "18");
    const std::string tops = std::string{run} + "--set trees.file=tops.csv ";
    ASSERT_EQ(call(project, tops + "--threads 1 --out first").code, 0);
    const Outcome same =
        shell(project, "\"$bannwald\" " + tops + "--threads 3 --out second && diff -r first second\n");
    EXPECT_EQ(same.code, 0) << same.out << same.err;
    ASSERT_EQ(call(project, tops + "--set trees.bounds=no --out without").code, 0);
    const Outcome rest =
        shell(project,
              "test ! -e without/tables/forest_bounds.csv && diff -r -x forest_bounds.csv -x '*dictionary*' "
              "first/tables without/tables && diff -r first/rasters without/rasters\n");
    EXPECT_EQ(rest.code, 0) << rest.out << rest.err;
}

TEST(ForestBounds, AreThoseOfRecordsWhereTreesComeFromStands) {
    const SampleProject project;
    project.write("records.csv", "stand,species,stems_pha,basal_area_m2pha\n1,PIAB,600,35\n");
    const Outcome outcome =
        call(project, std::string{run} +
                          "--set trees.file= --set stands.records=records.csv --set stands.number=1 "
                          "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("trees are drawn from records: with 25 % fewer or more stems"),
              std::string::npos)
        << outcome.err;
}

TEST(ForestBounds, AreNotAskedForWhereTreesAreMapped) {
    const SampleProject project;
    write_tops(project, "dbh_cm,height_m", "25,18");
    const Outcome outcome = call(project, std::string{run} + "--set trees.file=tops.csv --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(project.read("out/tables/forest_bounds.csv"), "");
}

TEST(SpeciesOfTops, FollowSharesAndAreas) {
    const SampleProject project;
    write_tops(project, "height_m", "18");
    project.replace("tops.csv", "species,", "");
    std::string rows = project.read("tops.csv");
    for (std::size_t at = rows.find("PIAB,"); at != std::string::npos; at = rows.find("PIAB,")) {
        rows.erase(at, 5);
    }
    project.write("tops.csv", rows);
    project.write("areas.csv",
                  "species,wkt\nABAL,\"POLYGON((1000 2000,1060 2000,1060 2100,1000 2100,1000 2000))\"\n");
    const std::string tops =
        std::string{run} + "--set trees.file=tops.csv --set trees.species_areas=areas.csv ";
    const Outcome outcome = call(project, tops + "--set 'trees.species=PIAB 60, FASY 40' --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table trees = table(project, "out/tables/stems.csv");
    std::map<std::string, int> outside;
    for (std::size_t row = 0; row < trees.rows(); ++row) {
        if (std::stod(trees.text(row, "x_m")) < 1060.0) {
            EXPECT_EQ(trees.text(row, "species"), "ABAL");
        } else {
            ++outside[trees.text(row, "species")];
        }
    }
    // 8 columns of 19 trees; five standard deviations of a share of 60 %.
    EXPECT_EQ(outside["PIAB"] + outside["FASY"], 152);
    EXPECT_NEAR(outside["PIAB"], 91.2, 5.0 * std::sqrt(152 * 0.6 * 0.4));
    const Outcome without = call(project, tops + "--out none");
    EXPECT_EQ(without.code, 4) << without.err;
    EXPECT_NE(without.err.find("152 trees outside the areas of trees.species_areas"), std::string::npos)
        << without.err;
    const Outcome wrong = call(project, tops + "--set 'trees.species=PIAB 60, FASY 30' --out none");
    EXPECT_NE(wrong.err.find("shares that add up to 90"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace coupling::forest_bounds_runs_test
