#include "forest/year.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "forest/deadwood/deadwood.hpp"
#include "forest/deaths/mortality.hpp"
#include "forest/deaths/vigour.hpp"
#include "forest/deaths/wounds.hpp"
#include "forest/disturbance/disturbance.hpp"
#include "forest/growth.hpp"
#include "forest/light/stand_light.hpp"
#include "forest/production/allocation.hpp"
#include "forest/production/unit_production.hpp"
#include "forest/regeneration/regeneration.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/stand/self_thinning.hpp"
#include "forest/stand/site_height.hpp"

namespace forest {

namespace {

/// The year's light: on every patch and in every crown.
struct YearLight {
    LightYear year;
    LightField field;
    StandLight trees;
};

YearLight compute_year_light(const Stand& stand, const Site& site, const SpeciesTable& species,
                             const SiteWeather& weather, TreeLight model) {
    YearLight light;
    light.year = light_year_of(site, species, weather);
    const std::vector<LightTree> trees = light_trees_of(stand, species);
    const Canopy canopy{site.light().ground(), trees};
    light.field = compute_light(site.light(), canopy, light.year, trees);
    light.trees = model == TreeLight::by_layers
                      ? light_by_layers(stand, species, light.year.radiation)
                      : light_in_stand(stand, species, site.light(), canopy, light.field);
    return light;
}

std::vector<std::uint32_t> production_units_of(const Stand& stand, const Site& site) {
    std::vector<std::uint32_t> units;
    units.reserve(stand.trees().size());
    for (const Tree& tree : stand.trees()) {
        units.push_back(site.production_unit_of(tree.patch));
    }
    return units;
}

/// Greatest heights at the place, by site unit and species. Requires the stand to know its usual warmth.
std::vector<double> site_heights_m(const Stand& stand, const Site& site, const SpeciesTable& species) {
    std::vector<double> heights_m;
    heights_m.reserve(site.units().size() * species.size());
    for (const SiteUnit& unit : site.units()) {
        const PatchState& any = stand.patch_states()[index_of(unit.patches.front())];
        for (const Species& kind : species.all()) {
            heights_m.push_back(site_height_m(kind.height_growth, any.usual_degree_days));
        }
    }
    return heights_m;
}

/// What every tree has to grow with. Requires the stand to know its light ratios.
std::vector<TreeSeason> seasons_of(const Stand& stand, const Site& site, const SpeciesTable& species,
                                   const StandLight& light, const Season& season,
                                   std::span<const double> factors) {
    const std::span<const Tree> trees = stand.trees();
    const std::vector<double> heights_m = site_heights_m(stand, site, species);
    const auto greatest_m = [&](const Tree& tree) {
        return heights_m[site.unit_of(tree.patch) * species.size() + index_of(tree.species)];
    };
    std::vector<double> vigours(trees.size());
    std::transform(trees.begin(), trees.end(), vigours.begin(), [&](const Tree& tree) {
        const Species& kind = species[tree.species];
        return vigour(kind.vigour, tree.height_m / greatest_m(tree),
                      tree.age_years / kind.mortality.max_age_years);
    });
    const std::vector<TreeProduction> production = share_production(
        trees, species, light.absorbed, vigours, factors, production_units_of(stand, site), season.light_use);
    std::vector<TreeSeason> seasons(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Patch& patch = stand.grid()[trees[i].patch];
        seasons[i] = {.npp_kg = production[i].npp_kg,
                      .root_share = root_share(species[trees[i].species].three_pg.root_share,
                                               production[i].physiology, patch.soil.fertility),
                      .degree_days = season.degree_days[site.unit_of(trees[i].patch)],
                      .site_height_m = greatest_m(trees[i]),
                      .shaded_below_m = light.shaded_below_m[i]};
    }
    return seasons;
}

void grow_trees(Stand& stand, const SpeciesTable& species, std::span<const TreeSeason> seasons,
                YearReport& report) {
    const std::vector<TreeGrowth> growth = growth_of_trees(stand, species, seasons);
    for (std::size_t i = 0; i < growth.size(); ++i) {
        const Tree& tree = stand.trees()[i];
        const Allometry& allometry = species[tree.species].allometry;
        const double after_m3 =
            stem_volume_m3(allometry, tree.dbh_cm + growth[i].dbh_cm, tree.height_m + growth[i].height_m);
        report.volume_increment_m3 +=
            tree.stems * (after_m3 - stem_volume_m3(allometry, tree.dbh_cm, tree.height_m));
        report.production_kg += tree.stems * seasons[i].npp_kg;
    }
    stand.grow(growth);
}

/// What decides about canopy trees at the place of each tree. Requires the stand to know its usual warmth.
std::vector<CanopyPlace> places_of_trees(const Stand& stand, const Site& site, const CanopyDeaths& law) {
    std::vector<double> crowding = window_basal_areas_m2pha(stand, site.windows());
    for (double& value : crowding) {
        value = canopy_crowding(value, law);
    }
    const std::vector<double> larger_m2pha = larger_basal_areas_m2pha(stand, site.windows());
    std::vector<CanopyPlace> places;
    places.reserve(stand.trees().size());
    for (const Tree& tree : stand.trees()) {
        const PatchState& patch = stand.patch_states()[index_of(tree.patch)];
        places.push_back({.crowding = crowding[site.windows().window_of(tree.patch)],
                          .warmth = canopy_warmth(patch.usual_degree_days, law),
                          .larger_m2pha = larger_m2pha[places.size()]});
    }
    return places;
}

void apply_mortality(Stand& stand, const Site& site, const SpeciesTable& species,
                     const SpeciesDrought& drought, const Parameters& parameters, bool storms,
                     const YearKey& key) {
    stand.set_stress_years(stress_years_after(stand, species, parameters.mortality,
                                              production_units_of(stand, site),
                                              site.production_units().size()));
    const std::vector<double> of_drought =
        drought_death_chances(stand, drought, parameters.mortality.drought);
    const std::vector<CanopyPlace> places = places_of_trees(stand, site, parameters.mortality.canopy);
    stand.remove_trees(natural_deaths(stand, species, parameters.mortality, storms, places, of_drought,
                                      key.seed, key.replicate));
    stand.remove_trees(wound_deaths(stand, species, key.seed, key.replicate));
    if (parameters.processes.self_thinning) {
        stand.remove_trees(self_thinning(stand, species, site.windows(), key.seed, key.replicate));
    }
}

}  // namespace

YearReport grow_year(Stand& stand, const Site& site, const SpeciesTable& species, const SiteWeather& weather,
                     const Parameters& parameters, const YearKey& key) {
    YearReport report;
    stand.begin_year();

    const YearLight light = compute_year_light(stand, site, species, weather, parameters.processes.light);
    const Season season =
        compute_season(stand, site, species, weather, light.year, light.field, parameters.processes);
    stand.set_light_ratios(light.trees.ratios);
    stand.set_patch_states(season.patches);
    report.water = season.water;
    report.light_closure = light.field.closure[6];

    const std::vector<double> factors =
        growth_factors(stand.trees(), parameters.differences, key.seed, key.replicate);
    grow_trees(stand, species, seasons_of(stand, site, species, light.trees, season, factors), report);
    stand.split_groups(single_tree_cm, key.seed, key.replicate);
    const DisturbanceLaw disturbance = parameters.disturbance.in_year(stand.year());
    apply_mortality(stand, site, species, season.drought, parameters, disturbance.wind, key);
    disturb(stand, site, species, weather, season.drought, disturbance, key.seed, key.replicate);
    heal(stand, species);
    if (parameters.processes.regeneration) {
        regenerate(stand, site, species, weather.units, season.drought, parameters.regeneration, key.seed,
                   key.replicate);
    }
    age_dead_wood(stand, site, species, weather.units, key.seed, key.replicate);
    return report;
}

}  // namespace forest
