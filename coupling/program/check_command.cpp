#include <memory>

#include "config/text/words_of_list.hpp"
#include "coupling/program/actions/check.hpp"
#include "coupling/program/actions/run_models.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/run/messages.hpp"

namespace coupling {
namespace {

constexpr const char* check_help = R"(bannwald check SCENARIO [options]

Reads all files of a scenario and lists every problem; prints how large the run is. Writes nothing but the page.
  --out DIR                 where the run puts its results (default: out beside the scenario file): members of
                            a run over years that lie there are not simulated again
  --page FILE               of a run over years: where its regimes act, as a page with maps (HTML)
  --overwrite               replaces that page if it is there
  --motion NAME,NAME        of a run under several motion models: each of them, then time and memory of all
  --print-settings          every setting with value, unit, default and source
)";

int run_check(const Arguments& arguments, const Call& call) {
    std::vector<std::string> models;
    if (arguments.has("motion")) {
        models = config::words_of_list(arguments.text("motion"));
        refuse_unknown_models(models);
    }
    const CheckRequest request{.scenario = arguments.only_word(),
                               .overrides = arguments.overrides(),
                               .models = models,
                               .out = arguments.text("out"),
                               .threads = arguments.threads(),
                               .page = arguments.text("page"),
                               .overwrite = arguments.overwrite(),
                               .print_settings = arguments.has("print-settings")};
    config::Warnings warnings;
    std::shared_ptr<const InputNames> names;
    const auto print = [&] { print_warnings(warnings, arguments.verbose(), names.get()); };
    try {
        check_scenario(request, warnings, call.out, &names);
    } catch (...) {
        print();
        throw;
    }
    print();
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace

Command check_command() {
    return {
        .name = "check",
        .overview =
            R"(  bannwald check SCENARIO              reads everything, prints size, memory and time; writes nothing
)",
        .help = std::string{check_help} + help_of_set_and_seed + help_of_threads,
        .argument = "a scenario file",
        .options = {set_option(), seed_option(), threads_option(), switch_option("print-settings"),
                    option_with_value("motion", {.words = model_names}),
                    option_with_value("page", {Completion::Names::files}), out_folder_option(),
                    overwrite_option()},
        .completion = {Completion::Names::files},
        .run = run_check};
}

}  // namespace coupling
