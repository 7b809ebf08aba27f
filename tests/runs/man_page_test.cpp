// The manual page says what the program's own help says.

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling::man_page_test {
namespace {

/// As `man` shows it: orders gone, signs as they are printed.
std::string shown(const std::string& page) {
    std::istringstream in{page};
    std::string text;
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with('.')) {
            text += line + '\n';
        }
    }
    text = std::regex_replace(text, std::regex{R"(\\&)"}, "");
    text = std::regex_replace(text, std::regex{R"(\\-)"}, "-");
    return std::regex_replace(text, std::regex{R"(\\e)"}, "\\");
}

TEST(ManPage, HoldsTheHelpOfTheProgramAndOfEachCommand) {
    const SampleProject project;
    const std::string page = call(project, "completion man").out;
    const std::string text = shown(page);
    EXPECT_NE(text.find(call(project, "--help").out), std::string::npos);
    std::size_t commands = 0;
    std::istringstream lines{page};
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(".SS ")) {
            ++commands;
            const std::string name = line.substr(4);
            EXPECT_NE(text.find(call(project, name + " --help").out), std::string::npos) << name;
        }
    }
    EXPECT_GT(commands, 10U);
}

}  // namespace
}  // namespace coupling::man_page_test
