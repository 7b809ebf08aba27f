#include "coupling/program/actions/run_assessment.hpp"

#include <memory>

#include "coupling/assessments/decades/decade_run.hpp"
#include "coupling/assessments/hazard/hazard_run.hpp"
#include "coupling/assessments/profile/profile_run.hpp"
#include "coupling/assessments/today/assess_today.hpp"
#include "coupling/inputs/rock_count.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/run/messages.hpp"

namespace coupling {

int run_assessment(const RunRequest& request, RankGroup& ranks) {
    const std::unique_ptr<Scenario> scenario =
        read_scenario(request.scenario, request.overrides, request.inputs_within);
    const bool has_shards = request.shard.count > 1 || !request.shards.empty();
    if (!scenario->terrain.profile.empty()) {
        if (has_shards) {
            config::fail(config::ExitCode::settings, {scenario->file.string()},
                         "a run along a profile that is to be shared", "one process with --threads",
                         "it takes seconds");
        }
        // The others have nothing to do, and wait.
        return ranks.first() ? profile::run_profile(request, *scenario)
                             : static_cast<int>(config::ExitCode::done);
    }
    if (wants_hazard_map(*scenario)) {
        return hazard::run_hazard(request, *scenario, ranks);
    }
    config::Warnings warnings;
    Site site = open_site(*scenario, warnings);
    plausible::warn_of_rocks(*scenario, site, warnings);
    if (!request.quiet) {
        print_warnings(warnings, request.verbose, scenario->names.get());
    }
    const int code = site.forest ? decades::run_decades(request, *scenario, site, warnings, ranks)
                                 : assess_today(request, *scenario, site, warnings,
                                                output_folder_of(request, *scenario), ranks);
    if (code == static_cast<int>(config::ExitCode::done) && ranks.first()) {
        repeat_warnings(warnings, request.verbose, scenario->names.get());
    }
    return code;
}

}  // namespace coupling
