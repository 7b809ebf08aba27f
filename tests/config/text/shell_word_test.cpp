#include "config/text/shell_word.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

namespace config::shell_word_test {
namespace {

std::string said_by_shell(const std::string& word) {
    const std::string command = "printf %s " + word;
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe{popen(command.c_str(), "r"), &pclose};
    std::array<char, 4096> text{};
    const std::size_t got = std::fread(text.data(), 1, text.size(), pipe.get());
    return {text.data(), got};
}

TEST(ShellWord, IsOneWordForTheShellWhateverItHolds) {
    for (const std::string text :
         {"scenario.ini", "Projekt DE/scenario.ini", "à côté/$HOME `id` \"x\"", "it's", "a;b&c|d", "*?[x]~",
          "back\\slash", "tab\there", "(x)", "#no comment", "-–- ü", " ", "'"}) {
        EXPECT_EQ(said_by_shell(shell_word(text)), text) << shell_word(text);
    }
    EXPECT_EQ(said_by_shell("x" + shell_word("")), "x");
}

TEST(ShellWord, LeavesPlainPathsAsTheyAre) {
    for (const std::string text : {"scenario.ini", "/data/x/dgm_5m.tif", "../a-b/c.csv", "EPSG:31254"}) {
        EXPECT_EQ(shell_word(text), text);
    }
}

}  // namespace
}  // namespace config::shell_word_test
