#pragma once

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// Runs a scenario over its years: every member (regime, climate and replicate) writes a part file when it is
/// through; the results are made of the parts. What an interrupted run has finished is not done again.
/// RankGroup share the members; the first one writes the results.
///
/// Returns 0, or 75 if the user interrupted it. Throws config::InputError. Requires a site with a forest.
/// The files of its regimes are added to the site's inputs.
int run_decades(const RunRequest& request, const Scenario& scenario, Site& site, config::Warnings& warnings,
                RankGroup& ranks);

}  // namespace coupling::decades
