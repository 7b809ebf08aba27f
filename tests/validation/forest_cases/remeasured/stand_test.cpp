#include "validation/engine/forest_cases/remeasured/stand.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/validation/forest_cases/remeasured/synthetic_plot.hpp"

namespace coupling::validation::forest_cases::remeasured::stand_test {
namespace {

config::Table table_of(const std::string& text, const std::string& name) {
    std::istringstream in{text};
    return config::Table::read(in, name);
}

struct Texts {
    std::string site = synthetic_site();
    std::string trees = synthetic_trees();
    std::string trees_end = synthetic_end();
    std::string fell_list = "tree_id,year\n6,1995\n";
};

MeasuredStand stand_of(const Texts& texts, config::Warnings& warnings) {
    return read_measured_stand(
        {.site = table_of(texts.site, "site.csv"),
         .trees = table_of(texts.trees, "trees.csv"),
         .trees_end = table_of(texts.trees_end, "trees_end.csv"),
         .climate = table_of(shipped_text("forest_belts", "climate.csv"), "climate.csv"),
         .fell_list = table_of(texts.fell_list, "fell_list.csv")},
        forest::SpeciesTable::shipped(), warnings);
}

MeasuredStand stand_of(const Texts& texts) {
    config::Warnings warnings;
    return stand_of(texts, warnings);
}

std::vector<std::string> warnings_of(const Texts& texts) {
    config::Warnings warnings;
    static_cast<void>(stand_of(texts, warnings));
    return warnings.all();
}

std::string problem_of(const Texts& texts) {
    try {
        static_cast<void>(stand_of(texts));
    } catch (const config::InputError& error) {
        return error.what();
    }
    return {};
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), with);
}

std::string joined_row(const std::string& dbh_cm) {
    return ",fasy," + dbh_cm + "\n";
}

TEST(ReadMeasuredStand, FollowsEachTreeToItsEnd) {
    const MeasuredStand stand = stand_of({});
    EXPECT_EQ(stand.trees.size(), 36U);
    EXPECT_DOUBLE_EQ(stand.area_ha(), 0.09);
    EXPECT_EQ(stand.years(), 10);
    EXPECT_EQ(stand.trees[0].end_dbh_cm, stand.trees[0].dbh_cm + 2.0);
    EXPECT_FALSE(stand.trees[2].end_dbh_cm) << "died";
    EXPECT_FALSE(stand.trees[2].felled);
    EXPECT_EQ(stand.trees[5].felled, 1995);
    ASSERT_EQ(stand.ingrown.size(), 1U) << "one is too thin to count";
    EXPECT_EQ(stand.ingrown[0].dbh_cm, 7.5);
    EXPECT_LT(stand.climate.find(1995)->months[6].tave_degc, 17.0) << "moved up to the plot";
}

TEST(ReadMeasuredStand, NamesWhatDoesNotFitTogether) {
    EXPECT_EQ(problem_of({}), "");
    Texts texts;
    texts.site = replaced(texts.site, "30,30,1000", "35,30,1000");
    EXPECT_NE(problem_of(texts).find("a multiple of 10 m"), std::string::npos) << problem_of(texts);
    texts = {};
    texts.site = replaced(texts.site, "1990,2000", "2000,1990");
    EXPECT_NE(problem_of(texts).find("last_year 1990"), std::string::npos);
    texts = {};
    texts.site = replaced(texts.site, "1990,2000", "2005,2015");
    texts.fell_list = "tree_id,year\n6,2006\n";
    EXPECT_NE(problem_of(texts).find("no year 2011"), std::string::npos) << problem_of(texts);
    texts = {};
    texts.trees = replaced(texts.trees, "\n1,2.5,", "\n1,31,");
    EXPECT_NE(problem_of(texts).find("x_m"), std::string::npos);
    texts = {};
    texts.trees = replaced(texts.trees, "\n2,", "\n1,");
    EXPECT_NE(problem_of(texts).find("tree_id 1 a second time, as in line 2"), std::string::npos);
    texts = {};
    texts.trees_end = replaced(texts.trees_end, "\n1,fasy,", "\n1,piab,");
    EXPECT_NE(problem_of(texts).find("tree 1 is piab"), std::string::npos);
    texts = {};
    texts.trees_end = replaced(texts.trees_end, "\n1,fasy,25", "\n1,fasy,15");
    EXPECT_NE(problem_of(texts).find("no tree thinner by more than a fifth"), std::string::npos)
        << problem_of(texts);
}

TEST(ReadMeasuredStand, AsksToLeaveTreesBelowTheLeastDiameterOut) {
    Texts texts;
    texts.trees = replaced(texts.trees, ",fasy,23\n", ",fasy,6.5\n");
    EXPECT_EQ(
        problem_of(texts),
        "trees.csv:2:16: found tree 1 with dbh_cm 6.5, expected least_dbh_cm of site.csv or more, 7; leave "
        "the tree out of both tables: thinner trees were not all counted");
}

void expect_one_problem(const Texts& texts) {
    const std::string message = problem_of(texts);
    EXPECT_NE(message, "");
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
}

TEST(ReadMeasuredStand, ListsTheSpeciesThatThereAre) {
    Texts texts;
    texts.trees = replaced(texts.trees, ",fasy,23\n", ",hornbeam,23\n");
    EXPECT_EQ(
        problem_of(texts).find("trees.csv:2:11: found species 'hornbeam', expected a species of the species "
                               "table: "),
        0U)
        << problem_of(texts);
    EXPECT_NE(problem_of(texts).find("PIAB"), std::string::npos);
}

TEST(ReadMeasuredStand, NamesWhatIsNoNumberOnce) {
    for (const char* no_number : {"nan", "thick", "", "404"}) {
        Texts texts;
        texts.trees = replaced(texts.trees, ",fasy,23\n", joined_row(no_number));
        expect_one_problem(texts);
        texts = {};
        texts.trees_end = replaced(texts.trees_end, ",fasy,25\n", joined_row(no_number));
        expect_one_problem(texts);
    }
    Texts texts;
    texts.site = replaced(texts.site, "1990,2000", "1990,nan");
    expect_one_problem(texts);
}

TEST(ReadMeasuredStand, WarnsOfGrowthThatCanHardlyBe) {
    EXPECT_TRUE(warnings_of({}).empty()) << warnings_of({}).front();
    Texts texts;
    texts.trees_end = replaced(texts.trees_end, "\n1,fasy,25", "\n1,fasy,53.1");
    texts.trees_end = replaced(texts.trees_end, "\n2,piab,36", "\n2,piab,33.4");
    ASSERT_EQ(warnings_of(texts).size(), 2U);
    EXPECT_EQ(
        warnings_of(texts)[0],
        "trees_end.csv, line 2: 1 tree grows more than 3 cm a year in diameter; correct tree_id or dbh_cm, "
        "or leave the tree out of both tables");
    EXPECT_EQ(
        warnings_of(texts)[1],
        "trees_end.csv, line 3: 1 tree shrinks by more than 0.5 cm, the error of a tape; correct tree_id or "
        "dbh_cm, or leave the tree out of both tables");
    texts.trees_end = replaced(texts.trees_end, "\n2,piab,33.4", "\n2,piab,33.6");
    EXPECT_EQ(warnings_of(texts).size(), 1U);
}

TEST(ReadMeasuredStand, WarnsOfIngrowthThatIsTooThick) {
    Texts texts;
    texts.trees_end = replaced(texts.trees_end, "\n1,fasy,25", "\n1001,fasy,25");
    ASSERT_EQ(warnings_of(texts).size(), 1U);
    EXPECT_EQ(warnings_of(texts)[0].find("trees_end.csv, line 2: counted as ingrowth, but thicker than "
                                         "least_dbh_cm and 1 cm a year; correct tree_id"),
              0U)
        << warnings_of(texts)[0];
}

TEST(ReadMeasuredStand, RefusesGrowthThatNoForestHas) {
    Texts texts;
    texts.site = replaced(texts.site, "1990,2000", "1999,2000");
    texts.trees_end = "tree_id,species,dbh_cm\n1,fasy,26.5\n2,piab,37.5\n";
    texts.fell_list = "tree_id,year\n6,1999\n";
    EXPECT_EQ(problem_of(texts),
              "trees_end.csv: found mean diameter growth of 4 cm a year, expected 3 cm a year or less; write "
              "dbh_cm "
              "in cm in both tables, and check first_year and last_year of site.csv");
}

TEST(ReadMeasuredStand, WarnsOfColumnsThatNothingReads) {
    Texts texts;
    texts.trees = replaced(texts.trees, "tree_id,x_m,y_m,species,dbh_cm\n1,2.5,2.5,fasy,23\n",
                           "tree_id,x_m,y_m,species,dbh_cm,h,height\n1,2.5,2.5,fasy,23,20,20\n");
    for (int number = 2; number <= 36; ++number) {
        const std::size_t at = texts.trees.find("\n" + std::to_string(number) + ",") + 1;
        texts.trees.insert(texts.trees.find('\n', at), ",,");
    }
    ASSERT_EQ(warnings_of(texts).size(), 2U);
    EXPECT_EQ(warnings_of(texts)[0],
              "trees.csv: column 'h' is not read; if it is 'height_m', give it that name, or leave it out");
    EXPECT_NE(warnings_of(texts)[1].find("column 'height' is not read; if it is 'height_m'"),
              std::string::npos);
}

TEST(ReadMeasuredStand, AsksToLeaveDeadTreesOutOfTheEnd) {
    for (const char* of_dead : {"", "0", "NA"}) {
        Texts texts;
        texts.trees_end = replaced(texts.trees_end, ",fasy,25\n", joined_row(of_dead));
        EXPECT_EQ(problem_of(texts),
                  "trees_end.csv:2:8: found tree 1 without a dbh_cm, expected living trees alone; leave the "
                  "row out if the tree is dead or was felled")
            << of_dead;
    }
}

TEST(ReadMeasuredStand, RefusesAnEndWithoutAnyOfItsTrees) {
    Texts texts;
    texts.trees_end = "tree_id,species,dbh_cm\n";
    EXPECT_EQ(problem_of(texts).find("trees_end.csv: found no trees, expected a row for each"), 0U)
        << problem_of(texts);
    texts.trees_end = "tree_id,species,dbh_cm\n101,piab,37\n102,fasy,8\n";
    EXPECT_EQ(problem_of(texts).find("trees_end.csv: found no tree_id of the first measurement"), 0U)
        << problem_of(texts);
    texts.trees_end = "tree_id,species,dbh_cm\n101,piab,7.5\n102,fasy,8\n";
    EXPECT_EQ(problem_of(texts), "") << "all trees died, young ones grew in";
}

TEST(ReadMeasuredStand, RefusesALatitudeThatTheSeasonsContradict) {
    Texts texts;
    texts.site = replaced(texts.site, ",47.5,", ",-47.5,");
    EXPECT_EQ(problem_of(texts).find("site.csv:2:12: found latitude_deg -47.5, expected a place north of the "
                                     "equator: in climate.csv July is the summer month"),
              0U)
        << problem_of(texts);
}

TEST(ReadMeasuredStand, WarnsOfTreesAtOnePlaceAndOfGroundWithoutTrees) {
    Texts texts;
    texts.trees = replaced(texts.trees, "\n2,7.5,2.5,", "\n2,2.5,2.5,");
    ASSERT_EQ(warnings_of(texts).size(), 1U);
    EXPECT_EQ(warnings_of(texts)[0],
              "trees.csv, line 3: 1 row has the x_m and y_m of an earlier one; leave out what stands there "
              "twice, keep stems of one stool");
    texts = {};
    texts.site = replaced(texts.site, "\n30,30,", "\n30,300,");
    ASSERT_EQ(warnings_of(texts).size(), 1U);
    EXPECT_EQ(
        warnings_of(texts)[0].find("trees.csv: trees have y_m from 2.5 to 27.5, the plot of site.csv is "
                                   "300 m wide"),
        0U)
        << warnings_of(texts)[0];
}

TEST(ReadMeasuredStand, RefusesCutsThatCannotBe) {
    Texts texts;
    texts.fell_list = "tree_id,year\n99,1995\n";
    EXPECT_EQ(problem_of(texts).find("fell_list.csv:2:1: found"), 0U);
    EXPECT_NE(problem_of(texts).find("tree_id 99 felled, which the first measurement has not"),
              std::string::npos);
    texts.fell_list = "tree_id,year\n7,1995\n";
    EXPECT_NE(problem_of(texts).find("tree_id 7 felled, but measured at the end"), std::string::npos);
    texts.fell_list = "tree_id,year\n6,1989\n";
    EXPECT_NE(problem_of(texts).find("a calendar year from 1990 to 2000"), std::string::npos);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::remeasured::stand_test
