#include "config/errors/input_error.hpp"

#include <gtest/gtest.h>

namespace config::input_error_test {
namespace {

TEST(ToString, NamesFileLineColumnFoundAndExpected) {
    EXPECT_EQ(to_string({ExitCode::data, {"dem.asc", 3, 7}, "'abc'", "a number"}),
              "dem.asc:3:7: found 'abc', expected a number");
}

TEST(ToString, LeavesOutWhatIsNotKnown) {
    const Place line{.file = "dem.asc", .line = 3};
    const Place file{.file = "dem.asc"};
    const Place nowhere;
    EXPECT_EQ(to_string(Problem{ExitCode::data, line, "'abc'", "a number"}),
              "dem.asc:3: found 'abc', expected a number");
    EXPECT_EQ(to_string(Problem{ExitCode::data, line, "'abc'", "a number", "correct the cell"}),
              to_string(Problem{ExitCode::data, line, "'abc'", "a number"}) + "; correct the cell");
    EXPECT_EQ(to_string(Problem{ExitCode::settings, nowhere, "no scenario given", "", "name one"}),
              "no scenario given; name one");
    EXPECT_EQ(to_string(Problem{ExitCode::file, file, "cannot be opened", ""}), "dem.asc: cannot be opened");
    EXPECT_EQ(to_string(Problem{ExitCode::settings, nowhere, "no scenario given", ""}), "no scenario given");
}

TEST(InputError, SaysEachProblemOnce) {
    const Problem missing{ExitCode::data, {"stands.csv"}, "no column 'stand'", ""};
    const Problem other{ExitCode::data, {"stands.csv"}, "no column 'species'", ""};
    const InputError error{{missing, other, missing}};
    ASSERT_EQ(error.problems().size(), 2U);
    EXPECT_STREQ(error.what(), "stands.csv: no column 'stand'\nstands.csv: no column 'species'");
}

TEST(InputError, CarriesTheCodeOfItsFirstProblem) {
    try {
        fail(ExitCode::file, {"a.csv"}, "cannot be opened");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), ExitCode::file);
        EXPECT_STREQ(error.what(), "a.csv: cannot be opened");
    }
}

TEST(InputError, ShowsTwentyFiveProblemsAndCountsTheRest) {
    Problems problems;
    for (std::size_t line = 1; line <= 30; ++line) {
        problems.add(ExitCode::data, {"a.csv", line}, "'x'", "a number");
    }
    try {
        problems.throw_if_any();
        FAIL();
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_EQ(error.problems().size(), 30U);
        EXPECT_NE(text.find("a.csv:25: "), std::string::npos);
        EXPECT_EQ(text.find("a.csv:26: "), std::string::npos);
        EXPECT_TRUE(text.ends_with("... and 5 more")) << text;
    }
}

TEST(Problems, TakeOverThoseOfAnError) {
    Problems problems;
    problems.add(InputError{{{ExitCode::data, {"a"}, "one", ""}, {ExitCode::data, {"a"}, "two", ""}}});
    EXPECT_EQ(problems.list().size(), 2U);
    EXPECT_NO_THROW(Problems{}.throw_if_any());
}

TEST(NearestWord, ForgivesAThirdOfTheLetters) {
    const std::vector<std::string> legal{"dbh_cm", "height_m", "species"};
    EXPECT_EQ(nearest_word("dhb_cm", legal), "dbh_cm");
    EXPECT_EQ(nearest_word("HEIGHT_M", legal), "height_m");
    EXPECT_EQ(nearest_word("specie", legal), "species");
    EXPECT_EQ(nearest_word("xyz", legal), "");
    EXPECT_EQ(nearest_word("", legal), "");
}

TEST(NearestWord, LooksForNoNeighbourOfTextsThatAreNoWords) {
    const std::string longest(longest_word_bytes, 'a');
    EXPECT_EQ(nearest_word(longest, {longest + 'b'}), longest + 'b');
    EXPECT_EQ(nearest_word(longest + 'b', {longest}), "");
}

TEST(InQuotes, StaysOnOneLineAndIsCutBetweenCharacters) {
    EXPECT_EQ(in_quotes("a\tb\n"), "'a?b?'");
    EXPECT_EQ(in_quotes(std::string(59, 'x') + "\xC3\xA4yz"), "'" + std::string(59, 'x') + "...'");
}

TEST(PlaceIn, CountsLinesAndCharacters) {
    const std::string text = "one\nt\xC3\xBCr x";
    const Place place = place_in(text, text.find('x'), {"a.txt"});
    EXPECT_EQ(place.line, 2U);
    EXPECT_EQ(place.column, 5U);
}

TEST(PlaceIn, GoesOnFromThePlaceOfTheFirstByte) {
    const Place place = place_in("POINT (1 x)", 9, {"a.csv", 12, 5});
    EXPECT_EQ(place.line, 12U);
    EXPECT_EQ(place.column, 14U);
}

}  // namespace
}  // namespace config::input_error_test
