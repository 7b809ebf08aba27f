#include "validation/engine/years/queries.hpp"

#include <gtest/gtest.h>

namespace coupling::validation::years::queries_test {
namespace {

TEST(ReadQueries, TakesTheCommentAboveAStatementAsItsHead) {
    const std::vector<Query> queries = read_queries(
        "-- anything\nCREATE VIEW a AS\n  SELECT 1;\n\n-- figure b:{site} | sites | the b at {words} | m\n"
        "SELECT 2;\n-- table All of it\nSELECT 3;\n-- stack Layers\nSELECT 4;",
        "figures.sql");
    ASSERT_EQ(queries.size(), 4U);
    EXPECT_EQ(queries[0].use, QueryUse::definition);
    EXPECT_EQ(queries[0].sql, "CREATE VIEW a AS\nSELECT 1;\n");
    EXPECT_EQ(queries[1].use, QueryUse::figure);
    EXPECT_EQ(queries[1].title, "b:{site}");
    EXPECT_EQ(queries[1].rows, "sites");
    EXPECT_EQ(queries[1].label, "the b at {words}");
    EXPECT_EQ(queries[1].unit, "m");
    EXPECT_EQ(queries[1].place.line, 6U);
    EXPECT_EQ(queries[2].title, "All of it");
    EXPECT_EQ(queries[3].use, QueryUse::stack);
}

TEST(ReadQueries, TakesWhatWasObservedAndWhereSomethingLooksWrong) {
    const std::vector<Query> queries = read_queries(
        "-- figure b | sites | the b | m | {seen}\nSELECT 2;\n-- lines Growth\nSELECT 3;\n"
        "-- warning a.csv | an odd a; look at it\nSELECT 4;\n-- error a.csv | {a} | another\nSELECT 5;\n",
        "figures.sql");
    ASSERT_EQ(queries.size(), 4U);
    EXPECT_EQ(queries[0].observed, "{seen}");
    EXPECT_EQ(queries[1].use, QueryUse::lines);
    EXPECT_EQ(queries[2].use, QueryUse::warning);
    EXPECT_EQ(queries[2].rows, "a.csv");
    EXPECT_EQ(queries[2].title, "an odd a; look at it");
    EXPECT_EQ(queries[3].use, QueryUse::error);
    EXPECT_EQ(queries[3].title, "{a}");
    EXPECT_EQ(queries[3].label, "another");
}

TEST(Filled, PutsFieldsIntoAText) {
    const Fields fields{{"site", "e0500"}, {"words", "500 m"}};
    EXPECT_EQ(filled("a:{site} at {words}.", fields, {}), "a:e0500 at 500 m.");
    EXPECT_THROW(static_cast<void>(filled("{place}", fields, {})), config::InputError);
}

}  // namespace
}  // namespace coupling::validation::years::queries_test
