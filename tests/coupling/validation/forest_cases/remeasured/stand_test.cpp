#include "coupling/validation/forest_cases/remeasured/stand.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/validation/forest_cases/remeasured/synthetic_plot.hpp"

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

MeasuredStand stand_of(const Texts& texts) {
    return read_measured_stand(
        {.site = table_of(texts.site, "site.csv"),
         .trees = table_of(texts.trees, "trees.csv"),
         .trees_end = table_of(texts.trees_end, "trees_end.csv"),
         .climate = table_of(shipped_text("forest_belts", "climate.csv"), "climate.csv"),
         .fell_list = table_of(texts.fell_list, "fell_list.csv")},
        forest::SpeciesTable::shipped());
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

TEST(ReadMeasuredStand, RefusesCutsThatCannotBe) {
    Texts texts;
    texts.fell_list = "tree_id,year\n99,1995\n";
    EXPECT_NE(problem_of(texts).find("tree_id 99 felled, which the first measurement has not"),
              std::string::npos);
    texts.fell_list = "tree_id,year\n7,1995\n";
    EXPECT_NE(problem_of(texts).find("tree_id 7 felled, but measured at the end"), std::string::npos);
    texts.fell_list = "tree_id,year\n6,1989\n";
    EXPECT_NE(problem_of(texts).find("a calendar year from 1990 to 2000"), std::string::npos);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::remeasured::stand_test
