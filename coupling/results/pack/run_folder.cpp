#include "coupling/results/pack/run_folder.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/finished_runs.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/pack/zip_file.hpp"

namespace coupling::pack {
namespace {

namespace fs = std::filesystem;
using config::ExitCode;
using config::joined;

constexpr std::array run_kinds{RunKind{"today", "run", ""}, RunKind{"profile", "run", ""},
                               RunKind{"years", "run", ""}, RunKind{"hazard", "run", "hazard"},
                               RunKind{"collapse", "collapse", ""}};

constexpr const char* summary_name = "summary.json";

/// A summary and the folder that it lies in, from the folder of the run.
struct Summary {
    std::string folder;  ///< "" or ending in '/'
    Json json;
};

Summary summary_in(const fs::path& run, const std::string& folder) {
    const fs::path file = run / folder / summary_name;
    if (!is_file(file)) {
        config::fail(ExitCode::file, {file.string()}, "no such file",
                     "the summary of a finished part of the run",
                     "finish the run by the same command, then pack it");
    }
    const FileBytes bytes = open_file(file, {file.string()}, "the summary of a run");
    try {
        return {folder.empty() ? "" : joined(folder, "/"), Json::parse(bytes.text())};
    } catch (const Json::exception&) {
        config::fail(ExitCode::data, {file.string()}, "no summary of a run",
                     "summary.json as bannwald writes it");
    }
}

/// Folders of the return periods, beside that of the map.
std::vector<std::string> folders_of_parts(const Json& summary) {
    constexpr std::string_view beside = "../";
    std::vector<std::string> folders;
    if (const auto periods = summary.find("return_periods"); periods != summary.end()) {
        for (const Json& period : *periods) {
            std::string folder = period.at("folder").get<std::string>();
            folders.push_back(folder.starts_with(beside) ? folder.substr(beside.size()) : folder);
        }
    }
    return folders;
}

void add_results(const Summary& summary, const fs::path& run, std::vector<ResultFile>& results) {
    const std::string own = joined(summary.folder, summary_name);
    bool is_listed = false;
    for (const Json& entry : summary.json.at("files")) {
        const std::string path = joined(summary.folder, entry.at("path").get<std::string>());
        if (!is_safe_name(path)) {
            config::fail(ExitCode::data, {(run / own).string()}, joined("a result ", path_in_quotes(path)),
                         "files below the folder of the run");
        }
        is_listed = is_listed || path == own;
        results.push_back({path, entry.at("holds").get<std::string>()});
    }
    if (!is_listed) {
        results.push_back({own, "Figures and settings."});
    }
}

/// The kind of the run in a folder, by where its summary lies.
const RunKind* kind_by_summary(const fs::path& folder) {
    const auto found = std::find_if(run_kinds.begin(), run_kinds.end(), [&](const RunKind& kind) {
        return is_file(folder / kind.folder / summary_name);
    });
    return found == run_kinds.end() ? nullptr : found;
}

}  // namespace

const RunKind& kind_of(const std::string& name, const std::string& file) {
    const auto found = std::find_if(run_kinds.begin(), run_kinds.end(),
                                    [&](const RunKind& kind) { return kind.name == name; });
    if (found == run_kinds.end()) {
        config::fail(ExitCode::data, {file}, joined("a run of the kind ", config::in_quotes(name)),
                     "today, profile, years, hazard or collapse");
    }
    return *found;
}

RunFolder read_run_folder(const fs::path& folder) {
    const RunKind* place = kind_by_summary(folder);
    if (place == nullptr) {
        config::fail(ExitCode::file, {folder.string()}, "no summary.json", "the folder of a finished run",
                     joined("run the scenario first, or ", name_a_finished_run(folder)));
    }
    RunFolder run{folder, {}, folder / place->folder / summary_name, {}};
    const std::string file = run.summary_file.string();
    run.summary = read_summary(open_file(run.summary_file, {file}, "the summary of a run").text(), file);
    if (kind_of(run.summary.kind, file).folder != place->folder) {
        config::fail(
            ExitCode::settings, {folder.string()}, joined("the map of a ", run.summary.kind, " run"),
            "the folder above it, which holds its return periods too",
            joined("bannwald pack ", fs::absolute(folder).lexically_normal().parent_path().string()));
    }
    try {
        const Summary whole = summary_in(folder, std::string{place->folder});
        add_results(whole, folder, run.results);
        for (const std::string& part : folders_of_parts(whole.json)) {
            add_results(summary_in(folder, part), folder, run.results);
        }
    } catch (const Json::exception&) {
        config::fail(ExitCode::data, {file}, "a summary without the list of its files",
                     "summary.json as bannwald writes it");
    }
    return run;
}

ReadScenario read_scenario_of(const RunKind& kind, const fs::path& file,
                              const std::vector<std::string>& overrides) {
    if (kind.command == "collapse") {
        std::shared_ptr<collapse::CollapseScenario> read = collapse::read_collapse(file, overrides);
        const Scenario& scenario = read->scenario;
        return {std::move(read), scenario};
    }
    std::shared_ptr<Scenario> read = read_scenario(file, overrides);
    const Scenario& scenario = *read;
    return {std::move(read), scenario};
}

}  // namespace coupling::pack
