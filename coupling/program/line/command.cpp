#include "coupling/program/line/command.hpp"

#include <utility>

#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {
namespace {

/// As --set takes them, up to the value.
std::vector<std::string> setting_words() {
    Scenario scenario;
    config::Options options;
    declare(options, scenario);
    std::vector<std::string> keys;
    for (const config::ParameterRow& row : options.rows()) {
        keys.push_back(row.key + '=');
    }
    return keys;
}

}  // namespace

const char* const help_of_set_and_seed =
    R"(  --set section.key=value   changes a setting; again for more
  --seed N                  the same as --set run.seed=N
)";

const char* const help_of_threads =
    R"(  --threads N               threads to use; results do not depend on it (default: all of the machine)
)";

CommandOption option_with_value(std::string name, Completion completion) {
    return {std::move(name), completion};
}

CommandOption switch_option(std::string name) {
    return {.name = std::move(name), .is_switch = true};
}

CommandOption set_option() {
    return {.name = "set", .completion = {.words = setting_words, .settings = true}, .may_come_again = true};
}

CommandOption seed_option() {
    return option_with_value("seed");
}

CommandOption threads_option() {
    return option_with_value("threads");
}

CommandOption out_folder_option() {
    return option_with_value("out", {Completion::Names::folders});
}

CommandOption overwrite_option() {
    return switch_option("overwrite");
}

}  // namespace coupling
