// What the start of a run over years holds: dead wood and young trees of an inventory, a list beside records.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::start_test {
namespace {

constexpr const char* inventoried =
    "run scenario.ini --quiet --set trees.file= --set stands.records=records.csv --set run.replicates=2 "
    "--set run.rockfall_every=0 --set regimes.list=none ";

/// The mean of a column at the start over replicates.
double at_start(const config::Table& years, const std::string& column) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t row = 0; row < years.rows(); ++row) {
        if (years.text(row, "year") == "0") {
            sum += number(years, row, column);
            count += 1.0;
        }
    }
    return sum / count;
}

TEST(Start, HoldsTheDeadWoodAndSaplingsOfTheInventory) {
    const ForestProject project;
    project.write("deadwood.csv",
                  "stand,species,kind,volume_m3pha,dbh_cm,length_m,decay_class,log_angle_deg\n"
                  "7,PIAB,snag,30,20,,2,\nall,PIAB,log,50,20,6,3,70\n8,FASY,stump,2,30,0.4,1,\n");
    project.write("saplings.csv", "stand,species,height_m,stems_pha,age_years\nall,ABAL,0.4,900,6\n");
    const Outcome outcome = call(project, std::string{inventoried} +
                                              "--set stands.dead_wood=deadwood.csv --set "
                                              "stands.saplings=saplings.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table years = table(project, "out/tables/forest_years.csv");
    // Stands 7 and 8 have 0.4 ha each; snags are counted with stumps.
    EXPECT_NEAR(at_start(years, "snags_m3pha"), 0.5 * 30.0 + 0.5 * 2.0, 0.8);
    EXPECT_NEAR(at_start(years, "logs_m3pha"), 50.0, 0.8);
    EXPECT_NEAR(at_start(years, "saplings_pha"), 900.0, 1.0);
    EXPECT_GT(at_start(years, "dead_stems_tpha"), 5.0);
    // The budget of dead wood closes from year to year; what the start held is no gain.
    double before = 0.0;
    for (std::size_t row = 0; row < years.rows(); ++row) {
        const double stands = number(years, row, "dead_stems_tpha");
        const double change =
            number(years, row, "dead_wood_in_tpha") - number(years, row, "dead_wood_decayed_tpha") -
            number(years, row, "dead_wood_to_soil_tpha") - number(years, row, "dead_wood_taken_tpha");
        if (years.text(row, "year") == "0") {
            EXPECT_EQ(change, 0.0);
        } else {
            EXPECT_NEAR(stands, before + change, 0.003) << "row " << row;
        }
        before = stands;
    }
    const Outcome without = call(project, std::string{inventoried} + "--out without");
    ASSERT_EQ(without.code, 0) << without.err;
    EXPECT_EQ(at_start(table(project, "without/tables/forest_years.csv"), "logs_m3pha"), 0.0);
}

TEST(Start, TakesTheListInsideItsPolygonAndRecordsElsewhere) {
    const ForestProject project;
    // Stand 7 lies in the north of the forest, from x = 1040 on.
    project.write("area.csv", "wkt\n\"POLYGON ((1050 2030, 1090 2030, 1090 2070, 1050 2070, 1050 2030))\"\n");
    const std::string both =
        "run scenario.ini --quiet --set stands.records=records.csv --set run.rockfall_every=0 "
        "--set regimes.list=none --set output.tree_list_years=0 ";
    const Outcome outcome = call(project, both + "--set stands.tree_area=area.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table trees = table(project, "out/tables/trees_0.csv");
    std::size_t listed = 0;
    std::size_t others = 0;
    for (std::size_t row = 0; row < trees.rows(); ++row) {
        const double x_m = number(trees, row, "x_m");
        const double y_m = number(trees, row, "y_m");
        const bool is_inside = x_m > 1050 && x_m < 1090 && y_m > 2030 && y_m < 2070;
        (is_inside ? listed : others) += 1;
        if (is_inside) {
            EXPECT_LE(number(trees, row, "tree_id"), 3.0);
        }
    }
    EXPECT_EQ(listed, 3U);
    EXPECT_GT(others, 100U);
}

TEST(Start, HoldsTheStemsOfDiameterClasses) {
    const ForestProject project;
    project.write("classes.csv",
                  "stand,species,dbh_from_cm,dbh_to_cm,stems_pha,height_m\n"
                  "7,PIAB,20,24,333,20\n7,PIAB,40,44,40,\n8,FASY,12,16,500,14\n");
    const std::string command =
        "run scenario.ini --quiet --set trees.file= --set stands.dbh_classes=classes.csv --set "
        "run.replicates=1 --set run.rockfall_every=0 --set regimes.list=none ";
    const Outcome outcome = call(project, command);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table classes = table(project, "out/tables/dbh_classes.csv");
    std::map<std::string, double> stems;
    for (std::size_t row = 0; row < classes.rows(); ++row) {
        if (classes.text(row, "year") == "0" && classes.text(row, "species") != "all") {
            stems[classes.text(row, "dbh_from_cm")] += number(classes, row, "stems_pha");
        }
    }
    // Each stand has half of the 0.8 ha; whole trees.
    EXPECT_NEAR(stems["20"], 166.5, 1.3);
    EXPECT_NEAR(stems["40"], 20.0, 1.3);
    EXPECT_NEAR(stems["12"], 250.0, 1.3);
    EXPECT_EQ(stems.size(), 3U);
}

TEST(Start, TakesSaplingsByHeightClassAndComparesTheirBrowsing) {
    const ForestProject project;
    const std::string settings = "--set stands.saplings=saplings.csv ";
    // 600 of 0.25 m, all in reach, and 400 of 1.6 m, of which 0.34 / 1.28 are: 0.70625 of them together.
    project.write("saplings.csv",
                  "stand,species,height_class,stems_pha,browsed_percent,height_m\nall,ABAL,10-40,600,40,\n"
                  "all,ABAL,130-190,400,20,\nall,PIAB,,300,,0.3\n");
    const Outcome outcome = call(project, std::string{inventoried} + settings + "--verbose");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NEAR(at_start(table(project, "out/tables/forest_years.csv"), "saplings_pha"), 1300.0, 1.0);
    // (600 x 40 + 400 x 20) / 1000.
    EXPECT_NE(outcome.err.find("the inventory found 32 % of Abies alba browsed; the model browses "),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(outcome.err.find("of Picea abies browsed"), std::string::npos) << "the inventory is silent";

    // With the factor that the note names, the model agrees, also where another pressure holds for the
    // others.
    const std::string words = "forest.browsing_by_species = ";
    const auto named = [&](const std::string& err) {
        const std::size_t at = err.find(words);
        return at == std::string::npos
                   ? std::string{}
                   : err.substr(at + words.size(), err.find(" would give") - at - words.size());
    };
    const std::string factor = named(outcome.err);
    ASSERT_EQ(factor.substr(0, 5), "ABAL ") << outcome.err;
    const Outcome twice = call(
        project, std::string{inventoried} + settings + "--verbose --out c --set forest.browsing_pressure=2");
    EXPECT_NEAR(2.0 * std::stod(named(twice.err).substr(5)), std::stod(factor.substr(5)), 0.02) << twice.err;
    const Outcome matched =
        call(project, std::string{inventoried} + settings +
                          "--verbose --out b --set 'forest.browsing_by_species=" + factor + "'");
    ASSERT_EQ(matched.code, 0) << matched.err;
    EXPECT_TRUE(matched.err.find("the model browses 32 %") != std::string::npos ||
                matched.err.find("the model browses 31.9 %") != std::string::npos ||
                matched.err.find("the model browses 32.1 %") != std::string::npos)
        << matched.err;
}

TEST(Start, SpinsUpWhatNoFileGives) {
    const ForestProject project;
    ASSERT_EQ(call(project, std::string{inventoried} + "--out without").code, 0);
    const Outcome outcome = call(project, std::string{inventoried} + "--set stands.spin_up_years=12");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table years = table(project, "out/tables/forest_years.csv");
    EXPECT_GT(at_start(years, "snags_m3pha") + at_start(years, "logs_m3pha"), 0.0);
    const auto trees_of = [&](const std::string& folder) {
        const config::Table stands = table(project, folder + "/tables/stands.csv");
        for (std::size_t row = 0; row < stands.rows(); ++row) {
            if (stands.text(row, "year") == "0" && stands.text(row, "species") == "all" &&
                stands.text(row, "stand") == "all") {
                return number(stands, row, "basal_area_m2pha");
            }
        }
        return 0.0;
    };
    EXPECT_EQ(trees_of("out"), trees_of("without")) << "the trees are those of the inventory";
}

}  // namespace
}  // namespace coupling::start_test
