#include "coupling/inputs/scenario/scenario_file.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/files/folder_names.hpp"
#include "coupling/inputs/files/path_checks.hpp"

namespace coupling {
namespace {

using config::NamesFiles;

/// An override of the command line as the settings name its place.
constexpr std::string_view override_sign = "--set ";

std::string without_blanks(const std::string& word) {
    const auto first = word.find_first_not_of(" \t");
    return first == std::string::npos ? "" : word.substr(first, word.find_last_not_of(" \t") + 1 - first);
}

/// Whether an entry of a list of files and shipped names is a file.
bool is_file_entry(const std::string& entry) {
    return entry.find('.') != std::string::npos;
}

/// Settings that name one or several files of one kind.
bool takes_several_files(const std::string& key) {
    constexpr std::array keys{
        "terrain.dem", "terrain.surface_polygons", "release.source_shapes", "targets.file", "nets.file",
        "works.file",  "calibrate.sites"};
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// A value with every file in it by its name for results.
std::string shown_value(const config::ParameterRow& row, const ScenarioFile& scenario) {
    const std::string& value = row.value_text;
    if (row.files == NamesFiles::none) {
        return value;
    }
    std::string text;
    if (row.files == NamesFiles::one) {
        for (const std::string& entry : files_in(row)) {
            text += config::joined(text.empty() ? "" : ", ", scenario.shown(entry));
        }
        return text;
    }
    std::istringstream words{value};
    for (std::string word; std::getline(words, word, ',');) {
        const std::string entry = without_blanks(word);
        text +=
            config::joined(text.empty() ? "" : ", ", is_file_entry(entry) ? scenario.shown(entry) : entry);
    }
    return text;
}

}  // namespace

std::vector<std::string> list_of_files(const std::string& value) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin < value.size();) {
        const std::size_t end = std::min(value.find(", ", begin), value.size());
        if (std::string entry = without_blanks(value.substr(begin, end - begin)); !entry.empty()) {
            names.push_back(std::move(entry));
        }
        begin = end + 2;
    }
    return names;
}

std::vector<std::string> files_in(const config::ParameterRow& row) {
    const std::string& value = row.value_text;
    if (row.files == NamesFiles::none || value.empty()) {
        return {};
    }
    if (row.files == NamesFiles::one) {
        return takes_several_files(row.key) ? list_of_files(value) : std::vector{value};
    }
    std::vector<std::string> names;
    std::istringstream words{value};
    for (std::string word; std::getline(words, word, ',');) {
        if (const std::string entry = without_blanks(word); is_file_entry(entry)) {
            names.push_back(entry);
        }
    }
    return names;
}

namespace {

/// The files of the settings: by their names for results, and as they are written.
std::vector<std::pair<std::string, std::string>> written_and_shown(const ScenarioFile& scenario) {
    std::vector<std::pair<std::string, std::string>> files;
    if (scenario.options != nullptr) {
        for (const config::ParameterRow& row : scenario.options->rows()) {
            for (const std::string& name : files_in(row)) {
                files.emplace_back(scenario.shown(name), name);
            }
        }
    }
    return files;
}

}  // namespace

void name_inputs(const ScenarioFile& scenario) {
    for (const config::ParameterRow& row : scenario.options->rows()) {
        for (const std::string& name : files_in(row)) {
            (void)scenario.shown(name);
        }
    }
}

std::filesystem::path ScenarioFile::resolve(const std::string& name) const {
    const std::filesystem::path path{name};
    const std::filesystem::path from_here = path.is_absolute() ? path : file.parent_path() / path;
    const std::filesystem::path plain = from_here.lexically_normal();
    // "a/../b" is "b" only where a is no link to another folder.
    std::error_code one;
    std::error_code other;
    const bool is_same =
        std::filesystem::weakly_canonical(from_here, one) == std::filesystem::weakly_canonical(plain, other);
    std::filesystem::path resolved = is_same && !one && !other ? plain : from_here;
    if (!inputs_within.empty() && !name.empty() && !is_within(resolved, inputs_within)) {
        config::fail(config::ExitCode::data, {file.string()},
                     config::joined("the input ", path_in_quotes(name), ", a file outside of the archive"),
                     "inputs inside of the archive alone: its run reads nothing else",
                     "run its scenario by hand if you trust it");
    }
    return resolved;
}

std::string ScenarioFile::shown(const std::string& name) const {
    return names->shown(name, resolve(name), file.parent_path());
}

config::Place ScenarioFile::shown(config::Place place) const {
    if (place.file == file.string()) {
        place.file = file.filename().string();
    }
    return place;
}

std::vector<config::ParameterRow> ScenarioFile::shown_settings() const {
    if (options == nullptr) {
        return {};
    }
    std::vector<config::ParameterRow> rows = options->rows();
    for (config::ParameterRow& row : rows) {
        row.value_text = shown_value(row, *this);
    }
    return rows;
}

std::vector<config::Problem> ScenarioFile::paths_in(std::vector<config::Problem> problems) const {
    // What is to be written stands in the scenario, so it is named from there.
    const FolderNames folders = folder_names(*names, written_and_shown(*this));
    for (config::Problem& problem : problems) {
        problem.place.file = names->path_of(problem.place.file);
        for (std::string* text : {&problem.found, &problem.expected, &problem.advice}) {
            *text = with_folder_names(std::move(*text), folders);
        }
    }
    return problems;
}

std::vector<std::string> ScenarioFile::shown_overrides() const {
    std::vector<std::string> overrides;
    if (options == nullptr) {
        return overrides;
    }
    const auto add = [&](const config::Place& place) {
        if (place.file.starts_with(override_sign)) {
            overrides.push_back(place.file.substr(override_sign.size()));
        }
    };
    for (const config::ParameterRow& row : options->rows()) {
        if (!options->was_set(row.key)) {
            continue;
        }
        const config::Place place = options->place_of(row.key);
        if (row.files == NamesFiles::none) {
            add(place);
        } else if (place.file.starts_with(override_sign)) {
            overrides.push_back(config::joined(row.key, "=", shown_value(row, *this)));
        }
    }
    for (const config::FreeEntry& entry : options->free_entries()) {
        add(entry.place);
    }
    return overrides;
}

}  // namespace coupling
