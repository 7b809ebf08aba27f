#pragma once

#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

/// Runs the static assessment of a scenario: reads, checks, lets the rocks fall with and without forest,
/// writes the results.
///
/// A scenario with hazard.blocks runs once for each return period (coupling/assessments/hazard), one with
/// terrain.profile in two dimensions (coupling/assessments/profile), one with run.years above 0 over years
/// (coupling/assessments/decades); only the latter has members that shards and ranks can share.
///
/// Returns 0, or 75 if the user interrupted it: finished parts stay and the next call goes on from them.
/// Throws config::InputError; then no new output folder is left.
int run_assessment(const RunRequest& request, RankGroup& ranks);

}  // namespace coupling
