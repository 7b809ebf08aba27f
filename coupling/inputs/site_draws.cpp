#include "coupling/inputs/site_draws.hpp"

#include <algorithm>
#include <utility>

#include "coupling/inputs/scenario/scenario.hpp"
#include "forest/start/diameter_of_height.hpp"

namespace coupling {
DrawnSite drawn_site(const Site& site) {
    std::vector<bool> occurs(site.slope.types.size());
    for (const std::uint8_t type : site.surface.values) {
        if (type < occurs.size()) {
            occurs[type] = true;
        }
    }
    const auto derived = static_cast<double>(std::count_if(
        site.trees.begin(), site.trees.end(), [](const TreeRecord& tree) { return tree.has_derived_dbh; }));
    const double share = site.trees.empty() ? 0.0 : derived / static_cast<double>(site.trees.size());
    return {site.slope.types, std::move(occurs), !site.trees.empty() || !site.logs.empty(),
            share * forest::diameter_of_height_width};
}

ParameterDraws draws_on(const Scenario& scenario, const Site& site) {
    if (!site.knowledge) {
        return {};
    }
    const DrawnSite drawn = drawn_site(site);
    return site.knowledge->is_drawn ? draw_parameters(*site.knowledge, drawn, scenario.rockfall.fall,
                                                      scenario.run.seed, site.rocks())
                                    : central_draw(*site.knowledge, drawn, scenario.rockfall.fall);
}

double largest_radius_m(const rockfall::StartLaw& common, std::span<const rockfall::ReleaseSource> sources,
                        const ParameterDraws& draws) {
    double largest = 1.0;
    for (const rockfall::FallDraw& draw : draws.falls) {
        largest = std::max(largest, draw.block_size);
    }
    return largest * rockfall::largest_radius_m(common, sources);
}

ParameterDraws draw_of_replicate_on(const Scenario& scenario, const Site& site, std::uint32_t replicate) {
    if (!site.knowledge) {
        return {};
    }
    DrawnSite drawn = drawn_site(site);
    drawn.has_obstacles = true;
    drawn.grows = true;
    return draw_of_replicate(*site.knowledge, drawn, scenario.rockfall.fall, scenario.run.seed,
                             site.knowledge->is_drawn ? replicate : 0);
}

}  // namespace coupling
