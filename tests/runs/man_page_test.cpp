// The manual page names everything that the program's own help names.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling::man_page_test {
namespace {

std::string man_page() {
    std::ostringstream text;
    text << std::ifstream{BANNWALD_SOURCE_DIR "/packaging/bannwald.1"}.rdbuf();
    // Hyphens and fonts as they are printed.
    const std::string hyphens = std::regex_replace(text.str(), std::regex{R"(\\-)"}, "-");
    return std::regex_replace(hyphens, std::regex{R"(\\f[BIR])"}, "");
}

/// What a pattern finds, each once.
std::set<std::string> found(const std::string& pattern, const std::string& text) {
    std::set<std::string> all;
    const std::regex wanted{pattern};
    for (std::sregex_iterator at{text.begin(), text.end(), wanted}, end; at != end; ++at) {
        all.insert((*at)[1]);
    }
    return all;
}

/// Names that the completion script knows in one of its lists.
std::set<std::string> completed(const SampleProject& project, const std::string& list) {
    const std::string script = call(project, "completion bash").out;
    const std::set<std::string> line = found("_bannwald_" + list + "=\"([^\"]*)\"", script);
    return line.empty() ? line : found("([^ ]+)", *line.begin());
}

TEST(ManPage, NamesEveryCommandAndItsOptions) {
    const SampleProject project;
    const std::string page = man_page();
    const std::set<std::string> commands = completed(project, "commands");
    ASSERT_GT(commands.size(), 5U);
    std::set<std::string> options = found("(--[a-z][a-z0-9-]+)", call(project, "--help").out);
    for (const std::string& command : commands) {
        EXPECT_NE(page.find("bannwald " + command), std::string::npos) << command;
        options.merge(found("(--[a-z][a-z0-9-]+)", call(project, command + " --help").out));
    }
    ASSERT_GT(options.size(), 15U);
    const std::set<std::string> described = found("(--[a-z][a-z0-9-]+)", page);
    for (const std::string& option : options) {
        EXPECT_TRUE(described.contains(option)) << option;
    }
    for (const std::string& option : described) {
        EXPECT_TRUE(options.contains(option)) << option << " does not exist";
    }
}

TEST(ManPage, GivesTheExitCodesOfTheHelp) {
    const SampleProject project;
    const std::string help = call(project, "--help").out;
    const std::set<std::string> codes =
        found("\n  ([0-9]+)  ", help.substr(std::min(help.find("Exit codes"), help.size())));
    ASSERT_EQ(codes.size(), 7U);
    EXPECT_EQ(found("\n\\.B ([0-9]+)\n", man_page()), codes);
}

}  // namespace
}  // namespace coupling::man_page_test
