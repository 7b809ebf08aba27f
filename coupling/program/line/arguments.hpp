#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "coupling/program/line/command.hpp"

namespace coupling {

/// Ends the program with the exit code of usage.
[[noreturn]] void refuse_usage(std::string found, std::string expected);

/// The words after a command, held against its options. What stands in them is checked where it is asked
/// for; everything here throws InputError (settings).
class Arguments {
public:
    /// Throws for options that the command does not take, with the nearest one, for a missing value and for
    /// an option that comes twice.
    Arguments(const Command& command, const std::vector<std::string>& words);

    [[nodiscard]] bool has(const std::string& option) const { return options_.contains(option); }
    /// The value of an option; empty without it.
    [[nodiscard]] std::string text(const std::string& option) const;
    /// The values of an option that may come again.
    [[nodiscard]] std::vector<std::string> texts(const std::string& option) const;
    /// The whole number of an option within bounds; nothing without it.
    [[nodiscard]] std::optional<long long> whole(const std::string& option, long long low,
                                                 long long high) const;
    /// Numbers of metres separated by commas, in rising order, each once; none without the option.
    [[nodiscard]] std::vector<double> rising_metres(const std::string& option,
                                                    const config::NumberRange& range) const;

    /// What is no option.
    [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
    /// The one word that the command asks for.
    [[nodiscard]] std::string only_word() const;

    // Options that several commands take alike.
    [[nodiscard]] bool wants_help() const { return has("help"); }
    [[nodiscard]] bool quiet() const { return has("quiet"); }
    [[nodiscard]] bool verbose() const { return has("verbose"); }
    [[nodiscard]] bool overwrite() const { return has("overwrite"); }
    [[nodiscard]] std::filesystem::path out() const { return text("out"); }
    /// 0 without the option: as many as the machine has.
    [[nodiscard]] int threads() const;
    /// The settings of --set, and --seed as one of the section `seed_section`. Refuses a folder for results,
    /// which is none.
    [[nodiscard]] std::vector<std::string> overrides(const std::string& seed_section = "run") const;

private:
    std::string command_;
    std::string argument_;
    std::map<std::string, std::vector<std::string>> options_;
    std::vector<std::string> words_;
};

}  // namespace coupling
