#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/program/line/completion.hpp"
#include "coupling/program/line/manual.hpp"

namespace coupling {
namespace {

constexpr const char* completion_help = R"help(bannwald completion bash | man

Prints a script for the shell bash: the Tab key then completes commands, options, examples, settings and files.
For this session:       eval "$(bannwald completion bash)"
For all to come:        bannwald completion bash > ~/.local/share/bash-completion/completions/bannwald
With `man` it prints the manual page instead:  bannwald completion man > bannwald.1 && man -l bannwald.1
)help";

std::vector<std::string> shell_words() {
    return {"bash", "man"};
}

int completion(const Arguments& arguments, const Call& call) {
    const std::string& wanted = arguments.only_word();
    if (wanted == "man") {
        write_man_page(call.commands, call.out);
    } else {
        write_completion(call.commands, wanted, call.out);
    }
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
        .argument = "bash or man",
        .options = {},
        .completion = {.words = shell_words},
        .run = completion};
}

}  // namespace coupling
