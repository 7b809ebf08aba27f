#include "forest/disturbance/snow_breakage.hpp"

#include <cassert>
#include <numbers>
#include <vector>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "forest/deadwood/deadwood.hpp"
#include "forest/disturbance/wet_snow.hpp"

namespace forest {

namespace {

constexpr double fall_scatter_rad = std::numbers::pi / 3.0;

config::FourUniforms chance_of(std::uint64_t seed, std::uint32_t replicate, int year, std::uint64_t id,
                               std::uint32_t event) {
    return config::RandomStream{{seed, replicate, static_cast<std::uint16_t>(year), id},
                                config::Purpose::snow}
        .uniforms_of(event);
}

}  // namespace

double snow_breakage(const Species& species, double dbh_cm, double height_m) {
    if (!species.conifer) {
        return 0.0;
    }
    const double slenderness = 100.0 * height_m / dbh_cm;
    return 1.0 / (1.0 + config::exp_of(10.5 - 0.07 * slenderness));
}

void break_by_snow(Stand& stand, const Site& site, const SpeciesTable& species,
                   std::span<const ClimateYear> weather, double usual_chance, std::uint64_t seed,
                   std::uint32_t replicate) {
    assert(weather.size() == site.units().size());
    const double draw = chance_of(seed, replicate, stand.year(), 0, 0)[0];
    std::vector<char> is_wet(weather.size(), 0);
    for (std::size_t unit = 0; unit < weather.size(); ++unit) {
        is_wet[unit] = draw < wet_snow_chance(weather[unit], usual_chance) ? 1 : 0;
    }
    std::vector<Removal> broken;
    std::vector<Snag> stumps;
    std::vector<Log> logs;
    for (const Tree& tree : stand.trees()) {
        const Patch& ground = stand.grid()[tree.patch];
        if (tree.dbh_cm < least_broken_cm || is_wet[site.unit_of(tree.patch)] == 0) {
            continue;
        }
        const config::FourUniforms u = chance_of(seed, replicate, stand.year(), number_of(tree.id), 1);
        if (u[0] >= snow_breakage(species[tree.species], tree.dbh_cm, tree.height_m)) {
            continue;
        }
        broken.push_back({tree.id, Cause::snow});
        const double down_rad = 0.5 * std::numbers::pi - ground.aspect.in_radians();
        const Wreck wreck =
            wreck_of(tree, tree.height_m * (1.0 + u[1]) / 3.0,
                     down_rad + fall_scatter_rad * (2.0 * u[2] - 1.0), LogOrigin::fallen, stand.year());
        stumps.push_back(*wreck.stump);
        logs.push_back(wreck.log);
    }
    stand.remove_trees(broken);
    stand.add_snags(stumps);
    stand.add_logs(logs);
}

}  // namespace forest
