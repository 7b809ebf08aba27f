#include "coupling/commands/command_words.hpp"

#include "coupling/commands/command_line.hpp"

namespace coupling {

const std::map<std::string, std::vector<std::string>>& options_of_commands() {
    static const std::map<std::string, std::vector<std::string>> options{
        {"init", {"example", "from-rockyfor3d", "dem", "sources", "targets", "trees", "grounds"}},
        {"check", {"set", "seed", "threads", "print-settings", "page", "overwrite"}},
        {"run", {"set", "seed", "threads", "out", "overwrite", "shard"}},
        {"merge", {"set", "seed", "out", "overwrite"}},
        {"validate", {"set", "seed", "threads", "out", "overwrite", "cases", "profile", "rocks", "list"}},
        {"stopping-table",
         {"out", "surface", "diameters", "throws", "surfaces", "seed", "threads", "pictures", "overwrite"}},
        {"compare", {"out", "page", "language", "overwrite"}},
        {"vary", {"set", "seed", "threads", "out", "overwrite"}},
        {"collapse", {"set", "seed", "threads", "out", "overwrite"}},
        {"pack", {"set", "scenario", "title", "creator", "licence", "date", "out", "overwrite"}},
        {"verify", {"rerun", "out", "threads"}},
        {"net", {"nets", "distances", "azimuth", "out", "overwrite"}},
        {"info", {}},
        {"completion", {}},
    };
    return options;
}

const std::map<std::string, std::string>& arguments_of_commands() {
    static const std::map<std::string, std::string> arguments{
        {"init", "a folder"},           {"check", "a scenario file"},
        {"run", "a scenario file"},     {"collapse", "a scenario file"},
        {"stopping-table", "a recipe"}, {"info", "a file"},
        {"completion", "bash"},         {"pack", "the folder of a run"},
        {"verify", "an archive"}};
    return arguments;
}

const std::vector<std::string>& command_names() {
    static const std::vector<std::string> names{
        "init",   "check", "run",      "merge",          "compare", "vary",       "pack",
        "verify", "net",   "validate", "stopping-table", "info",    "completion", "collapse"};
    return names;
}

std::vector<std::string> option_words(const std::string& command) {
    std::vector<std::string> words{"--help", "--quiet", "--verbose"};
    for (const std::string& name : options_of_commands().at(command)) {
        words.push_back("--" + name);
    }
    return words;
}

}  // namespace coupling
