#include "coupling/commands/completion.hpp"

#include <string_view>
#include <vector>

#include "config/data/shipped_tables.hpp"
#include "config/errors/input_error.hpp"
#include "coupling/commands/command_line.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/regimes/shipped.hpp"
#include "coupling/validation/case_files.hpp"

namespace coupling {
namespace {

constexpr std::string_view opening =
    R"script(# Completion of bannwald for bash:  eval "$(bannwald completion bash)"
_bannwald_words() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word")
}
_bannwald_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$1" -- "$word")
}
_bannwald() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} options=
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        _bannwald_words "$_bannwald_commands --help --help-all --version"
        return
    fi
    case $command in
)script";

constexpr std::string_view middle = R"script(    esac
    case $before in
        --example) _bannwald_words "$_bannwald_examples"; return ;;
        --set) compopt -o nospace 2>/dev/null; _bannwald_words "$_bannwald_settings"; return ;;
        --page) _bannwald_files -f; return ;;
        --language) _bannwald_words "en de fr it"; return ;;
        --out) if [ "$command" = compare ] || [ "$command" = pack ]; then _bannwald_files -f; else _bannwald_files -d; fi; return ;;
        --cases) _bannwald_files -d; return ;;
        --profile|--nets|--scenario) _bannwald_files -f; return ;;
        --seed|--threads|--shard|--rocks|--surface|--surfaces|--diameters|--throws|--distances|--azimuth|--title|--creator|--licence|--date) return ;;
    esac
    if [[ $word == -* ]]; then
        _bannwald_words "$options"
        return
    fi
    case $command in
        init|compare|pack) _bannwald_files -d ;;
        net) if [ "$COMP_CWORD" -eq 2 ]; then _bannwald_words "try place"; else _bannwald_files -d; fi ;;
        validate) _bannwald_words "all $_bannwald_cases" ;;
        completion) _bannwald_words bash ;;
        info)
            if [ "$before" = tables ]; then
                return
            fi
            _bannwald_files -f
            mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "tables regimes $_bannwald_tables" -- "$word") ;;
        *) _bannwald_files -f ;;
    esac
}
complete -F _bannwald bannwald
)script";

void write_words(std::ostream& out, const char* variable, const std::vector<std::string>& words) {
    out << variable << "=\"";
    const char* separator = "";
    for (const std::string& word : words) {
        out << separator << word;
        separator = " ";
    }
    out << "\"\n";
}

/// As --set takes them, up to the value.
std::vector<std::string> settings() {
    Scenario scenario;
    config::Options options;
    declare(options, scenario);
    std::vector<std::string> keys;
    for (const config::ParameterRow& row : options.rows()) {
        keys.push_back(row.key + '=');
    }
    return keys;
}

std::vector<std::string> table_names() {
    std::vector<std::string> names;
    for (const std::string& table : config::shipped_table_names()) {
        names.push_back(table.substr(0, table.rfind('.')));
    }
    const std::vector<std::string> regimes = shipped_regime_names();
    names.insert(names.end(), regimes.begin(), regimes.end());
    return names;
}

std::vector<std::string> cases() {
    std::vector<std::string> names;
    for (const validation::CaseFiles& files : validation::shipped_cases()) {
        names.push_back(files.name);
    }
    return names;
}

}  // namespace

void write_completion(const std::string& shell, std::ostream& out) {
    if (shell != "bash") {
        config::fail(config::ExitCode::settings, {}, "shell " + config::in_quotes(shell), "bash");
    }
    write_words(out, "_bannwald_commands", command_names());
    write_words(out, "_bannwald_examples", example_names());
    write_words(out, "_bannwald_settings", settings());
    write_words(out, "_bannwald_tables", table_names());
    write_words(out, "_bannwald_cases", cases());
    out << opening;
    for (const std::string& command : command_names()) {
        out << "        " << command << ") options=\"-q -v";
        for (const std::string& word : option_words(command)) {
            out << ' ' << word;
        }
        out << "\" ;;\n";
    }
    out << middle;
}

}  // namespace coupling
