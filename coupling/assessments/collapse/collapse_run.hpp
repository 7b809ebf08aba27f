#pragma once

#include <functional>
#include <ostream>
#include <vector>

#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/collapse/collapse_site.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling::collapse {

/// Runs a scenario with a section [collapse]: reads, checks, cuts the blocks, lets them move, writes the
/// results.
///
/// Returns 0, or 75 if the user interrupted it: the last kept state stays and the same command goes on from
/// it with the same bytes. Throws config::InputError.
int run_collapse(const RunRequest& request);

/// What a collapse came to, without files.
struct SimulatedCollapse {
    KeyFigures figures;
    std::vector<FrameRow> rows;
    double step_s;
    double floor_reached_m2;  ///< of all targets that are areas
};

/// Simulates in memory. `share_done` is called with the share of all steps now and then; what it throws ends
/// the simulation.
SimulatedCollapse simulate_collapse(const CollapseScenario& scenario, const CollapseSite& site, int threads,
                                    const std::function<void(double)>& share_done);

/// What `bannwald check` says of such a scenario: blocks, bonds, volumes, steps, memory and time.
void describe(const CollapseScenario& scenario, int threads, config::Warnings& warnings, std::ostream& out);

}  // namespace coupling::collapse
