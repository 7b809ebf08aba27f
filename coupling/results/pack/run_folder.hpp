#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/figures/read_summary.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::pack {

/// What archives have to know of a kind of run.
struct RunKind {
    std::string_view name;     ///< as in summary.json
    std::string_view command;  ///< of `bannwald`, which repeats it
    std::string_view folder;   ///< where the summary of the whole lies below the folder of the run; "": there
};

/// The kind of this name. Throws config::InputError (data) naming `file` for one that is not known.
const RunKind& kind_of(const std::string& name, const std::string& file);

/// A result of a run, below its folder.
struct ResultFile {
    std::string path;
    std::string sentence;
};

/// A finished run of any kind, as its folder holds it.
struct RunFolder {
    std::filesystem::path path;
    SummaryOfRun summary;                ///< of the whole
    std::filesystem::path summary_file;  ///< where that lies
    std::vector<ResultFile> results;     ///< all that it and the summaries of its parts list, and these
};

/// Reads what a folder holds: one summary, or that of a hazard map with those of its return periods. Throws
/// config::InputError: (file) for a folder without finished results, (settings) for the map of a hazard run
/// without its return periods, (data) for damaged summaries.
RunFolder read_run_folder(const std::filesystem::path& folder);

/// The scenario of a run of a kind, as the run read it. Throws config::InputError.
struct ReadScenario {
    std::shared_ptr<const void> owner;
    const Scenario& scenario;
};
ReadScenario read_scenario_of(const RunKind& kind, const std::filesystem::path& file,
                              const std::vector<std::string>& overrides);

}  // namespace coupling::pack
