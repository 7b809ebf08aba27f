#pragma once

#include <ostream>

#include "coupling/collapse/collapse_site.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling::collapse {

/// Runs a scenario with a section [collapse]: reads, checks, cuts the blocks, lets them move, writes the
/// results.
///
/// Returns 0, or 75 if the user interrupted it: the last kept state stays and the same command goes on from
/// it with the same bytes. Throws config::InputError.
int run_collapse(const RunRequest& request);

/// What `bannwald check` says of such a scenario: blocks, bonds, volumes, steps, memory and time.
void describe(const CollapseScenario& scenario, int threads, config::Warnings& warnings, std::ostream& out);

}  // namespace coupling::collapse
