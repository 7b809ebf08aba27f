#include "validation/engine/forest_cases/succession_trial/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace coupling::validation::forest_cases::succession_trial {

namespace {

using forest::at_elevation;
using forest::index_of;
using forest::SpeciesId;
using forest::SpeciesTable;
using forest::YearWindow;

void require(const config::Table& table, const std::vector<std::string>& columns) {
    config::Problems problems;
    table.require(columns, problems);
    problems.throw_if_any();
}

double share_of(const SpeciesGroup& group, const std::vector<double>& biomass, double all) {
    double sum = 0.0;
    for (const SpeciesId kind : group.species) {
        sum += biomass[index_of(kind)];
    }
    return all > 0.0 ? sum / all : 0.0;
}

template <std::size_t place>
double dead_wood_of(const SuccessionState& state) {
    return state.dead_wood_by_class_m3pha[place];
}

template <forest::Cause cause>
double lost_to(const SuccessionState& state) {
    return state.lost_m3pha[forest::index_of(cause)];
}

/// Replicates of a site in which stems of a species are left at the end.
double replicates_with(const SpeciesGroup& native, std::span<const SuccessionRun> runs,
                       double SpeciesShare::*stems_pha) {
    double kept = 0.0;
    for (const SuccessionRun& run : runs) {
        if (run.site == native.site && !run.states.empty()) {
            const SpeciesShare& left = run.states.back().species[index_of(native.species.front())];
            kept += left.*stems_pha > 0.0 ? 1.0 : 0.0;
        }
    }
    return kept;
}

double greatest_share_outside(const SpeciesGroup& group, std::vector<double> biomass, double all) {
    for (const SpeciesId kind : group.species) {
        biomass[index_of(kind)] = 0.0;
    }
    return all > 0.0 ? *std::max_element(biomass.begin(), biomass.end()) / all : 0.0;
}

}  // namespace

std::vector<std::string> site_columns() {
    return {"site", "elevation_m", "fertility",  "water_mm", "nitrogen_kg_ha_yr",
            "ph",   "warmer_k",    "rain_factor"};
}

std::vector<SuccessionSite> read_succession_sites(const config::Table& table) {
    require(table, {"site", "elevation_m", "fertility", "water_mm", "nitrogen_kg_ha_yr", "ph"});
    config::Problems problems;
    const auto number = [&](std::size_t row, const char* column, double low, double high) {
        return table.number(row, column, {.low = low, .high = high}, problems).value_or(0.0);
    };
    std::vector<SuccessionSite> sites;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SuccessionSite site;
        site.name = table.text(row, "site");
        site.elevation_m = number(row, "elevation_m", 0.0, 4000.0);
        site.soil.fertility = number(row, "fertility", 0.0, 1.0);
        site.soil.water_capacity_mm = number(row, "water_mm", 1.0, 600.0);
        site.soil.nitrogen_kg_per_ha_year = number(row, "nitrogen_kg_ha_yr", 0.0, 200.0);
        site.soil.ph = number(row, "ph", 2.5, 9.0);
        if (table.has("warmer_k")) {
            site.warmer_k = number(row, "warmer_k", -15.0, 15.0);
        }
        if (table.has("rain_factor")) {
            site.rain_factor = number(row, "rain_factor", 0.0, 10.0);
        }
        sites.push_back(site);
    }
    problems.throw_if_any();
    return sites;
}

std::vector<SpeciesGroup> read_species_groups(const config::Table& table, const SpeciesTable& species) {
    require(table, {"site", "group", "species"});
    config::Problems problems;
    std::vector<SpeciesGroup> groups;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SpeciesGroup group{table.text(row, "site"), table.text(row, "group"), {}};
        std::istringstream names{table.text(row, "species")};
        for (std::string name; names >> name;) {
            if (const auto kind = species.find(name, table.place(row, "species"), problems)) {
                group.species.push_back(*kind);
            }
        }
        groups.push_back(std::move(group));
    }
    problems.throw_if_any();
    return groups;
}

std::vector<SpeciesGroup> read_natives(const config::Table& table, const SpeciesTable& species) {
    require(table, {"site", "species"});
    config::Problems problems;
    std::vector<SpeciesGroup> natives;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& name = table.text(row, "species");
        if (const auto kind = species.find(name, table.place(row, "species"), problems)) {
            natives.push_back({table.text(row, "site"), species[*kind].code, {*kind}});
        }
    }
    problems.throw_if_any();
    return natives;
}

SuccessionTrial trial_at(const SuccessionCase& data, const SuccessionSite& site) {
    if (!data.climate.elevation_m) {
        config::fail(config::ExitCode::data, {}, "the climate of the case does not say its elevation",
                     "a column elev_m");
    }
    SuccessionTrial trial;
    trial.soil = site.soil;
    trial.parameters = data.parameters;
    trial.climate =
        at_elevation(data.climate, site.elevation_m - *data.climate.elevation_m, data.lapse_rates);
    const forest::ClimateChange change = forest::ClimateChange::of(site.warmer_k, site.rain_factor);
    for (forest::ClimateYear& year : trial.climate.years) {
        year = forest::changed(year, change);
    }
    trial.window = {trial.climate.first_year(), trial.climate.last_year()};
    return trial;
}

std::vector<double> mean_biomass_tpha(std::span<const SuccessionRun> runs, const std::string& site,
                                      YearWindow years) {
    std::vector<double> sums;
    double states = 0.0;
    for (const SuccessionRun& run : runs) {
        for (const SuccessionState& state : run.states) {
            if (run.site != site || state.year < years.first || state.year > years.last) {
                continue;
            }
            sums.resize(state.species.size());
            for (std::size_t s = 0; s < sums.size(); ++s) {
                sums[s] += state.species[s].biomass_tpha;
            }
            states += 1.0;
        }
    }
    for (double& sum : sums) {
        sum /= states;
    }
    return sums;
}

double mean_of(std::span<const SuccessionRun> runs, const std::string& site, YearWindow years,
               const std::function<double(const SuccessionState&)>& figure) {
    double sum = 0.0;
    double states = 0.0;
    for (const SuccessionRun& run : runs) {
        for (const SuccessionState& state : run.states) {
            if (run.site == site && state.year >= years.first && state.year <= years.last) {
                sum += figure(state);
                states += 1.0;
            }
        }
    }
    return states > 0.0 ? sum / states : 0.0;
}

const std::vector<StandMeasure>& stand_measures() {
    static const std::vector<StandMeasure> measures{
        {"biomass_tpha", "biomass above ground", "t/ha", [](const auto& s) { return s.biomass_tpha(); }},
        {"volume_m3pha", "stem wood", "m3/ha", [](const auto& s) { return s.volume_m3pha; }},
        {"basal_area_m2pha", "basal area", "m2/ha", [](const auto& s) { return s.basal_area_m2pha(); }},
        {"stems_60cm_pha", "stems above 60 cm", "1/ha", [](const auto& s) { return s.thick_stems_pha; }},
        {"top_height_m", "height of the 100 thickest", "m", [](const auto& s) { return s.top_height_m; }},
        {"dead_wood_m3pha", "dead wood", "m3/ha", [](const auto& s) { return s.dead_wood_m3pha; }},
        {"dead_wood_class1_m3pha", "dead wood of decay class 1", "m3/ha", dead_wood_of<0>},
        {"dead_wood_class2_m3pha", "dead wood of decay class 2", "m3/ha", dead_wood_of<1>},
        {"dead_wood_class3_m3pha", "dead wood of decay class 3", "m3/ha", dead_wood_of<2>},
        {"dead_wood_class4_m3pha", "dead wood of decay class 4", "m3/ha", dead_wood_of<3>},
        {"dead_wood_class5_m3pha", "dead wood of decay class 5", "m3/ha", dead_wood_of<4>},
        {"lost_to_wind_m3pha", "stem wood thrown by storms a year", "m3/ha", lost_to<forest::Cause::wind>},
        {"lost_to_snow_m3pha", "stem wood broken by wet snow a year", "m3/ha", lost_to<forest::Cause::snow>},
        {"lost_to_beetle_m3pha", "stem wood killed by bark beetles a year", "m3/ha",
         lost_to<forest::Cause::beetle>},
        {"drought_index", "drought index", "-", [](const auto& s) { return s.drought_index; }}};
    return measures;
}

std::vector<std::pair<std::string, double>> succession_figures(const SuccessionCase& data,
                                                               std::span<const SuccessionRun> runs,
                                                               YearWindow years) {
    std::vector<std::pair<std::string, double>> figures;
    for (const SuccessionSite& site : data.sites) {
        const std::vector<double> biomass = mean_biomass_tpha(runs, site.name, years);
        if (biomass.empty()) {
            continue;
        }
        const double all = std::accumulate(biomass.begin(), biomass.end(), 0.0);
        for (const StandMeasure& measure : stand_measures()) {
            figures.emplace_back(measure.name + (":" + site.name),
                                 mean_of(runs, site.name, years, measure.of));
        }
        for (std::size_t i = 0; i < death_class_from_cm.size(); ++i) {
            const auto lived = [i](const SuccessionState& state) { return state.deaths[i].tree_years; };
            const auto died = [i](const SuccessionState& state) { return state.deaths[i].deaths; };
            const double tree_years = mean_of(runs, site.name, years, lived);
            figures.emplace_back(
                "death_rate_from_" + std::to_string(std::lround(death_class_from_cm[i])) + "cm:" + site.name,
                tree_years > 0.0 ? mean_of(runs, site.name, years, died) / tree_years : 0.0);
        }
        for (const SpeciesGroup& group : data.groups) {
            if (group.site == site.name) {
                const double share = share_of(group, biomass, all);
                const std::string of = group.name + ":" + site.name;
                figures.emplace_back("share:" + of, share);
                figures.emplace_back("margin:" + of, share - greatest_share_outside(group, biomass, all));
            }
        }
        for (const SpeciesGroup& native : data.natives) {
            if (native.site == site.name) {
                const std::string of = native.name + ":" + site.name;
                figures.emplace_back("kept:" + of,
                                     replicates_with(native, runs, &SpeciesShare::stems_10cm_pha));
                figures.emplace_back("alive:" + of, replicates_with(native, runs, &SpeciesShare::stems_pha));
            }
        }
    }
    return figures;
}

}  // namespace coupling::validation::forest_cases::succession_trial
