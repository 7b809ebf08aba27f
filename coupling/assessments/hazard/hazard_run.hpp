#pragma once

#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::hazard {

/// Lets the rocks of each return period of hazard.blocks fall, each into a folder return_period_N of its own,
/// and makes the hazard map of them in the folder hazard. Return periods that are finished already stay as
/// they are. Ranks and shards share the rocks of each return period; a shard ends with its pieces.
///
/// Returns 0, or 75 if the user interrupted it: what is finished stays and the next call goes on from there.
/// Throws config::InputError. Requires a scenario of today with hazard.blocks.
int run_hazard(const RunRequest& request, const Scenario& scenario, RankGroup& ranks);

}  // namespace coupling::hazard
