#include "coupling/assessments/collapse/collapse_run.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* collapse_help = R"(bannwald collapse SCENARIO [options]

Simulates how a jointed rock mass breaks up, runs down the slope and comes to rest: convex blocks between joints or
Voronoi cells, joined by bonds that break. The section [collapse] of the scenario says which rock, which joints and
how strong; terrain, trees and targets are those of any scenario. Writes energies over time with their residual, maps,
tables, a page and, with output.vtp = yes, a series for ParaView. `bannwald check SCENARIO` prints blocks, steps,
memory and time beforehand. Interrupted by Ctrl-C after the first frame it keeps its last state; the same call
continues from there. Without --threads small masses run on fewer threads than the machine has.
  --out DIR                 folder of the results (default: out beside the scenario)
  --overwrite               replaces results or parts that the folder holds
)";

int collapse_mass(const Arguments& arguments, const Call&) {
    return collapse::run_collapse({.scenario = arguments.only_word(),
                                   .overrides = arguments.overrides(),
                                   .out = arguments.out(),
                                   .threads = arguments.threads(),
                                   .overwrite = arguments.overwrite(),
                                   .quiet = arguments.quiet(),
                                   .verbose = arguments.verbose()});
}

}  // namespace

Command collapse_command() {
    return {
        .name = "collapse",
        .overview = R"(  bannwald collapse SCENARIO           simulates a jointed rock mass that breaks up
)",
        .help = std::string{collapse_help} + help_of_set_and_seed + help_of_threads,
        .argument = "a scenario file",
        .options = {set_option(), seed_option(), threads_option(), out_folder_option(), overwrite_option()},
        .completion = {Completion::Names::files},
        .run = collapse_mass};
}

}  // namespace coupling
