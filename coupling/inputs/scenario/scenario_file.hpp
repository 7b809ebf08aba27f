#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/options/options.hpp"
#include "coupling/inputs/files/input_names.hpp"

namespace coupling {

/// A scenario as a file: where it lies, what it says line by line, and how results name the files in it.
struct ScenarioFile {
    std::filesystem::path file;                ///< the scenario file itself
    std::filesystem::path inputs_within;       ///< not empty: files elsewhere are refused
    std::shared_ptr<config::Options> options;  ///< all of the above as declared, for listings and messages
    std::shared_ptr<InputNames> names = std::make_shared<InputNames>();

    /// Where a file that it names lies, from the working directory. Throws InputError (data) for
    /// one outside of `inputs_within`.
    [[nodiscard]] std::filesystem::path resolve(const std::string& name) const;
    /// The name of a file for results and messages in them: see InputNames.
    [[nodiscard]] std::string shown(const std::string& name) const;
    /// The same of a place in a file of the run, or in the scenario itself.
    [[nodiscard]] config::Place shown(config::Place place) const;
    /// The settings as results show them: files by their name for results. Empty without options.
    [[nodiscard]] std::vector<config::ParameterRow> shown_settings() const;
    /// The settings of the command line, "section.key=value", likewise.
    [[nodiscard]] std::vector<std::string> shown_overrides() const;

    /// Runs what reads inputs. Places of the problems that it throws name files for results; they leave as
    /// paths from the working directory, so that whoever called the program finds them.
    template <class Step>
    auto with_paths(Step step) const -> decltype(step()) {
        try {
            return step();
        } catch (const config::InputError& error) {
            throw config::InputError{paths_in(error.problems())};
        }
    }

private:
    [[nodiscard]] std::vector<config::Problem> paths_in(std::vector<config::Problem> problems) const;
};

/// The files of a setting, one after the other: all of its value, or, where it takes several, what stands
/// between a comma and a blank each (names may hold commas). In a list of files and shipped names the entries
/// without a dot are no files.
std::vector<std::string> files_in(const config::ParameterRow& row);

/// The same of the value of a setting that takes one or several files.
std::vector<std::string> list_of_files(const std::string& value);

/// Gives every file of the settings its name for results, in the order of the settings: so it depends on no
/// reader. Throws InputError (data) for files outside of `inputs_within`.
void name_inputs(const ScenarioFile& scenario);

}  // namespace coupling
