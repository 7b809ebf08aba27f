#include "forest/site/season.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "forest/climate/calendar.hpp"
#include "forest/climate/summary.hpp"
#include "forest/production/day_length.hpp"
#include "forest/production/three_pg_modifiers.hpp"
#include "forest/stand/site_height.hpp"

namespace forest {

namespace {

constexpr std::size_t months = 12;

/// Species that stand in the forest: the water of a patch asks for those only.
std::vector<SpeciesId> species_present(const Stand& stand) {
    std::vector<char> present(stand.species_count(), 0);
    for (const Tree& tree : stand.trees()) {
        present[index_of(tree.species)] = 1;
    }
    std::vector<SpeciesId> list;
    for (std::size_t s = 0; s < present.size(); ++s) {
        if (present[s] != 0) {
            list.push_back(SpeciesId{static_cast<std::uint16_t>(s)});
        }
    }
    return list;
}

/// Leaf area index by patch and species.
std::vector<double> leaf_areas(const Stand& stand) {
    std::vector<double> lai(stand.grid().size() * stand.species_count(), 0.0);
    for (const Tree& tree : stand.trees()) {
        lai[index_of(tree.patch) * stand.species_count() + index_of(tree.species)] +=
            tree.stems * tree.crown.leaf_area_m2 / patch_area_m2;
    }
    return lai;
}

/// Radiation of a month on the ground of a site unit.
struct UnitRadiation {
    double on_map = 1.0;    ///< per area on the map / on the flat
    double on_slope = 1.0;  ///< per area of the slope / on the flat
};

UnitRadiation radiation_of(const SiteUnit& unit, const Stand& stand, const Site& site,
                           const LightField& light, std::size_t month, double flat_mjpm2) {
    if (flat_mjpm2 <= 0.0) {
        return {};
    }
    UnitRadiation sum{0.0, 0.0};
    for (const PatchId patch : unit.patches) {
        const auto incoming =
            static_cast<double>(light.incoming_mjpm2[site.column_of(patch) * months + month]);
        sum.on_map += incoming;
        sum.on_slope += incoming * turn_of(stand.grid()[patch].slope).cos;
    }
    const double scale = 1.0 / (static_cast<double>(unit.patches.size()) * flat_mjpm2);
    // A month whose sun never clears the horizon has little light; the response to it has no meaning
    // below that.
    constexpr double least = 0.01;
    return {std::max(least, sum.on_map * scale), std::max(least, sum.on_slope * scale)};
}

/// A month of a site unit, for water and production.
struct UnitMonth {
    UnitRadiation radiation;
    WaterMonth water;
    std::vector<WaterUse> uses;  ///< by species
};

using UnitYear = std::array<UnitMonth, months>;

UnitYear year_of_unit(const SiteUnit& unit, const ClimateYear& climate, const Stand& stand, const Site& site,
                      const SpeciesTable& species, double co2_ppm, const LightYear& light_year,
                      const LightField& light) {
    constexpr double prime_age = 1.0;
    UnitYear year;
    for (std::size_t m = 0; m < months; ++m) {
        const int month = static_cast<int>(m) + 1;
        const double flat_mjpm2 =
            light_year.radiation.direct_mjpm2[m] + light_year.radiation.diffuse_mjpm2[m];
        year[m].radiation = radiation_of(unit, stand, site, light, m, flat_mjpm2);
        year[m].water = water_month(climate.months[m], month, day_length_s(site.latitude(), month),
                                    year[m].radiation.on_map);
        for (const Species& kind : species.all()) {
            year[m].uses.push_back(water_use(kind, climate.months[m], prime_age, co2_ppm));
        }
    }
    return year;
}

/// Sums over the patches of a production unit.
struct UnitWater {
    explicit UnitWater(std::size_t species) : response(months * species, 0.0) {}
    std::vector<double> response;  ///< by month and species
    std::array<double, months> supply{};
    double patches = 0.0;
};

/// The water of one patch, month by month. `response` receives that of each species over the growing season.
PatchState balance_patch(PatchState state, const WaterStore& store, const UnitYear& year,
                         const ClimateYear& climate, std::span<const double> lai_of_month,
                         std::span<const float> ground_mjpm2, std::span<const float> incoming_mjpm2,
                         UnitWater& unit, WaterYear& sum, std::span<double> response) {
    const std::size_t kinds = response.size();
    WaterState water{state.soil_water_mm, state.snow_water_mm};
    DroughtSum drought;
    double weight = 0.0;
    std::fill(response.begin(), response.end(), 0.0);
    std::vector<double> of_month(kinds);
    for (std::size_t m = 0; m < months; ++m) {
        const double ground_light =
            incoming_mjpm2[m] > 0.0F
                ? std::clamp(static_cast<double>(ground_mjpm2[m] / incoming_mjpm2[m]), 0.0, 1.0)
                : 1.0;
        const WaterFlows flows =
            balance_month(water, year[m].water, store, year[m].uses, lai_of_month.subspan(m * kinds, kinds),
                          ground_light, of_month);
        drought.add(climate.months[m].tave_degc, flows);
        const double demand_mm = DroughtSum::counts(climate.months[m].tave_degc) ? flows.demand_mm : 0.0;
        weight += demand_mm;
        for (std::size_t s = 0; s < kinds; ++s) {
            unit.response[m * kinds + s] += of_month[s];
            response[s] += demand_mm * of_month[s];
        }
        unit.supply[m] += flows.supply;
        sum.precipitation_mm += year[m].water.rain_mm + year[m].water.snow_mm;
        sum.evapotranspiration_mm += flows.evapotranspiration_mm;
        sum.transpiration_mm += flows.transpiration_mm;
        sum.runoff_mm += flows.runoff_mm;
    }
    for (double& of_species : response) {
        of_species = weight > 0.0 ? of_species / weight : 1.0;
    }
    unit.patches += 1.0;
    sum.storage_gain_mm += water.soil_mm + water.snow_mm - state.soil_water_mm - state.snow_water_mm;
    state.soil_water_mm = water.soil_mm;
    state.snow_water_mm = water.snow_mm;
    state.drought_index = drought.index();
    return state;
}

/// A patch that is never short of water.
PatchState patch_without_limits(PatchState state, UnitWater& unit) {
    for (double& response : unit.response) {
        response += 1.0;
    }
    for (double& supply : unit.supply) {
        supply += 1.0;
    }
    unit.patches += 1.0;
    state.drought_index = 0.0;
    return state;
}

YearOfLightUse light_use_of_unit(const SpeciesTable& table, SpeciesId id, const SiteUnit& site_unit,
                                 const UnitYear& year, const ClimateYear& climate, const UnitWater& water,
                                 const SiteWeather& weather) {
    const Species& species = table[id];
    const double co2_modifier =
        weather.co2_response
            ? co2_assimilation_modifier(weather.co2_ppm, species.three_pg.assimilation_at_700)
            : 1.0;
    std::array<MonthConditions, months> conditions;
    for (std::size_t m = 0; m < months; ++m) {
        conditions[m] = {.mean_degc = climate.months[m].tave_degc,
                         .frost_days = climate.months[m].frost_days,
                         .vpd_kpa = climate.months[m].vpd_kpa,
                         .water_modifier = water.response[m * table.size() + index_of(id)] / water.patches,
                         .co2_modifier = co2_modifier,
                         .supply = water.supply[m] / water.patches,
                         .slope_radiation = year[m].radiation.on_slope};
    }
    return light_use_of_year(species, conditions, site_unit.soil);
}

/// Leaf area index of the species on a patch, month by month: none while leaves are off.
void leaves_of_months(std::span<const double> full, const SpeciesTable& species,
                      std::span<double> lai_of_month) {
    for (std::size_t m = 0; m < months; ++m) {
        for (std::size_t s = 0; s < full.size(); ++s) {
            const bool in_leaf = full[s] > 0.0 && species.all()[s].light.in_leaf(static_cast<int>(m) + 1);
            lai_of_month[m * full.size() + s] = in_leaf ? full[s] : 0.0;
        }
    }
}

WaterYear mean_of(WaterYear sum, std::size_t patches) {
    const double share = patches > 0 ? 1.0 / static_cast<double>(patches) : 0.0;
    sum.precipitation_mm *= share;
    sum.evapotranspiration_mm *= share;
    sum.transpiration_mm *= share;
    sum.runoff_mm *= share;
    sum.storage_gain_mm *= share;
    return sum;
}

}  // namespace

LightYear light_year_of(const Site& site, const SpeciesTable& species, const SiteWeather& weather) {
    LightYear year;
    if (weather.units.empty()) {
        return year;
    }
    std::array<double, months> daily_mjpm2{};
    for (std::size_t m = 0; m < months; ++m) {
        daily_mjpm2[m] = weather.units.front().months[m].radiation_mjpm2;
        year.leaves_on[m] = false;
        for (const Species& kind : species.all()) {
            year.leaves_on[m] =
                year.leaves_on[m] || (!kind.evergreen && kind.light.in_leaf(static_cast<int>(m) + 1));
        }
    }
    year.radiation = split_radiation(site.latitude(), daily_mjpm2);
    return year;
}

Season compute_season(const Stand& stand, const Site& site, const SpeciesTable& species,
                      const SiteWeather& weather, const LightYear& light_year, const LightField& light,
                      const Processes& processes) {
    assert(weather.units.size() == site.units().size());
    constexpr double reference_co2_ppm = 350.0;
    const double co2_ppm = weather.co2_response ? weather.co2_ppm : reference_co2_ppm;
    const std::vector<SpeciesId> present = species_present(stand);
    const std::vector<double> lai = leaf_areas(stand);
    const std::size_t kinds = species.size();

    Season season;
    season.drought = SpeciesDrought{stand.grid().size(), kinds};
    std::vector<UnitYear> years;
    for (std::size_t u = 0; u < site.units().size(); ++u) {
        years.push_back(year_of_unit(site.units()[u], weather.units[u], stand, site, species, co2_ppm,
                                     light_year, light));
        season.degree_days.push_back(degree_days(weather.units[u]));
    }

    std::vector<UnitWater> water(site.production_units().size(), UnitWater{kinds});
    std::vector<double> lai_of_month(months * kinds);
    std::vector<double> response(kinds);
    season.patches.reserve(stand.grid().size());
    for (std::size_t i = 0; i < stand.grid().size(); ++i) {
        const PatchId patch{static_cast<std::uint32_t>(i)};
        const std::size_t column = site.column_of(patch);
        const std::uint32_t unit = site.unit_of(patch);
        PatchState state = stand.patch_states()[i];
        if (processes.water) {
            leaves_of_months(std::span{lai}.subspan(i * kinds, kinds), species, lai_of_month);
            state =
                balance_patch(state, site.water_store(patch), years[unit], weather.units[unit], lai_of_month,
                              std::span{light.ground_mjpm2}.subspan(column * months, months),
                              std::span{light.incoming_mjpm2}.subspan(column * months, months),
                              water[site.production_unit_of(patch)], season.water, response);
            for (std::size_t s = 0; s < kinds; ++s) {
                season.drought.set(patch, SpeciesId{static_cast<std::uint16_t>(s)}, response[s]);
            }
        } else {
            state = patch_without_limits(state, water[site.production_unit_of(patch)]);
        }
        const UsualWarmth usual =
            after_year({state.usual_degree_days, state.warmth_years}, season.degree_days[unit]);
        state.usual_degree_days = usual.degree_days;
        state.warmth_years = static_cast<std::uint16_t>(usual.years);
        state.ground_light = std::clamp(static_cast<double>(light.ground_light[column]), 0.0, 1.0);
        state.june_sun_hours = static_cast<double>(light.june_sun_hours[column]);
        season.patches.push_back(state);
    }
    season.water = mean_of(season.water, stand.grid().size());

    season.light_use.resize(site.production_units().size() * species.size());
    for (std::size_t p = 0; p < site.production_units().size(); ++p) {
        const std::uint32_t unit = site.production_units()[p].site_unit;
        for (const SpeciesId id : present) {
            season.light_use[p * species.size() + index_of(id)] = light_use_of_unit(
                species, id, site.units()[unit], years[unit], weather.units[unit], water[p], weather);
        }
    }
    return season;
}

}  // namespace forest
