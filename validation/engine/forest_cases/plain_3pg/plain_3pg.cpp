#include "validation/engine/forest_cases/plain_3pg/plain_3pg.hpp"

#include <algorithm>
#include <utility>

#include "config/errors/input_error.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/production/day_length.hpp"
#include "validation/engine/forest_cases/plain_3pg/growth.hpp"
#include "validation/engine/forest_cases/plain_3pg/light.hpp"
#include "validation/engine/forest_cases/plain_3pg/mortality.hpp"
#include "validation/engine/forest_cases/plain_3pg/sizes.hpp"
#include "validation/engine/forest_cases/plain_3pg/water.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

void add_rows(std::vector<Row>& rows, const Stand& stand, const ClimateMonth& month) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        rows.push_back({month.when, i, month, stand.day_length_s, stand.species[i], stand.water});
    }
}

/// The state before the first month grows.
Stand starting_stand(const Inputs& inputs, const Settings& settings) {
    Stand stand;
    stand.species.resize(inputs.species.size());
    const Site& site = inputs.site;
    const double least_mm = std::min(site.min_water_mm, site.max_water_mm);
    stand.water.soil_mm = std::max(std::min(site.start_water_mm, site.max_water_mm), least_mm);
    stand.water.supply = 1.0;
    const ClimateMonth& first = inputs.climate.front();
    stand.day_length_s = forest::day_length_s(site.latitude, first.when.month);
    grow_older(stand, inputs, first.when);
    climate_modifiers(stand, inputs, first);
    plant(stand, inputs, first.when);
    start_sizes(stand, inputs, settings.height);
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        Sizes& sizes = stand.species[i].sizes;
        sizes.volume_m3pha = volume_m3pha(stand.species[i], inputs.parameters[i]);
        sizes.volume_total_m3pha = sizes.volume_m3pha;
    }
    update_basal_area_shares(stand);
    return stand;
}

void begin_month(Stand& stand, const Inputs& inputs, const ClimateMonth& month, const Settings& settings) {
    stand.day_length_s = forest::day_length_s(inputs.site.latitude, month.when.month);
    grow_older(stand, inputs, month.when);
    climate_modifiers(stand, inputs, month);
    const bool planted = plant(stand, inputs, month.when);
    const bool turned = turn_leaves(stand, inputs, month.when.month);
    if (planted || turned) {
        update_sizes(stand, inputs, settings.height);
    }
}

void absorb_light(Stand& stand, const Inputs& inputs, const ClimateMonth& month, LightModel model) {
    if (model == LightModel::layers) {
        absorb_by_layers(stand, inputs, month);
    } else {
        absorb_as_one_canopy(stand, inputs, month);
    }
}

/// Volumes after trees were cut: what was cut is no loss of growth.
void update_volumes(Stand& stand, const Inputs& inputs) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        stand.species[i].sizes.volume_m3pha = volume_m3pha(stand.species[i], inputs.parameters[i]);
    }
}

}  // namespace

std::vector<Row> run(const Inputs& inputs, const Settings& settings) {
    std::vector<Row> rows;
    Stand stand = starting_stand(inputs, settings);
    ThinningList thinnings{inputs};
    add_rows(rows, stand, inputs.climate.front());

    for (std::size_t m = 1; m < inputs.climate.size(); ++m) {
        const ClimateMonth& month = inputs.climate[m];
        begin_month(stand, inputs, month, settings);

        absorb_light(stand, inputs, month, settings.light);
        limit_production(stand, inputs, month, settings);
        produce(stand, inputs);
        balance_water(stand, inputs, month, settings.transpiration);
        allocate(stand, inputs, month.when.month);
        update_leaves_and_trees(stand);
        update_sizes(stand, inputs, settings.height);
        measure_growth(stand, inputs);

        thinnings.thin(stand, inputs, month.when.month);
        const bool cut = stand.sizes_outdated;
        update_sizes_if_outdated(stand, inputs, settings.height);
        if (cut) {
            update_volumes(stand, inputs);
        }
        die_at_random(stand, inputs, month.when.month);
        update_sizes_if_outdated(stand, inputs, settings.height);
        thin_themselves(stand, inputs, month.when.month);
        update_sizes_if_outdated(stand, inputs, settings.height);
        update_basal_area_shares(stand);
        add_rows(rows, stand, month);
    }
    return rows;
}

Inputs inputs_of(const Site& site, std::vector<StartingSpecies> species,
                 const std::vector<Parameters>& parameters, std::vector<ClimateMonth> climate,
                 std::vector<Thinning> thinnings) {
    config::Problems problems;
    Inputs inputs{site, std::move(species), {}, std::move(climate), std::move(thinnings)};
    for (const StartingSpecies& wanted : inputs.species) {
        const auto found = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const Parameters& p) { return p.species == wanted.species; });
        if (found != parameters.end()) {
            inputs.parameters.push_back(*found);
        } else {
            problems.add(config::ExitCode::data, {}, "no parameters of " + config::in_quotes(wanted.species));
        }
    }
    if (inputs.species.empty()) {
        problems.add(config::ExitCode::data, {}, "no species", "at least one");
    }
    problems.throw_if_any();
    return inputs;
}

}  // namespace coupling::validation::forest_cases::plain_3pg
