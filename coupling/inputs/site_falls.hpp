#pragma once

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/obstacles/log_index.hpp"
#include "rockfall/obstacles/nets/net_index.hpp"
#include "rockfall/obstacles/stem_index.hpp"

namespace coupling {

struct Scenario;

/// All that the falls on a site share: what stands on it, laws, draws. It keeps references to scenario and
/// site, and its `assessment` to the rest: it does not move.
class SiteFalls {
public:
    /// `frame`: of maps, in coordinates of the terrain; without cells nobody reads them.
    SiteFalls(const Scenario& scenario, const Site& site, const config::GridFrame& frame);
    SiteFalls(const SiteFalls&) = delete;
    SiteFalls& operator=(const SiteFalls&) = delete;

    const rockfall::StartLaw start;
    const ParameterDraws draws;

private:
    const double largest_radius_m_;  ///< of the rocks: before what is indexed for it

public:
    const rockfall::StemIndex stems;
    const rockfall::LogIndex logs;
    const rockfall::NetIndex nets;
    rockfall::Assessment assessment;
};

}  // namespace coupling
