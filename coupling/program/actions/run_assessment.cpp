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
    const bool is_shared = request.shard.count > 1 || !request.shards.empty() || ranks.count() > 1;
    const bool is_profile = !scenario->terrain.profile.empty();
    if (is_shared && (is_profile || wants_hazard_map(*scenario))) {
        config::fail(
            config::ExitCode::settings, {scenario->file.string()},
            is_profile ? "a run along a profile that is to be shared" : "a hazard map that is to be shared",
            "one process with --threads",
            is_profile ? "it takes seconds" : "share the runs of its return periods one by one");
    }
    if (is_profile) {
        return profile::run_profile(request, *scenario);
    }
    if (wants_hazard_map(*scenario)) {
        return hazard::run_hazard(request, *scenario);
    }
    config::Warnings warnings;
    Site site = open_site(*scenario, warnings);
    plausible::warn_of_rocks(*scenario, site, warnings);
    if (!request.quiet) {
        print_warnings(warnings, request.verbose);
    }
    const int code = site.forest ? decades::run_decades(request, *scenario, site, warnings, ranks)
                                 : assess_today(request, *scenario, site, warnings,
                                                output_folder_of(request, *scenario), ranks);
    if (code == static_cast<int>(config::ExitCode::done) && ranks.first()) {
        repeat_warnings(warnings, request.verbose);
    }
    return code;
}

}  // namespace coupling
