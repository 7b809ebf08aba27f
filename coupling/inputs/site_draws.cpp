#include "coupling/inputs/site_draws.hpp"

#include <utility>

#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {
namespace {

DrawnSite drawn_site(const Site& site, bool has_obstacles) {
    std::vector<bool> occurs(site.slope.types.size());
    for (const std::uint8_t type : site.surface.values) {
        if (type < occurs.size()) {
            occurs[type] = true;
        }
    }
    return {site.slope.types, std::move(occurs), has_obstacles};
}

}  // namespace

ParameterDraws draws_on(const Scenario& scenario, const Site& site) {
    const std::uint64_t rocks =
        site.sources.empty() ? 0 : site.sources.back().first_rock + site.sources.back().rocks;
    return draw_parameters(site.parameter_widths, drawn_site(site, !site.trees.empty() || !site.logs.empty()),
                           scenario.rockfall.fall, scenario.run.seed, rocks);
}

ParameterDraws draw_of_replicate_on(const Scenario& scenario, const Site& site, std::uint32_t replicate) {
    return draw_of_replicate(site.parameter_widths, drawn_site(site, true), scenario.rockfall.fall,
                             scenario.run.seed, replicate);
}

}  // namespace coupling
