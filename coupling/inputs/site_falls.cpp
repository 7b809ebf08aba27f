#include "coupling/inputs/site_falls.hpp"

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_draws.hpp"

namespace coupling {

SiteFalls::SiteFalls(const Scenario& scenario, const Site& site, const config::GridFrame& frame)
    : SiteFalls{scenario, site, frame,
                rockfall::largest_radius_m(start_law(scenario.release), site.sources)} {}

SiteFalls::SiteFalls(const Scenario& scenario, const Site& site, const config::GridFrame& frame,
                     double largest_radius_m)
    : start{start_law(scenario.release)},
      stems{site.stems(), site.slope.terrain, largest_radius_m, scenario.rockfall.fall.tree.taper},
      logs{site.lying_logs(), site.slope.terrain, largest_radius_m, scenario.rockfall.fall.log.loose_share},
      nets{site.standing_nets()},
      draws{draws_on(scenario, site)},
      assessment{site.slope,       stems, site.sources, site.targets, start, scenario.rockfall.fall, frame,
                 scenario.run.seed} {
    assessment.logs = &logs;
    assessment.nets = &nets;
    assessment.draws = draws.falls;
}

}  // namespace coupling
