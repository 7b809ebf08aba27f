#include "coupling/commands/command_line.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"

namespace coupling::command_line_test {
namespace {

std::string message_of(const std::vector<std::string>& arguments) {
    try {
        parse_command_line(arguments);
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::settings);
        return error.what();
    }
    return "";
}

TEST(CommandLine, HoldsWhatARunIsAskedFor) {
    const CommandLine line =
        parse_command_line({"run", "a.ini", "--set", "run.seed=3", "--set=release.rocks=5", "--seed", "7",
                            "--threads", "2", "--out", "results", "--overwrite", "-q"});
    EXPECT_EQ(line.command, "run");
    EXPECT_EQ(line.argument, "a.ini");
    EXPECT_EQ(line.overrides, (std::vector<std::string>{"run.seed=3", "release.rocks=5", "run.seed=7"}));
    EXPECT_EQ(line.threads, 2);
    EXPECT_EQ(line.out, "results");
    EXPECT_TRUE(line.overwrite);
    EXPECT_TRUE(line.quiet);
    EXPECT_FALSE(line.verbose);
}

TEST(CommandLine, TakesOptionsBeforeItsArgument) {
    EXPECT_EQ(parse_command_line({"check", "--print-settings", "a.ini"}).argument, "a.ini");
    EXPECT_EQ(parse_command_line({"init", "--example", "tyrol", "folder"}).argument, "folder");
}

TEST(CommandLine, HoldsWhatAStoppingTableIsAskedFor) {
    const CommandLine line = parse_command_line({"stopping-table", "mine.csv", "--out", "made", "--surface",
                                                 "a", "--surface", "b", "--diameters", "1,0.5", "--throws",
                                                 "1e4", "--surfaces", "8", "--seed", "7", "--pictures"});
    EXPECT_EQ(line.command, "stopping-table");
    EXPECT_EQ(line.argument, "mine.csv");
    EXPECT_EQ(line.surface_names, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(line.diameters_m, (std::vector<double>{0.5, 1.0}));
    EXPECT_EQ(line.throws, 10'000U);
    EXPECT_EQ(line.surfaces, 8U);
    EXPECT_EQ(line.seed, 7U);
    EXPECT_TRUE(line.pictures);
    EXPECT_TRUE(parse_command_line({"stopping-table", "--out", "made"}).argument.empty());
}

TEST(CommandLine, HoldsWhatAnArchiveIsAskedFor) {
    const CommandLine line = parse_command_line(
        {"pack", "out", "--creator", "A", "--creator", "B", "--licence", "CC0-1.0", "--date", "2026-01-02"});
    EXPECT_EQ(line.argument, "out");
    EXPECT_EQ(line.creators, (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(line.date, "2026-01-02");
    EXPECT_EQ(message_of({"pack", "out", "--date", "May"}),
              "found --date 'May', expected a day such as 2026-05-31");
    EXPECT_TRUE(parse_command_line({"verify", "a.zip", "--rerun"}).rerun);
}

TEST(CommandLine, RefusesAStoppingTableThatCannotBeMade) {
    EXPECT_EQ(message_of({"stopping-table"}),
              "found `bannwald stopping-table` without a folder for the table, expected --out DIR");
    EXPECT_EQ(message_of({"stopping-table", "--out", "a", "--diameters", "0.5,0.5"}),
              "found --diameters '0.5,0.5', expected different numbers, separated by commas");
    EXPECT_EQ(message_of({"stopping-table", "--out", "a", "--diameters", "0,x"}),
              "found --diameters '0,x', expected numbers in (0, 10] m, separated by commas");
    EXPECT_EQ(message_of({"stopping-table", "--out", "a", "--surfaces", "3"}),
              "found --surfaces '3', expected a whole number in [4, 10000]");
    EXPECT_EQ(message_of({"stopping-table", "a.csv", "b.csv", "--out", "a"}),
              "found 'b.csv' after 'a.csv', expected only a recipe");
}

TEST(CommandLine, AsksForHelpBeforeAnythingElse) {
    EXPECT_EQ(parse_command_line({}).command, "help");
    EXPECT_EQ(parse_command_line({"--version"}).command, "version");
    EXPECT_EQ(parse_command_line({"--help-all"}).command, "help-all");
    EXPECT_EQ(parse_command_line({"--help-all", "regimes"}).section, "regimes");
    const CommandLine line = parse_command_line({"run", "--help"});
    EXPECT_EQ(line.command, "help");
    EXPECT_EQ(line.help_for, "run");
}

TEST(CommandLine, TellsTheNearestWord) {
    EXPECT_EQ(message_of({"chek", "a.ini"}), "found command 'chek', expected 'check'");
    EXPECT_EQ(message_of({"run", "a.ini", "--treads", "2"}),
              "found option '--treads' of run, expected '--threads'");
    EXPECT_EQ(message_of({"xyz"}),
              "found command 'xyz', expected init, check, run, merge, compare, vary, collapse, pack, "
              "verify, net, validate, stopping-table, info or completion; see `bannwald --help`");
}

TEST(CommandLine, TellsWhereTheFolderOfTheResultsIsNamed) {
    EXPECT_EQ(message_of({"run", "a.ini", "--set", "output.dir=here"}),
              "found --set output.dir=here, expected --out DIR: the folder of the results is no setting");
    EXPECT_EQ(message_of({"run", "a.ini", "--set", "output.xlsx=yes"}), "");
}

TEST(CommandLine, KnowsWhatToDoWithNets) {
    const CommandLine line =
        parse_command_line({"net", "place", "out", "--nets", "n.csv", "--distances", "20,0,10"});
    EXPECT_EQ(line.action, "place");
    EXPECT_EQ(line.argument, "out");
    EXPECT_EQ(line.nets, "n.csv");
    EXPECT_EQ(line.distances_m, (std::vector<double>{0.0, 10.0, 20.0}));
    EXPECT_EQ(
        message_of({"net"}),
        "found `bannwald net` alone, expected `bannwald net try DIR --nets FILE`, or place instead of try");
    EXPECT_NE(message_of({"net", "try", "out"}), "");
    EXPECT_NE(message_of({"net", "try", "out", "--nets", "n.csv", "--distances", "1"}), "");
    EXPECT_EQ(parse_command_line({"net", "place", "out", "--nets", "n.csv", "--azimuth", "270"}).azimuth_deg,
              270.0);
    for (const char* azimuth : {"-1", "361", "north"}) {
        EXPECT_NE(message_of({"net", "place", "out", "--nets", "n.csv", "--azimuth", azimuth}), "")
            << azimuth;
    }
    EXPECT_NE(message_of({"net", "try", "out", "--nets", "n.csv", "--azimuth", "1"}), "");
}

TEST(CommandLine, TakesWhatHoldsEverywhereBeforeTheCommandToo) {
    const CommandLine line = parse_command_line({"-q", "--verbose", "run", "a.ini"});
    EXPECT_EQ(line.command, "run");
    EXPECT_EQ(line.argument, "a.ini");
    EXPECT_TRUE(line.quiet);
    EXPECT_TRUE(line.verbose);
    EXPECT_EQ(message_of({"-q"}), "found '-q' alone, expected a command; see `bannwald --help`");
    EXPECT_NE(message_of({"-q", "run", "a.ini", "-q"}), "");
}

TEST(CommandLine, RefusesWhatACommandDoesNotTake) {
    EXPECT_EQ(message_of({"check", "a.ini", "--pictures"}),
              "found option '--pictures' of check, expected one of `bannwald check --help`");
    EXPECT_EQ(message_of({"run"}), "found `bannwald run` alone, expected a scenario file after it");
    EXPECT_EQ(message_of({"run", "a.ini", "b.ini"}),
              "found 'b.ini' after 'a.ini', expected only a scenario file");
    EXPECT_EQ(message_of({"run", "a.ini", "--threads", "-1"}),
              "found --threads '-1', expected a whole number in [1, 4096]");
    EXPECT_NE(message_of({"run", "a.ini", "--out"}), "");
    EXPECT_NE(message_of({"run", "a.ini", "--over"}), "");  // no guessing by the first letters
    EXPECT_NE(message_of({"run", "a.ini", "--threads", "1", "--threads", "2"}), "");
}

}  // namespace
}  // namespace coupling::command_line_test
