#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "coupling/run/ranks.hpp"

namespace coupling {

class Arguments;
struct Command;

/// What the Tab key offers.
struct Completion {
    enum class Names : std::uint8_t { none, files, folders };
    Names names = Names::none;
    std::vector<std::string> (*words)() = nullptr;  ///< words beside them; none: no words
    bool settings = false;                          ///< words that a value follows at once, as those of --set
};

/// An option of a command. All commands have --help, --quiet and --verbose.
struct CommandOption {
    std::string name;  ///< without dashes
    Completion completion = {};
    bool is_switch = false;  ///< takes no value
    bool may_come_again = false;
};

/// Where a command is carried out.
struct Call {
    const std::vector<Command>& commands;  ///< all of the program
    std::ostream& out;
    RankGroup& ranks;
};

/// A command of the program. Whoever adds one writes a function that returns it and adds that to the list:
/// short help, help, completion, the check of its options and the nearest words follow.
struct Command {
    std::string name;
    std::string overview;  ///< its lines of the short help
    std::string help;      ///< all of `bannwald NAME --help`
    std::string argument;  ///< what the one word after it is; empty: it reads its words itself
    std::vector<CommandOption> options;
    Completion completion;  ///< of the words after it
    /// Returns the exit code. Throws config::InputError.
    std::function<int(const Arguments&, const Call&)> run;

    bool is_shared = false;  ///< processes of mpirun share the work; else the first one does it alone
    std::function<void(std::ostream&)> more_help{};  ///< what follows its help
    /// Settings of files of its own for --help-all: calls `use` with the settings and the name of a section.
    using UseOfSettings = std::function<void(const config::Options&, const std::string& section)>;
    std::function<void(const UseOfSettings& use)> own_settings{};
    std::string own_settings_title{};
};

/// The options that several commands take alike, with their lines of the help.
CommandOption set_option();
CommandOption seed_option();
CommandOption threads_option();
CommandOption out_folder_option();
CommandOption overwrite_option();
extern const char* const help_of_set_and_seed;
extern const char* const help_of_threads;

/// "example", a folder or file beside it, and other options that one command has.
CommandOption option_with_value(std::string name, Completion completion = {});
CommandOption switch_option(std::string name);

}  // namespace coupling
