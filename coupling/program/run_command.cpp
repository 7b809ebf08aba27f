#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/words_of_list.hpp"
#include "coupling/assessments/collapse/collapse_run.hpp"
#include "coupling/program/actions/run_assessment.hpp"
#include "coupling/program/actions/run_models.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* run_help = R"(bannwald run SCENARIO [options]

Simulates rockfall over the slope with its forest and over the bare slope, and writes the results.
With terrain.profile = FILE they fall along a profile in two dimensions instead. With run.years above 0 a forest
grows, is managed, and the rocks fall again year after year.
Interrupted by Ctrl-C it keeps finished parts; the same call continues from there.
  --out DIR                 folder of the results (default: out beside the scenario)
  --overwrite               replaces results or parts that the folder holds; of a run over years it simulates only
                            members (regime, climate, replicate) that the folder does not hold from an earlier run
  --motion NAME,NAME        under several motion models (`bannwald models`), each into a folder of its name, with the same
                            rocks and trees; DIR/report.html then shows them side by side, with which is judged best
                            on what (over years and along a profile DIR/comparison/report.html); one name: as --set
  --shard i/n               simulates only the i-th of n shares and keeps its parts: of a run over years each n-th member
                            (regime and replicate), of today and of each return period of a hazard map the rocks of an
                            n-th of the sources; shards may share a folder, the call without --shard then makes the
                            results
Started by `mpirun -n N bannwald run ...` the N processes share the members of a run over years, or the rocks of today
and of each return period. A run along a profile takes seconds: the first process does it.
)";

constexpr const char* merge_help = R"(bannwald merge SCENARIO DIR... [options]

Takes the parts that shards of a run left in their folders and makes the results.
The scenario and its settings have to be those of the shards.
  --out DIR                 folder of the results (default: out beside the scenario)
  --overwrite               replaces results or parts that the folder holds
)";

/// "2/5": the second of five.
Shard shard_of(const std::string& text) {
    const auto slash = text.find('/');
    const auto number = config::parse_whole(text.substr(0, slash));
    const auto count = config::parse_whole(slash == std::string::npos ? "" : text.substr(slash + 1));
    if (number && count && *number >= 1 && *count >= 1 && *count < *number) {
        refuse_usage("--shard " + config::in_quotes(text),
                     config::joined("one of the ", std::to_string(*count), ": 1/", std::to_string(*count),
                                    " to ", std::to_string(*count), "/", std::to_string(*count)));
    }
    if (!number || !count || *number < 1 || *count < 1 || *count > 100'000) {
        refuse_usage("--shard " + config::in_quotes(text), "i/n with 1 <= i <= n, such as 2/5");
    }
    return {static_cast<std::uint32_t>(*number), static_cast<std::uint32_t>(*count)};
}

RunRequest request_of(const Arguments& arguments, const std::string& scenario, RankGroup& ranks) {
    if (collapse::is_collapse(scenario)) {
        config::fail(config::ExitCode::settings, {scenario}, "section [collapse], a rock mass that breaks up",
                     "a scenario without it", config::joined("bannwald collapse ", scenario));
    }
    return {.scenario = scenario,
            .overrides = arguments.overrides(),
            .out = arguments.out(),
            .threads = arguments.threads(),
            .overwrite = arguments.overwrite(),
            .quiet = arguments.quiet() || !ranks.first(),
            .verbose = arguments.verbose()};
}

int run(const Arguments& arguments, const Call& call) {
    const std::string scenario = arguments.only_word();
    const Shard shard = arguments.has("shard") ? shard_of(arguments.text("shard")) : Shard{};
    RunRequest request = request_of(arguments, scenario, call.ranks);
    request.shard = shard;
    if (arguments.has("motion")) {
        const std::vector<std::string> models = config::words_of_list(arguments.text("motion"));
        if (models.size() > 1 && arguments.has("shard")) {
            refuse_usage("--shard with several motion models", "one of them: --motion NAME --shard i/n");
        }
        return run_models(request, models, call.ranks, call.out);
    }
    return run_assessment(request, call.ranks);
}

/// The scenario and the folders after it.
int merge(const Arguments& arguments, const Call&) {
    const std::vector<std::string>& words = arguments.words();
    if (words.size() < 2) {
        refuse_usage("`bannwald merge` without folders", "a scenario file and the folders of its shards");
    }
    RankGroup alone{RankGroup::Alone{}};
    RunRequest request = request_of(arguments, words.front(), alone);
    request.shards.assign(words.begin() + 1, words.end());
    return run_assessment(request, alone);
}

}  // namespace

Command run_command() {
    return {
        .name = "run",
        .overview =
            R"(  bannwald run SCENARIO                simulates rockfall and writes maps, tables and a report
)",
        .help = std::string{run_help} + help_of_set_and_seed + help_of_threads,
        .argument = "a scenario file",
        .options = {set_option(), seed_option(), threads_option(), out_folder_option(), overwrite_option(),
                    option_with_value("motion", {.words = model_names}), option_with_value("shard")},
        .completion = {Completion::Names::files},
        .run = run,
        .is_shared = true};
}

Command merge_command() {
    return {.name = "merge",
            .overview =
                R"(  bannwald merge SCENARIO DIR...       makes the results of a run out of its shards
)",
            .help = std::string{merge_help} + help_of_set_and_seed,
            .argument = "",
            .options = {set_option(), seed_option(), out_folder_option(), overwrite_option()},
            .completion = {Completion::Names::files},
            .run = merge};
}

}  // namespace coupling
