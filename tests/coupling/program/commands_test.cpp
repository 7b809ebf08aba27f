#include "coupling/program/commands.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "coupling/program/line/arguments.hpp"
#include "coupling/program/line/completion.hpp"
#include "coupling/program/line/help.hpp"

namespace coupling::commands_test {
namespace {

using Words = std::vector<std::string>;

TEST(Commands, HaveNamesHelpAndOptionsOfTheirOwn) {
    std::set<std::string> names;
    for (const Command& command : commands_of_the_program()) {
        EXPECT_TRUE(names.insert(command.name).second) << command.name;
        EXPECT_TRUE(command.help.starts_with("bannwald " + command.name + ' ')) << command.name;
        EXPECT_TRUE(command.overview.starts_with("  bannwald " + command.name + ' ')) << command.name;
        EXPECT_TRUE(command.overview.ends_with('\n')) << command.name;
        EXPECT_TRUE(command.run != nullptr) << command.name;
        std::set<std::string> options;
        for (const CommandOption& option : command.options) {
            EXPECT_TRUE(options.insert(option.name).second) << command.name << ' ' << option.name;
        }
    }
    EXPECT_GT(names.size(), 10U);
}

TEST(Commands, ExplainEveryOptionInTheirHelp) {
    for (const Command& command : commands_of_the_program()) {
        for (const CommandOption& option : command.options) {
            const bool is_usual =
                (command.name == "stopping-table" || command.name == "merge") && option.name == "seed";
            EXPECT_TRUE(is_usual || command.help.find("--" + option.name) != std::string::npos)
                << command.name << " --" << option.name;
        }
    }
}

TEST(Commands, AreAllInTheShortHelpAndTheCompletion) {
    const std::vector<Command> commands = commands_of_the_program();
    std::ostringstream help, completion;
    write_short_help(commands, help);
    write_completion(commands, "bash", completion);
    for (const Command& command : commands) {
        EXPECT_NE(help.str().find(command.overview), std::string::npos) << command.name;
        EXPECT_NE(completion.str().find("        " + command.name + ") options="), std::string::npos)
            << command.name;
    }
}

TEST(Arguments, HoldWhatARunIsAskedFor) {
    const Arguments arguments{run_command(),
                              {"a.ini", "--set", "run.seed=3", "--set=release.rocks=5", "--seed", "7",
                               "--threads", "2", "--out", "results", "--overwrite", "-q"}};
    EXPECT_EQ(arguments.only_word(), "a.ini");
    EXPECT_EQ(arguments.overrides(), (Words{"run.seed=3", "release.rocks=5", "run.seed=7"}));
    EXPECT_EQ(arguments.threads(), 2);
    EXPECT_EQ(arguments.out(), "results");
    EXPECT_TRUE(arguments.overwrite());
    EXPECT_TRUE(arguments.quiet());
    EXPECT_FALSE(arguments.verbose());
    EXPECT_FALSE(arguments.wants_help());
    EXPECT_TRUE((Arguments{run_command(), {"--help"}}.wants_help()));
}

TEST(Arguments, TakeOptionsBeforeTheWord) {
    EXPECT_EQ((Arguments{check_command(), {"--print-settings", "a.ini"}}.only_word()), "a.ini");
    EXPECT_EQ((Arguments{init_command(), {"--example", "tyrol", "folder"}}.only_word()), "folder");
}

TEST(Arguments, TakeOptionsThatMayComeAgain) {
    const Arguments table{stopping_table_command(), {"--surface", "a", "--surface", "b"}};
    EXPECT_EQ(table.texts("surface"), (Words{"a", "b"}));
    const Arguments archive{pack_command(),
                            {"out", "--creator", "A", "--creator", "B", "--licence", "CC0-1.0"}};
    EXPECT_EQ(archive.texts("creator"), (Words{"A", "B"}));
    EXPECT_EQ(archive.text("licence"), "CC0-1.0");
}

TEST(Arguments, SortNumbersOfMetres) {
    const Arguments arguments{net_command(), {"place", "out", "--distances", "20,0,10"}};
    EXPECT_EQ(arguments.rising_metres("distances", {.low = 0.0, .high = 5000.0}),
              (std::vector<double>{0.0, 10.0, 20.0}));
    EXPECT_EQ((Arguments{stopping_table_command(), {"--throws", "1e4"}}.whole("throws", 10, 100'000)),
              10'000);
}

TEST(Arguments, MaySetHowResultsAreWritten) {
    EXPECT_EQ((Arguments{run_command(), {"a.ini", "--set", "output.xlsx=yes"}}.overrides()),
              Words{"output.xlsx=yes"});
}

}  // namespace
}  // namespace coupling::commands_test
