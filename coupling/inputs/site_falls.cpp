#include "coupling/inputs/site_falls.hpp"

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_draws.hpp"

namespace coupling {

SiteFalls::SiteFalls(const Scenario& scenario, const Site& site, const config::GridFrame& frame)
    : start{start_law(scenario.release)},
      draws{draws_on(scenario, site)},
      largest_radius_m_{largest_radius_m(start, site.sources, draws)},
      stems{site.stems(), site.slope.terrain, largest_radius_m_, scenario.rockfall.fall.tree.taper},
      logs{site.lying_logs(), site.slope.terrain, largest_radius_m_, scenario.rockfall.fall.log.loose_share},
      nets{site.standing_nets()},
      assessment{site.slope,       stems, site.sources, site.targets, start, scenario.rockfall.fall, frame,
                 scenario.run.seed} {
    assessment.logs = &logs;
    assessment.nets = &nets;
    assessment.draws = draws.falls;
}

}  // namespace coupling
