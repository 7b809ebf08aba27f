#include "coupling/program/commands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "config/errors/input_error.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/program/line/completion.hpp"
#include "coupling/program/line/help.hpp"

namespace coupling::commands_test {
namespace {

using Words = std::vector<std::string>;

/// What is wrong with a call, which must fail before it does anything; "" if nothing is.
std::string message_of(const Command& command, const Words& words) {
    const std::vector<Command> commands = commands_of_the_program();
    std::ostringstream out;
    RankGroup ranks{RankGroup::Alone{}};
    try {
        command.run(Arguments{command, words}, {commands, out, ranks});
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::settings);
        return error.what();
    }
    return "";
}

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

TEST(Commands, RefuseAStoppingTableThatCannotBeMade) {
    const Command table = stopping_table_command();
    EXPECT_EQ(message_of(table, {}),
              "found `bannwald stopping-table` without a folder for the table, expected --out DIR");
    EXPECT_EQ(message_of(table, {"--out", "a", "--diameters", "0.5,0.5"}),
              "found --diameters '0.5,0.5', expected different numbers, separated by commas");
    EXPECT_EQ(message_of(table, {"--out", "a", "--diameters", "0,x"}),
              "found --diameters '0,x', expected numbers in (0, 10] m, separated by commas");
    EXPECT_EQ(message_of(table, {"--out", "a", "--surfaces", "3"}),
              "found --surfaces '3', expected a whole number in [4, 10000]");
    EXPECT_EQ(message_of(table, {"a.csv", "b.csv", "--out", "a"}),
              "found 'b.csv' after 'a.csv', expected only a recipe");
}

TEST(Commands, RefuseADayThatIsNone) {
    EXPECT_EQ(message_of(pack_command(), {"out", "--date", "May"}),
              "found --date 'May', expected a day such as 2026-05-31");
}

TEST(Commands, NameTheNearestOption) {
    EXPECT_EQ(message_of(run_command(), {"a.ini", "--treads", "2"}),
              "found option '--treads' of run, expected '--threads'");
    EXPECT_EQ(message_of(check_command(), {"a.ini", "--pictures"}),
              "found option '--pictures' of check, expected one of `bannwald check --help`");
}

TEST(Commands, SayWhereTheFolderOfTheResultsIsNamed) {
    EXPECT_EQ(message_of(run_command(), {"a.ini", "--set", "output.dir=here"}),
              "found --set output.dir=here, expected --out DIR: the folder of the results is no setting");
    EXPECT_EQ((Arguments{run_command(), {"a.ini", "--set", "output.xlsx=yes"}}.overrides()),
              Words{"output.xlsx=yes"});
}

TEST(Commands, RefuseNetsThatNobodyCanPlace) {
    const Command net = net_command();
    EXPECT_EQ(
        message_of(net, {}),
        "found `bannwald net` alone, expected `bannwald net try DIR --nets FILE`, or place instead of try");
    EXPECT_NE(message_of(net, {"try", "out"}), "");
    EXPECT_NE(message_of(net, {"try", "out", "--nets", "n.csv", "--distances", "1"}), "");
    EXPECT_NE(message_of(net, {"try", "out", "--nets", "n.csv", "--azimuth", "1"}), "");
    for (const char* azimuth : {"-1", "361", "north"}) {
        EXPECT_NE(message_of(net, {"place", "out", "--nets", "n.csv", "--azimuth", azimuth}), "") << azimuth;
    }
}

TEST(Commands, RefuseWhatTheyDoNotTake) {
    const Command run = run_command();
    EXPECT_EQ(message_of(run, {}), "found `bannwald run` alone, expected a scenario file after it");
    EXPECT_EQ(message_of(run, {"a.ini", "b.ini"}),
              "found 'b.ini' after 'a.ini', expected only a scenario file");
    EXPECT_EQ(message_of(run, {"a.ini", "--threads", "-1"}),
              "found --threads '-1', expected a whole number in [1, 4096]");
    EXPECT_NE(message_of(run, {"a.ini", "--shard", "3/2"}), "");
    EXPECT_NE(message_of(run, {"a.ini", "--out"}), "");
    EXPECT_NE(message_of(run, {"a.ini", "--over"}), "");  // no guessing by the first letters
    EXPECT_NE(message_of(run, {"a.ini", "--threads", "1", "--threads", "2"}), "");
    EXPECT_NE(message_of(run, {"a.ini", "-q", "-q"}), "");
    EXPECT_NE(message_of(merge_command(), {"a.ini"}), "");
    EXPECT_NE(message_of(vary_command(), {"a.ini", "--out", "a"}), "");
    EXPECT_NE(message_of(compare_command(), {"a"}), "");
    EXPECT_NE(message_of(compare_command(), {"a", "b", "--language", "de"}), "");
    EXPECT_NE(message_of(init_command(), {"a", "--trees", "t.csv"}), "");
    EXPECT_NE(message_of(init_command(), {"a", "--example", "tyrol", "--dem", "d.asc"}), "");
}

}  // namespace
}  // namespace coupling::commands_test
