#pragma once

#include <ostream>

#include "coupling/assessments/profile/falls/profile_site.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling::profile {

/// Runs a scenario with terrain.profile: reads, checks, lets the rocks fall, writes the results.
///
/// Returns 0, or 75 if the user interrupted it; then nothing is left behind. Throws config::InputError.
int run_profile(const RunRequest& request, const Scenario& scenario);

/// How many rocks a scenario with terrain.profile lets fall.
std::uint64_t rocks_of(const Scenario& scenario);

/// What `bannwald check` says of such a scenario.
void describe(const Scenario& scenario, const ProfileSite& site, std::ostream& out);

}  // namespace coupling::profile
