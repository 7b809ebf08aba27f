#include "coupling/program/actions/run_models.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/compare/compare.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/program/actions/run_assessment.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;
using config::joined;

void refuse_unknown_models(const std::vector<std::string>& models) {
    const std::vector<std::string> names = model_names();
    for (const std::string& model : models) {
        if (std::find(names.begin(), names.end(), model) == names.end()) {
            const std::string nearest = config::nearest_word(model, names);
            refuse_usage(joined("--motion ", config::in_quotes(model)),
                         nearest.empty() ? "names that `bannwald models` lists, separated by commas"
                                         : joined("'", nearest, "'"));
        }
    }
    if (models.empty() || std::set<std::string>{models.begin(), models.end()}.size() < models.size()) {
        refuse_usage("--motion without a model or with one twice", "each model once");
    }
}

/// Whether the file still is what a run read. Names in a summary are relative to the scenario.
bool is_unchanged(const SummaryOfRun::Input& input, const fs::path& scenario) {
    const fs::path file = scenario.parent_path() / input.file;
    return path_exists(file) && open_file(file, {file.string()}, input.role).hash() == input.hash;
}

/// Whether the folder holds the finished results of this very run.
bool is_finished(const RunRequest& request) {
    const fs::path file = request.out / "summary.json";
    if (!path_exists(file)) {
        return false;
    }
    const SummaryOfRun summary =
        read_summary(open_file(file, {file.string()}, "the summary of a finished run").text(), file.string());
    const std::unique_ptr<Scenario> scenario =
        read_scenario(request.scenario, request.overrides, request.inputs_within);
    std::vector<std::string> finished;
    for (const SummaryOfRun::Setting& setting : summary.settings) {
        finished.push_back(joined(setting.key, "=", setting.value));
    }
    std::vector<std::string> wanted;
    for (const Json& setting : json_settings(*scenario)) {
        const Json& value = setting.at("value");
        wanted.push_back(joined(setting.at("key").get<std::string>(), "=",
                                value.is_string() ? value.get<std::string>() : value.dump()));
    }
    return finished == wanted && summary.version == config::version() && summary.commit == config::commit() &&
           std::all_of(summary.inputs.begin(), summary.inputs.end(), [&](const SummaryOfRun::Input& input) {
               return is_unchanged(input, request.scenario);
           });
}

}  // namespace

std::vector<std::string> model_names() {
    std::vector<std::string> names;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        names.emplace_back(rockfall::description_of(model).name);
    }
    return names;
}

int run_models(const RunRequest& request, const std::vector<std::string>& models, RankGroup& ranks,
               std::ostream& out) {
    refuse_unknown_models(models);
    const fs::path base =
        output_folder_of(request, *read_scenario(request.scenario, request.overrides, request.inputs_within));
    std::vector<fs::path> folders;
    for (const std::string& model : models) {
        RunRequest one = request;
        one.overrides.push_back(joined("rockfall.motion=", model));
        one.out = base / model;
        folders.push_back(one.out);
        if (!request.overwrite && is_finished(one)) {
            if (!request.quiet) {
                out << model << ": finished before, in " << one.out.string() << '\n';
            }
            continue;
        }
        const int code = run_assessment(one, ranks);
        if (code != static_cast<int>(config::ExitCode::done)) {
            return code;
        }
    }
    if (ranks.first()) {
        // A comparison follows from the runs: an earlier one is out of date.
        compare::compare_runs({.folders = folders,
                               .out = base / "comparison",
                               .page = {},
                               .overwrite = true,
                               .quiet = request.quiet},
                              out);
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling
