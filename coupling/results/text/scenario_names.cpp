#include "coupling/results/text/scenario_names.hpp"

#include <utility>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario_file.hpp"

namespace coupling::report {
namespace {

FolderNames& folders_of_thread() {
    thread_local FolderNames folders;
    return folders;
}

}  // namespace

FolderNames scenario_names(const ScenarioFile& scenario) {
    const std::filesystem::path of_archive = scenario.inputs_within / folder_names_file;
    if (!scenario.inputs_within.empty() && is_file(of_archive)) {
        const FileBytes bytes = open_file(of_archive, {of_archive.string()}, "names of folders");
        return folder_names_of(bytes.text());
    }
    std::vector<std::pair<std::string, std::string>> settings;
    if (scenario.options != nullptr) {
        for (const config::ParameterRow& row : scenario.options->rows()) {
            for (const std::string& name : files_in(row)) {
                settings.emplace_back(scenario.shown(name), name);
            }
        }
    }
    return folder_names_on_pages(*scenario.names, settings);
}

NamesOfScenario::NamesOfScenario(const ScenarioFile& scenario) : before_{std::move(folders_of_thread())} {
    folders_of_thread() = scenario_names(scenario);
}

NamesOfScenario::~NamesOfScenario() {
    folders_of_thread() = std::move(before_);
}

std::string with_scenario_names(std::string text) {
    return with_folder_names(std::move(text), folders_of_thread());
}

}  // namespace coupling::report
