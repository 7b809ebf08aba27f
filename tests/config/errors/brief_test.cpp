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

TEST(Brief, PrintsThreeOfAKindOneByOneAndOfMoreTheFirstWithTheirNumber) {
    EXPECT_EQ(brief(problems(3, "a.csv", "a number")).size(), 3U);
    const std::vector<BriefMessage> lines = brief(problems(732, "climate.csv", "a number in [-60, 50]"));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].sentence, "climate.csv:1: found tmax_c '41', expected a number in [-60, 50]");
    EXPECT_EQ(lines[0].more, 731U);
    EXPECT_EQ(to_string(lines[0]), lines[0].sentence + " (and 731 more like this; --verbose prints all)");
}

TEST(Brief, CountsEveryMessageOnce) {
    for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 1000U}) {
        std::size_t all = 0;
        for (const BriefMessage& message : brief(problems(count, "a.csv", "a number"))) {
            all += 1 + message.more;
        }
        EXPECT_EQ(all, count);
    }
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
    const std::vector<BriefMessage> lines = brief(sentences);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].more, 9U);
    EXPECT_EQ(lines[1].sentence, "something else");
}

}  // namespace
}  // namespace config::brief_test
