#include "tests/refusals/refusals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace coupling::refusals {

void PrintTo(const Case& refusal, std::ostream* out) {
    *out << refusal.file << ", " << refusal.title;
}

namespace {

std::vector<Case> all_cases() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator{BANNWALD_SOURCE_DIR "/tests/refusals"}) {
        if (entry.path().extension() == ".cases") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<Case> all;
    for (const auto& file : files) {
        std::ifstream in{file};
        const std::vector<Case> cases = read_cases(in, file.filename().string());
        all.insert(all.end(), cases.begin(), cases.end());
    }
    return all;
}

/// "trees.cases", "a log is lost" -> trees_ALogIsLost
std::string name_of(const Case& refusal) {
    std::string name = refusal.file.substr(0, refusal.file.find('.')) + "_";
    bool begins = true;
    for (const char c : refusal.title) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) {
            name += begins ? static_cast<char>(std::toupper(byte)) : c;
        }
        begins = std::isalnum(byte) == 0;
    }
    return name;
}

class Refusals : public ::testing::TestWithParam<Case> {};

TEST_P(Refusals, AreAnsweredAsTheCaseSays) {
    const std::string found = differences(GetParam());
    EXPECT_TRUE(found.empty()) << found;
}

INSTANTIATE_TEST_SUITE_P(Cases, Refusals, ::testing::ValuesIn(all_cases()),
                         [](const auto& refusal) { return name_of(refusal.param); });

std::string differences_of(const std::string& lines) {
    std::istringstream in{"project sample\ncase one\n" + lines};
    return differences(read_cases(in, "a.cases").front());
}

const std::string zero = "replace trees.csv: 32.5 => 0\n$ bannwald check scenario.ini\n";
const std::string right = "bannwald: trees.csv:2:18: found dbh_cm '0', expected a number in (0, 500]\n";

TEST(RefusalRunner, ReportsEachKindOfWrongAnswer) {
    EXPECT_EQ(differences_of(zero + right + "exit 4\n"), "");
    const std::string head = "a.cases:4: expected (-) and printed (+) after\n$ bannwald check scenario.ini\n";
    std::string wrong = right;
    wrong.replace(wrong.find("2:18"), 4, "2:19");
    EXPECT_EQ(differences_of(zero + wrong + "exit 4\n"), head + "- " + wrong + "+ " + right + "  exit 4\n");
    EXPECT_EQ(differences_of(zero + right + "exit 2\n"), head + "  " + right + "- exit 2\n+ exit 4\n");
    EXPECT_EQ(differences_of(zero + "exit 4\n"), head + "+ " + right + "  exit 4\n");
    EXPECT_EQ(differences_of(zero + right + right + "exit 4\n"),
              head + "  " + right + "- " + right + "  exit 4\n");
    EXPECT_NE(differences_of("$ bannwald check scenario.ini\nexit 4\n"), "");
    EXPECT_NE(differences_of("$ bannwald init new\n").find("+ and files of the project are changed"),
              std::string::npos);
}

TEST(RefusalRunner, TakesAnyTextForAFigureOfTheMachineOnly) {
    std::string with_any = right;
    with_any.replace(with_any.find("500"), 3, "<any>");
    EXPECT_EQ(differences_of(zero + with_any + "exit 4\n"), "");
    with_any.replace(with_any.find("dbh"), 3, "DBH");
    EXPECT_NE(differences_of(zero + with_any + "exit 4\n"), "");
}

TEST(RefusalRunner, ReportsWhatIsSaidTwice) {
    const std::string by_nearest = "bannwald: t.csv: no column 'x_m' (is 'x' meant to be it?)";
    EXPECT_EQ(said_twice({right, by_nearest, "exit 4"}), "");
    EXPECT_EQ(said_twice({"a", "b", "a"}), "said twice: a\n");
    EXPECT_EQ(said_twice({by_nearest, "bannwald: t.csv: no column 'x_m' among y_m; add it"}),
              "said twice: bannwald: t.csv: no column 'x_m'\n");
    EXPECT_EQ(said_twice({by_nearest, "bannwald: t.csv: no column 'y_m' among z; add it"}), "");
}

TEST(RefusalRunner, CallsBothCommandsOfAPair) {
    EXPECT_EQ(differences_of("$ bannwald {check,run} scenario.ini --set a.b=1\n").find("check scenario.ini"),
              std::string{"a.cases:3: expected (-) and printed (+) after\n$ bannwald "}.size());
    EXPECT_NE(
        differences_of("$ bannwald {check,run} scenario.ini --set a.b=1\n").find("bannwald run scenario.ini"),
        std::string::npos);
}

TEST(RefusalRunner, RefusesChangesWithoutMeaningOrEffect) {
    for (const char* line :
         {"replace trees.csv: not there => 1", "replace none.csv: a => b", "remove none.csv",
          "cell dem.asc row 11 column 1 = 3", "line trees.csv 9: a", "chnage trees.csv"}) {
        EXPECT_THROW(differences_of(line), std::exception) << line;
    }
    std::istringstream in{"project smaple\ncase one\n"};
    EXPECT_THROW(differences(read_cases(in, "a.cases").front()), std::runtime_error);
}

TEST(RefusalFiles, HaveTitlesOfTheirOwnAndCallTheProgramInEachCase) {
    std::set<std::string> names;
    for (const Case& refusal : all_cases()) {
        EXPECT_TRUE(names.insert(name_of(refusal)).second) << name_of(refusal);
        EXPECT_TRUE(std::any_of(refusal.lines.begin(), refusal.lines.end(), [](const Line& line) {
            return line.text.starts_with("$ bannwald ");
        })) << name_of(refusal);
    }
    EXPECT_GT(names.size(), 100U);
}

}  // namespace
}  // namespace coupling::refusals
