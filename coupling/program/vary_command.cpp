#include "coupling/assessments/vary/vary.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* vary_help = R"(bannwald vary SCENARIO FACTORS.csv --out DIR [options]

Lets the rocks of a scenario of today fall again and again with other settings, the same rocks as far as the
settings leave them the same, and shows which settings decide the result: a page with a tornado chart for each target,
and all runs as vary.csv. FACTORS.csv has a row a setting:
  setting,values,how
  tree_impact.taper,yes no,alone                   each value alone, all else as in the scenario
  release.diameter_m,0.5 1.0,crossed               with each value of all other crossed settings
With run.years above 0 the chart is about the paired difference of the regimes, and the page says which settings
change their ranking. Any setting may vary, files too: trees.file, terrain.dem; ground.pasture.r_t is a value of a ground type.
  --out DIR                 folder of vary.csv and report.html
  --overwrite               replaces a study that the folder holds
)";

/// A scenario and a table of settings.
int vary_settings(const Arguments& arguments, const Call& call) {
    const std::vector<std::string>& words = arguments.words();
    if (words.size() != 2) {
        refuse_usage("`bannwald vary` with " + std::to_string(words.size()) + " files",
                     "a scenario and a table of settings: bannwald vary SCENARIO FACTORS.csv --out DIR");
    }
    if (!arguments.has("out")) {
        refuse_usage("`bannwald vary` without a folder for the results", "--out DIR");
    }
    return vary::vary_scenario({.scenario = words[0],
                                .factors = words[1],
                                .overrides = arguments.overrides(),
                                .out = arguments.out(),
                                .threads = arguments.threads(),
                                .overwrite = arguments.overwrite(),
                                .quiet = arguments.quiet()},
                               call.out);
}

}  // namespace

Command vary_command() {
    return {
        .name = "vary",
        .overview =
            R"(  bannwald vary SCENARIO FACTORS.csv   other settings one by one and crossed: which decide the result
)",
        .help = std::string{vary_help} + help_of_set_and_seed + help_of_threads,
        .argument = "",
        .options = {set_option(), seed_option(), threads_option(), out_folder_option(), overwrite_option()},
        .completion = {Completion::Names::files},
        .run = vary_settings};
}

}  // namespace coupling
