#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/program/line/completion.hpp"

namespace coupling {
namespace {

constexpr const char* completion_help = R"help(bannwald completion bash

Prints a script for the shell bash: the Tab key then completes commands, options, examples, settings and files.
For this session:       eval "$(bannwald completion bash)"
For all to come:        bannwald completion bash > ~/.local/share/bash-completion/completions/bannwald
)help";

std::vector<std::string> shell_words() {
    return {"bash"};
}

int completion(const Arguments& arguments, const Call& call) {
    write_completion(call.commands, arguments.only_word(), call.out);
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace

Command completion_command() {
    return {
        .name = "completion",
        .overview =
            R"(  bannwald completion bash             prints what lets the Tab key complete commands, options and settings
)",
        .help = completion_help,
        .argument = "bash",
        .options = {},
        .completion = {.words = shell_words},
        .run = completion};
}

}  // namespace coupling
