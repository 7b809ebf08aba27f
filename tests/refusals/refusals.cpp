#include "tests/refusals/refusals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "coupling/program/commands.hpp"
#include "coupling/program/program.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "tests/refusals/project.hpp"
#include "validation/engine/command.hpp"

namespace coupling::refusals {
namespace {

namespace fs = std::filesystem;

constexpr const char* command_sign = "$ bannwald ";
constexpr const char* exit_sign = "exit ";
constexpr const char* once_sign = "once ";

bool is_answer(const std::string& line) {
    return line.starts_with("bannwald: ") || line.starts_with(exit_sign);
}

/// The words of a command as a shell has them, with quotes of both kinds.
std::vector<std::string> words_of(const std::string& command) {
    std::vector<std::string> words;
    static const std::regex word{R"re('([^']*)'|"([^"]*)"|(\S+))re"};
    for (std::sregex_iterator at{command.begin(), command.end(), word}, end; at != end; ++at) {
        words.push_back((*at)[1].str() + (*at)[2].str() + (*at)[3].str());
    }
    return words;
}

/// One command, or both of "{check,run}".
std::vector<std::string> alternatives(const std::string& command) {
    static const std::regex both{R"((.*)\{(\w+),(\w+)\}(.*))"};
    std::smatch part;
    if (!std::regex_match(command, part, both)) {
        return {command};
    }
    return {part[1].str() + part[2].str() + part[4].str(), part[1].str() + part[3].str() + part[4].str()};
}

/// All files below a folder with their bytes.
std::map<std::string, std::string> files_in(const SampleProject& project) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator{project.folder()}) {
        const std::string name = fs::relative(entry.path(), project.folder()).string();
        files[name] = entry.is_regular_file() ? project.read(name) : "";
    }
    return files;
}

/// A folder that is the current one as long as this object lives.
class CurrentFolder {
public:
    explicit CurrentFolder(const fs::path& folder) : before_{fs::current_path()} { fs::current_path(folder); }
    CurrentFolder(const CurrentFolder&) = delete;
    CurrentFolder& operator=(const CurrentFolder&) = delete;
    ~CurrentFolder() { fs::current_path(before_); }

private:
    fs::path before_;
};

/// What the program prints on the standard error, and its exit code unless that is 0.
std::vector<std::string> answer_of(const SampleProject& project, const std::vector<std::string>& words) {
    std::vector<Command> commands = commands_of_the_program();
    commands.push_back(validation::validate_command());
    const CurrentFolder here{project.folder()};
    const auto before = files_in(project);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_program(commands, words);
    std::vector<std::string> lines;
    std::istringstream err{testing::internal::GetCapturedStderr()};
    const std::string out = testing::internal::GetCapturedStdout();
    for (std::string line; std::getline(err, line);) {
        lines.push_back(line);
    }
    if (code != 0) {
        lines.push_back(exit_sign + std::to_string(code));
        if (!out.empty()) {
            lines.push_back("on the standard output: " + out);
        }
    }
    if (files_in(project) != before) {
        lines.emplace_back("and files of the project are changed");
    }
    return lines;
}

/// Whether a line is the expected one, in which `<any>` stands for what depends on the machine.
bool is_as_expected(const std::string& printed, const std::string& expected) {
    const std::string any = "<any>";
    const std::size_t at = expected.find(any);
    if (at == std::string::npos) {
        return printed == expected;
    }
    const std::string rest = expected.substr(at + any.size());
    return printed.size() >= at + rest.size() && printed.starts_with(expected.substr(0, at)) &&
           printed.ends_with(rest);
}

/// Nothing, or the lines on both sides: those that differ between the first and the last that do.
std::string compared(const std::vector<std::string>& printed, const std::vector<std::string>& expected) {
    const auto [first_printed, first_expected] =
        std::mismatch(printed.begin(), printed.end(), expected.begin(), expected.end(), is_as_expected);
    if (first_printed == printed.end() && first_expected == expected.end()) {
        return "";
    }
    const auto [last_printed, last_expected] =
        std::mismatch(printed.rbegin(), std::make_reverse_iterator(first_printed), expected.rbegin(),
                      std::make_reverse_iterator(first_expected), is_as_expected);
    std::string text;
    const auto add = [&](const char* sign, auto first, auto last) {
        for (; first != last; ++first) {
            text += sign + *first + "\n";
        }
    };
    add("  ", printed.begin(), first_printed);
    add("- ", first_expected, last_expected.base());
    add("+ ", first_printed, last_printed.base());
    add("  ", last_printed.base(), printed.end());
    return text;
}

/// Warnings and notes of `check` stand on pages too, so that each needs a row of messages.csv.
std::string untranslated(const std::vector<std::string>& answer) {
    static const std::regex warning{R"(bannwald: (?:warning|note): (.*?)(?: \(and \d+ more like this.*)?)"};
    const report::WritingLanguage german{config::Language::de};
    std::string text;
    for (const std::string& line : answer) {
        std::smatch part;
        if (std::regex_match(line, part, warning) && !report::translated(part[1].str())) {
            text += "add a row to messages.csv: " + part[1].str() + "\n";
        }
    }
    return text;
}

/// What differs after a line with a command.
std::string differences_after(const SampleProject& project, const std::string& line,
                              const std::vector<std::string>& expected, const std::string& place) {
    std::string text;
    for (const std::string& command : alternatives(line)) {
        const auto answer = answer_of(project, words_of(command.substr(std::string{command_sign}.size())));
        const std::string found = compared(answer, expected) + untranslated(answer) + said_twice(answer);
        if (!found.empty()) {
            text += place + ": expected (-) and printed (+) after\n" + command + "\n" + found;
        }
    }
    return text;
}

}  // namespace

std::string said_twice(const std::vector<std::string>& answer) {
    static const std::regex missing{R"((.*: no column '[^']*') (?:among|\().*)"};
    std::set<std::string> said;
    std::string text;
    for (const std::string& line : answer) {
        std::smatch part;
        const std::string problem = std::regex_match(line, part, missing) ? part[1].str() : line;
        if (!said.insert(problem).second) {
            text += "said twice: " + problem + "\n";
        }
    }
    return text;
}

std::vector<Case> read_cases(std::istream& in, const std::string& file) {
    std::vector<Case> cases;
    Case common{file, "", "", {}};
    std::size_t number = 0;
    for (std::string text; std::getline(in, text);) {
        ++number;
        if (text.empty() || text.starts_with('#')) {
            continue;
        }
        if (text.starts_with("case ")) {
            cases.push_back(common);
            cases.back().title = text.substr(5);
        } else if (text.starts_with("project ")) {
            (cases.empty() ? common : cases.back()).project = text.substr(8);
        } else if (cases.empty() && (text.starts_with("$ ") || is_answer(text))) {
            throw std::runtime_error{file + ":" + std::to_string(number) +
                                     ": a command before the first case"};
        } else {
            (cases.empty() ? common : cases.back()).lines.push_back({number, text});
        }
    }
    return cases;
}

std::string differences(const Case& refusal) {
    const std::unique_ptr<SampleProject> project = make_project(refusal.project);
    std::string text;
    std::map<std::string, std::string> changed_once;  // files as they were
    for (auto line = refusal.lines.begin(); line != refusal.lines.end();) {
        const Line& first = *line++;
        const std::string place = refusal.file + ":" + std::to_string(first.number);
        if (first.text.starts_with(command_sign)) {
            std::vector<std::string> expected;
            for (; line != refusal.lines.end() && is_answer(line->text); ++line) {
                expected.push_back(line->text);
            }
            text += differences_after(*project, first.text, expected, place);
            for (const auto& [file, bytes] : changed_once) {
                project->write(file, bytes);
            }
            changed_once.clear();
            continue;
        }
        std::string content;
        for (; line != refusal.lines.end() && line->text.starts_with('|'); ++line) {
            content += line->text.substr(std::min<std::size_t>(2, line->text.size())) + "\n";
        }
        try {
            if (first.text.starts_with(once_sign)) {
                const std::string rest = first.text.substr(std::string{once_sign}.size());
                const std::string file = rest.substr(0, rest.find(':'));
                changed_once.try_emplace(file, project->read(file));
                change(*project, "replace " + rest, "");
            } else {
                change(*project, first.text, content);
            }
        } catch (const std::exception& error) {
            throw std::runtime_error{place + ": " + error.what() + ": " + first.text};
        }
    }
    return text;
}

}  // namespace coupling::refusals
