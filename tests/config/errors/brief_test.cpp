#include "config/errors/brief.hpp"

#include <gtest/gtest.h>

namespace config::brief_test {
namespace {

std::vector<Problem> problems(std::size_t count, const std::string& file, const std::string& expected) {
    std::vector<Problem> list;
    for (std::size_t i = 1; i <= count; ++i) {
        list.push_back({ExitCode::data, {file, i, 0}, "tmax_c '" + std::to_string(40 + i) + "'", expected});
    }
    return list;
}

TEST(Brief, TellsThreeOfAKindAndHowManyMore) {
    const std::vector<std::string> lines = brief(problems(732, "climate.csv", "a number in [-60, 50]"));
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0], "climate.csv:1: found tmax_c '41', expected a number in [-60, 50]");
    EXPECT_EQ(lines[2], "climate.csv:3: found tmax_c '43', expected a number in [-60, 50]");
    EXPECT_EQ(lines[3], "... and 729 more like this; --verbose prints all");
}

TEST(Brief, TellsFourInFull) {
    EXPECT_EQ(brief(problems(4, "a.csv", "a number")).size(), 4U);
    EXPECT_EQ(brief(problems(5, "a.csv", "a number")).size(), 4U);
}

TEST(Brief, KeepsKindsApart) {
    std::vector<Problem> mixed = problems(3, "a.csv", "a number");
    for (const Problem& other : problems(3, "b.csv", "a number")) {
        mixed.push_back(other);
    }
    for (const Problem& other : problems(3, "a.csv", "a name")) {
        mixed.push_back(other);
    }
    EXPECT_EQ(brief(mixed).size(), 9U) << "none of the three kinds is larger than three";
}

TEST(Brief, TakesSentencesThatDifferInNumbersForOneKind) {
    std::vector<std::string> sentences;
    for (int i = 0; i < 10; ++i) {
        sentences.push_back("line " + std::to_string(i) + ": 7." + std::to_string(i) + " is much");
    }
    sentences.insert(sentences.begin() + 5, "something else");
    const std::vector<std::string> lines = brief(sentences);
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[3], "... and 7 more like this; --verbose prints all");
    EXPECT_EQ(lines[4], "something else");
}

}  // namespace
}  // namespace config::brief_test
