#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "config/table/table.hpp"
#include "forest/climate/change.hpp"
#include "validation/engine/forest_cases/succession_trial/trial.hpp"

namespace coupling::validation::forest_cases::succession_trial {

/// A place on an elevation gradient.
struct SuccessionSite {
    std::string name;  ///< such as "e1500"
    double elevation_m = 0.0;
    forest::Soil soil;
    double warmer_k = 0.0;     ///< than the climate of the case at that elevation
    double rain_factor = 1.0;  ///< of its precipitation
};

/// Species of a site that a criterion speaks of together.
struct SpeciesGroup {
    std::string site;
    std::string name;  ///< such as "beech_fir"
    std::vector<forest::SpeciesId> species;
};

/// Sites, groups and climate of a comparison.
///
/// A case is run like this, in any order and on any number of threads:
///
///     for each site, for each replicate:
///         runs.push_back({site.name, grow_succession(trial_at(data, site), species, {seed, replicate})});
///     figures = succession_figures(data, runs, {300, 400});
struct SuccessionCase {
    std::vector<SuccessionSite> sites;
    std::vector<SpeciesGroup> groups;
    forest::ClimateSeries climate;  ///< knows its elevation
    forest::LapseRates lapse_rates;
    forest::Parameters parameters;        ///< of grow_year: case.ini says which processes are off
    std::vector<SpeciesGroup> natives{};  ///< one species each, named by its code
};

/// Reads site,elevation_m,fertility,water_mm,nitrogen_kg_ha_yr,ph and, where there are such columns, warmer_k
/// and rain_factor: another climate than that of the case at the elevation. Each reader throws one InputError
/// (data) for all problems.
std::vector<SuccessionSite> read_succession_sites(const config::Table& table);
/// The columns that it knows, `warmer_k` and `rain_factor` where they are there.
std::vector<std::string> site_columns();
/// Reads site,group,species (codes or names of one word, separated by blanks); other columns are read over.
std::vector<SpeciesGroup> read_species_groups(const config::Table& table,
                                              const forest::SpeciesTable& species);

/// Reads site,species (one code or name), for each species that grows at a place by nature.
std::vector<SpeciesGroup> read_natives(const config::Table& table, const forest::SpeciesTable& species);

/// The trial of a site: climate at its elevation, changed as the site says, weather drawn from all years of
/// the series. Throws InputError (data) if the series does not know its elevation.
SuccessionTrial trial_at(const SuccessionCase& data, const SuccessionSite& site);

/// One replicate at one site.
struct SuccessionRun {
    std::string site;
    std::vector<SuccessionState> states;
};

/// Mean biomass by species over the states of `years` and all replicates of a site [t/ha]; empty without any.
std::vector<double> mean_biomass_tpha(std::span<const SuccessionRun> runs, const std::string& site,
                                      forest::YearWindow years);

/// Mean of a figure over the states of `years` and all replicates of a site; 0 without any.
double mean_of(std::span<const SuccessionRun> runs, const std::string& site, forest::YearWindow years,
               const std::function<double(const SuccessionState&)>& figure);

/// A figure of the whole stand, by its name in succession_figures().
struct StandMeasure {
    const char* name;
    const char* label;
    const char* unit;
    std::function<double(const SuccessionState&)> of;
};
const std::vector<StandMeasure>& stand_measures();

/// The figures that criteria speak of: {"biomass_tpha:e1500", 310.0} and the other measures of the stand;
/// death_rate_from_10cm, _20cm, _40cm, _60cm (share of trees of that size class that die in a year); for each
/// group {"share:spruce:e1500",
/// 0.7}, its part of the biomass, and {"margin:spruce:e1500", 0.6}, its share less that of the greatest
/// species outside it (above 0: the group leads). 0 without trees. For each native species
/// {"kept:piab:e1500", 10}: replicates with a tree of it from 10 cm on in the last state, and
/// {"alive:piab:e1500", 10}: with a tree of it at all (from 1 cm on). Sites without runs give no figures.
std::vector<std::pair<std::string, double>> succession_figures(const SuccessionCase& data,
                                                               std::span<const SuccessionRun> runs,
                                                               forest::YearWindow years);

}  // namespace coupling::validation::forest_cases::succession_trial
