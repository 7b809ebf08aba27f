#include "coupling/assessments/calibrate/calibrate_run.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* calibrate_help = R"(bannwald calibrate SCENARIO [options]

Fits what is not known of ground and trees (`bannwald info parameter_widths`) to what was seen in the field: places of
blocks (observed.stops) or an outline around them (observed.outline), wounds on stems (observed.scars, observed.trees),
rocks at a line (observed.passages), jumps along tracks (observed.impacts). It keeps parameter sets whose rocks leave
what was seen, holds part of the observations out to judge them, and says when they may not be called
calibrated. The page shows what was learned, and what other observations would tell.
Results: report.html, tables/posterior.csv, and calibrated.ini, the scenario with these sets for `bannwald run`.
Settings: section [calibrate] of `bannwald --help-all`. Interrupted by Ctrl-C it keeps what it tried; the
same call continues from there. Started by `mpirun -n N bannwald calibrate ...` the N processes share the sets.
  --out DIR                 folder of the results (default: calibration beside the scenario)
  --overwrite               replaces results or parts that the folder holds
)";

int calibrate_scenario(const Arguments& arguments, const Call& call) {
    return calibrate::run_calibration({.scenario = arguments.only_word(),
                                       .overrides = arguments.overrides(),
                                       .out = arguments.out(),
                                       .threads = arguments.threads(),
                                       .overwrite = arguments.overwrite(),
                                       .quiet = arguments.quiet() || !call.ranks.first(),
                                       .verbose = arguments.verbose()},
                                      call.ranks);
}

}  // namespace

Command calibrate_command() {
    return {
        .name = "calibrate",
        .overview =
            R"(  bannwald calibrate SCENARIO          fits ground and trees to blocks, scars and rocks that were seen
)",
        .help = std::string{calibrate_help} + help_of_set_and_seed + help_of_threads,
        .argument = "a scenario file",
        .options = {set_option(), seed_option(), threads_option(), out_folder_option(), overwrite_option()},
        .completion = {Completion::Names::files},
        .run = calibrate_scenario,
        .is_shared = true};
}

}  // namespace coupling
