#include "coupling/program/line/completion.hpp"

#include <algorithm>
#include <string_view>

#include "config/errors/input_error.hpp"

namespace coupling {
namespace {

constexpr std::string_view opening =
    R"script(# Completion of bannwald for bash:  eval "$(bannwald completion bash)"
_bannwald_words() {
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$word")
}
_bannwald_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen "$1" -- "$word")
}
_bannwald_after_option() {
    case "$command $before" in
)script";

constexpr std::string_view before_commands = R"script(        *) return 1 ;;
    esac
}
_bannwald() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} options=
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        _bannwald_words "$_bannwald_commands --help --help-all --version"
        return
    fi
    if _bannwald_after_option; then
        return
    fi
    case $command in
)script";

constexpr std::string_view between_cases = R"script(    esac
    if [[ $word == -* ]]; then
        _bannwald_words "$options"
        return
    fi
    case $command in
)script";

constexpr std::string_view closing_of_script = R"script(    esac
}
complete -F _bannwald bannwald
)script";

std::string in_one_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        line += (line.empty() ? "" : " ") + word;
    }
    return line;
}

/// The words are written once, as a list of the script that has the name of what they complete.
std::string list_of(const std::string& what) {
    std::string name = "_bannwald_" + what;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// What fills the list of offers.
void write_offers(std::ostream& out, const Completion& completion, const std::string& list) {
    if (completion.settings) {
        out << " compopt -o nospace 2>/dev/null;";
    }
    if (completion.names != Completion::Names::none) {
        out << " _bannwald_files " << (completion.names == Completion::Names::files ? "-f" : "-d") << ';';
    }
    if (completion.words != nullptr) {
        out << " _bannwald_words \"$" << list << "\";";
    }
}

void write_list(std::ostream& out, const std::string& name, const std::vector<std::string>& words) {
    out << name << "=\"" << in_one_line(words) << "\"\n";
}

/// A list for each kind of words: options of several commands that complete alike share theirs.
void write_lists(const std::vector<Command>& commands, std::ostream& out) {
    std::vector<std::string> names;
    for (const Command& command : commands) {
        names.push_back(command.name);
    }
    write_list(out, "_bannwald_commands", names);
    std::vector<std::string> written;
    const auto write_once = [&](const std::string& name, const Completion& completion) {
        const bool is_new = std::find(written.begin(), written.end(), name) == written.end();
        if (completion.words != nullptr && is_new) {
            write_list(out, name, completion.words());
            written.push_back(name);
        }
    };
    for (const Command& command : commands) {
        write_once(list_of(command.name), command.completion);
        for (const CommandOption& option : command.options) {
            write_once(list_of("of_" + option.name), option.completion);
        }
    }
}

}  // namespace

void write_completion(const std::vector<Command>& commands, const std::string& shell, std::ostream& out) {
    if (shell != "bash") {
        config::fail(config::ExitCode::settings, {}, "shell " + config::in_quotes(shell), "bash");
    }
    write_lists(commands, out);
    out << opening;
    for (const Command& command : commands) {
        for (const CommandOption& option : command.options) {
            if (!option.is_switch) {
                out << "        '" << command.name << " --" << option.name << "')";
                write_offers(out, option.completion, list_of("of_" + option.name));
                out << " return 0 ;;\n";
            }
        }
    }
    out << before_commands;
    for (const Command& command : commands) {
        out << "        " << command.name << ") options=\"-q -v --help --quiet --verbose";
        for (const CommandOption& option : command.options) {
            out << " --" << option.name;
        }
        out << "\" ;;\n";
    }
    out << between_cases;
    for (const Command& command : commands) {
        out << "        " << command.name << ')';
        write_offers(out, command.completion, list_of(command.name));
        out << " return ;;\n";
    }
    out << closing_of_script;
}

}  // namespace coupling
