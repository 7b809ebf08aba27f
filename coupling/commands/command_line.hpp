#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/text/language.hpp"
#include "coupling/commands/init_from_files.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

/// A call of the program, understood but not yet carried out.
struct CommandLine {
    std::string command;             ///< init, check, run, merge, validate, ...; help, help-all or version
    std::string help_for;            ///< command whose help is wanted, "" for the short help
    std::filesystem::path argument;  ///< folder, scenario or file
    std::string example = "tyrol";
    std::filesystem::path rockyfor3d;    ///< init: folder to make the project from; empty: the example
    GivenFiles given;                    ///< init: files to make the project from; no dem: the example
    std::vector<std::string> overrides;  ///< section.key=value, --seed among them
    std::filesystem::path out;
    int threads = 0;  ///< 0: as many as the machine has
    bool overwrite = false;
    bool print_settings = false;
    bool quiet = false;
    bool verbose = false;

    // help-all
    std::string section;  ///< of the settings; empty: everything

    // info; the argument is the file, or `tables` for the tables of results
    std::string table;  ///< of the results; none: the list of them

    // run
    Shard shard;

    // merge, where the argument is the scenario; compare
    std::vector<std::filesystem::path> folders;
    std::filesystem::path page;                ///< compare, check: HTML file; empty: none
    std::optional<config::Language> language;  ///< of the page of compare; none: that of the first run

    // vary, where the argument is the scenario
    std::filesystem::path factors;

    // pack, where the argument is the folder of a run; verify, where it is an archive
    std::filesystem::path scenario;  ///< empty: the file beside the folder
    std::string title;
    std::vector<std::string> creators;
    std::string licence;
    std::string date;    ///< YYYY-MM-DD, empty: when the run ended
    bool rerun = false;  ///< verify: repeats the run and compares

    // net, where the argument is the folder of a run
    std::string action;  ///< try or place
    std::filesystem::path nets;
    std::vector<double> distances_m;    ///< rising; none: the usual ones
    std::optional<double> azimuth_deg;  ///< upslope, clockwise from north; none: where rocks come from

    // validate
    std::vector<std::string> cases;  ///< names; none: all
    std::filesystem::path cases_folder;
    std::filesystem::path profile;
    std::optional<std::uint64_t> rocks;
    bool list = false;

    // stopping-table; the argument is the recipe, empty: the shipped one
    std::vector<std::string> surface_names;  ///< none: all of the recipe
    std::vector<double> diameters_m;         ///< rising; none: the usual ones
    std::optional<std::uint32_t> throws;
    std::optional<std::uint32_t> surfaces;
    std::optional<std::uint64_t> seed;
    bool pictures = false;
};

/// Understands the arguments after the program's name. Throws InputError (settings) for an unknown command or
/// option with the nearest one, and for what a command does not take.
CommandLine parse_command_line(const std::vector<std::string>& arguments);

/// Names of the commands.
const std::vector<std::string>& command_names();

/// Options of a command with their dashes, such as "--set". Requires a name of the list.
std::vector<std::string> option_words(const std::string& command);

}  // namespace coupling
