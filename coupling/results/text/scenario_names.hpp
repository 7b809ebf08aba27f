#pragma once

#include <string>

#include "coupling/inputs/files/folder_names.hpp"

namespace coupling {
struct ScenarioFile;
}

namespace coupling::report {

/// How the pages of a scenario name folders outside of its project. In an archive they are the names of the
/// packed run, so that it has the same pages when it is repeated there.
FolderNames scenario_names(const ScenarioFile& scenario);

/// While such an object lives, pages of its thread name files as a scenario does. A page makes one beside its
/// WritingLanguage.
class NamesOfScenario {
public:
    explicit NamesOfScenario(const ScenarioFile& scenario);
    ~NamesOfScenario();
    NamesOfScenario(const NamesOfScenario&) = delete;
    NamesOfScenario& operator=(const NamesOfScenario&) = delete;

private:
    FolderNames before_;
};

/// Names of files, or a text with such names, as the scenario of the page names them.
std::string with_scenario_names(std::string text);

}  // namespace coupling::report
