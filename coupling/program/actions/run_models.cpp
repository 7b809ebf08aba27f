#include "coupling/program/actions/run_models.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/assessments/compare/compare.hpp"
#include "coupling/assessments/hazard/hazard_plan.hpp"
#include "coupling/assessments/models/models.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/program/actions/run_assessment.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "coupling/run/output_folder.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;
using config::joined;

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

/// Finished results of a folder that this run would have to replace.
void refuse_other_results(const RunRequest& request) {
    if (request.overwrite || !path_exists(request.out / "summary.json")) {
        return;
    }
    if (!is_finished(request)) {
        config::fail(config::ExitCode::settings, {request.out.string()},
                     "finished results of other settings or inputs",
                     "another folder by --out, or --overwrite to simulate it again");
    }
    if (const std::string damage = OutputFolder::damage(request.out); !damage.empty()) {
        config::fail(config::ExitCode::settings, {request.out.string()}, joined("results of which ", damage),
                     "all files as the run wrote them; put it back, or --overwrite to simulate it again");
    }
}

std::vector<RunRequest> requests_of(const RunRequest& request, const std::vector<std::string>& models,
                                    const fs::path& base) {
    std::vector<RunRequest> all;
    for (const std::string& model : models) {
        all.push_back(request);
        all.back().overrides.push_back(setting_of_model(model));
        all.back().out = base / model;
    }
    return all;
}

/// Runs over years and along a profile: the distributions and figures of `bannwald compare` alone.
void compare_other_kinds(const RunRequest& request, const std::vector<RunRequest>& runs, const fs::path& base,
                         std::ostream& out) {
    std::vector<fs::path> folders;
    for (const RunRequest& run : runs) {
        folders.push_back(run.out);
    }
    compare::compare_runs({.folders = folders,
                           .out = base / "comparison",
                           .page = {},
                           .overwrite = true,  // it follows from the runs: an earlier one is out of date
                           .quiet = request.quiet},
                          out);
}

}  // namespace

std::vector<std::string> model_names() {
    std::vector<std::string> names;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        names.emplace_back(rockfall::description_of(model).name);
    }
    return names;
}

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

std::string setting_of_model(const std::string& model) {
    return joined("rockfall.motion=", model);
}

int run_models(const RunRequest& request, const std::vector<std::string>& models, RankGroup& ranks,
               std::ostream& out) {
    refuse_unknown_models(models);
    if (models.size() == 1) {
        RunRequest alone = request;
        alone.overrides.push_back(setting_of_model(models.front()));
        return run_assessment(alone, ranks);
    }
    const std::unique_ptr<Scenario> scenario =
        read_scenario(request.scenario, request.overrides, request.inputs_within);
    const fs::path base = output_folder_of(request, *scenario);
    const bool existed = path_exists(base);
    const std::vector<RunRequest> runs = requests_of(request, models, base);
    const bool has_hazard = wants_hazard_map(*scenario);
    const bool has_page = has_hazard || (scenario->run.years == 0 && scenario->terrain.profile.empty());
    if (ranks.first() && has_page) {
        models::look_at_models_folder(base);
    }
    for (const RunRequest& run : runs) {
        refuse_other_results(run);
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!request.overwrite && is_finished(runs[i])) {
            if (!request.quiet) {
                out << models[i] << ": finished before, in " << runs[i].out.string() << '\n';
            }
            continue;
        }
        if (!request.quiet) {
            out << "motion model " << models[i] << '\n' << std::flush;
        }
        if (const int code = run_assessment(runs[i], ranks); code != 0) {
            std::error_code ignored;
            if (!existed) {
                fs::remove(base, ignored);  // an empty folder only: nothing was kept
            }
            return code;
        }
    }
    if (ranks.first() && has_page) {
        models::put_side_by_side(
            {.run = request,
             .scenario = *scenario,
             .folder = base,
             .models = models,
             .return_periods_years =
                 has_hazard ? hazard::read_plan(*scenario).return_periods_years : std::vector<double>{}},
            out);
    } else if (ranks.first()) {
        compare_other_kinds(request, runs, base, out);
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling
