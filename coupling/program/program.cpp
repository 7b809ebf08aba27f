#include "coupling/program/program.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>

#include "config/errors/brief.hpp"
#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/program/line/help.hpp"
#include "coupling/run/ranks.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

constexpr int done = static_cast<int>(ExitCode::done);

/// What the program is asked for without a command: nothing else is left to do.
void answer(const std::vector<Command>& commands, const std::string& word,
            const std::vector<std::string>& rest, std::ostream& out) {
    if (word == "--help" || word == "-h" || word == "help") {
        write_short_help(commands, out);
    } else if (word == "--help-all") {
        write_help_all(commands, rest.empty() ? "" : rest.front(), out);
    } else if (word == "--version") {
        write_version(out);
    } else {
        std::vector<std::string> words{"--help", "--help-all", "--version"};
        std::string names;
        for (const Command& command : commands) {
            words.push_back(command.name);
            names += joined(command.name, &command == &commands.back() ? "" : ", ");
        }
        const std::string nearest = config::nearest_word(word, words);
        refuse_usage(joined("command ", config::in_quotes(word)),
                     nearest.empty() ? joined("one of ", names, "; see `bannwald --help`")
                                     : config::in_quotes(nearest));
    }
}

int carry_out(const std::vector<Command>& commands, const std::vector<std::string>& arguments,
              RankGroup& ranks) {
    // What every command takes may stand before it too.
    const auto word = std::find_if(arguments.begin(), arguments.end(), [](const std::string& each) {
        return each != "-q" && each != "--quiet" && each != "-v" && each != "--verbose";
    });
    if (word == arguments.end() && !arguments.empty()) {
        refuse_usage(joined(config::in_quotes(arguments.front()), " alone"),
                     "a command; see `bannwald --help`");
    }
    const std::string name = arguments.empty() ? "--help" : *word;
    std::vector<std::string> rest;
    if (!arguments.empty()) {
        rest.assign(word + 1, arguments.end());
        rest.insert(rest.end(), arguments.begin(), word);
    }
    const auto command = std::find_if(commands.begin(), commands.end(),
                                      [&](const Command& each) { return each.name == name; });
    const bool works_here = ranks.first() || (command != commands.end() && command->is_shared);
    if (command == commands.end()) {
        if (works_here) {
            answer(commands, name, rest, std::cout);
        }
        return done;
    }
    const Arguments of_command{*command, rest};
    if (!works_here) {
        return done;
    }
    if (of_command.wants_help()) {
        write_help(*command, std::cout);
        return done;
    }
    return command->run(of_command, {commands, std::cout, ranks});
}

/// Of many problems of a kind the first and their number, all of them with --verbose.
void print_problems(const config::InputError& error, const std::vector<std::string>& arguments) {
    const bool verbose = std::any_of(arguments.begin(), arguments.end(), [](const std::string& word) {
        return word == "-v" || word == "--verbose";
    });
    if (!verbose) {
        for (const config::BriefMessage& message : config::brief(error.problems())) {
            std::cerr << "bannwald: " << config::to_string(message) << '\n';
        }
        return;
    }
    for (const config::Problem& problem : error.problems()) {
        std::cerr << "bannwald: " << config::to_string(problem) << '\n';
    }
}

}  // namespace

int run_program(const std::vector<Command>& commands, const std::vector<std::string>& arguments) {
    std::optional<RankGroup> ranks;
    // Of several ranks that fail one prints why; then all leave together.
    const auto speaks = [&] { return !ranks || ranks->fail(true); };
    int result = done;
    try {
        ranks.emplace();
        result = carry_out(commands, arguments, *ranks);
        std::cout.flush();
        if (!std::cout) {
            std::cerr << "bannwald: cannot write to the standard output\n";
            result = static_cast<int>(ExitCode::file);
        }
    } catch (const FailedElsewhere&) {
        ranks->fail(false);
    } catch (const config::InputError& error) {
        if (speaks()) {
            print_problems(error, arguments);
            result = static_cast<int>(error.code());
        }
    } catch (const std::filesystem::filesystem_error& error) {
        if (speaks()) {
            const std::string name = error.path1().empty() ? "the current folder" : error.path1().string();
            std::cerr << "bannwald: " << name << ": found a name that the file system refuses ("
                      << error.code().message()
                      << "), expected one that can be read and written; check its length, its links and your "
                         "permissions\n";
            result = static_cast<int>(ExitCode::file);
        }
    } catch (const std::exception& error) {
        if (speaks()) {
            const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
            std::cerr << (memory ? "bannwald: not enough memory; `bannwald check` prints how much a run takes"
                                 : joined("bannwald: a fault of the program: ", error.what()))
                      << '\n';
            result = static_cast<int>(ExitCode::internal);
        }
    }
    return ranks ? ranks->leave_with(result) : result;
}

}  // namespace coupling
