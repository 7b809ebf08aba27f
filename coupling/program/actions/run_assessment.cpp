#include "coupling/program/actions/run_assessment.hpp"

#include <memory>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/decade_run.hpp"
#include "coupling/assessments/hazard/hazard_run.hpp"
#include "coupling/assessments/profile/profile_run.hpp"
#include "coupling/assessments/today/assess_today.hpp"
#include "coupling/inputs/rock_count.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/run/messages.hpp"

namespace coupling {

using config::joined;

int run_assessment(const RunRequest& request, RankGroup& ranks) {
    const std::unique_ptr<Scenario> scenario =
        read_scenario(request.scenario, request.overrides, request.inputs_within);
    if (scenario->run.years == 0 && (request.shard.count > 1 || !request.shards.empty())) {
        config::fail(config::ExitCode::settings, scenario->options->place_of("run.years"),
                     "shards of a run without years", "run.years above 0: its members are what shards share");
    }
    if (scenario->run.years == 0 && ranks.count() > 1) {
        config::fail(
            config::ExitCode::settings, scenario->options->place_of("run.years"),
            joined(std::to_string(ranks.count()), " processes for a run without years"),
            "one process with --threads, or run.years above 0: its members are what processes share");
    }
    if (!scenario->terrain.profile.empty()) {
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
    const int code =
        site.forest ? decades::run_decades(request, *scenario, site, warnings, ranks)
                    : assess_today(request, *scenario, site, warnings, output_folder_of(request, *scenario));
    if (code == static_cast<int>(config::ExitCode::done) && ranks.first()) {
        repeat_warnings(warnings, request.verbose);
    }
    return code;
}

}  // namespace coupling
