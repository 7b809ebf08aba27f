#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "coupling/inputs/scenario/decision_settings.hpp"
#include "forest/light/ground.hpp"
#include "forest/parameters.hpp"

namespace coupling {

/// Which years of the climate series the simulated years get.
enum class ClimateOrder : std::uint8_t {
    once,    ///< their own
    repeat,  ///< their own, then the window over and over
    random,  ///< drawn from the window
};

/// What a forest simulation asks for, as the user wrote it; without effect where run.years is 0.
struct ForestSettings {
    // [run]
    std::uint64_t first_year =
        0;  ///< calendar year of the first simulated year; 0: first of the climate window
    std::uint64_t rockfall_every = 1;  ///< years; 0: no rocks at all
    std::uint64_t replicates = 1;

    // [forest]
    double latitude_deg = 0.0;
    std::string species;         ///< CSV; empty: the shipped table
    std::string region_species;  ///< codes of species whose seeds come from outside; empty: all of the table
    std::string browsing_by_species;  ///< "ABAL 3, FASY 0.5": factors on forest.browsing_pressure
    forest::Edges edges = forest::Edges::mirror;
    forest::Parameters parameters;

    // [stands]
    std::string stand_map;           ///< grid of stand numbers, or
    std::string stand_polygons;      ///< CSV: stand, wkt
    std::uint64_t stand_number = 0;  ///< all the terrain is this stand of several; 0: stand 1, the only one
    std::string stand_records;       ///< CSV: stand, species, stems_pha, ...
    std::string stand_cover;         ///< grid of crown cover: where in their stand the stems stand
    std::string dead_wood;       ///< CSV: stand, species, kind, volume_m3pha, ...; empty: none at the start
    std::string saplings;        ///< CSV: stand, species, height_m, stems_pha; empty: none at the start
    std::string dbh_classes;     ///< CSV: stand, species, dbh_from_cm, dbh_to_cm, stems_pha, height_m
    std::string target_profile;  ///< CSV: stand, site_type, hazard, criterion, minimal, ideal
    std::uint64_t spin_up_years = 0;  ///< for the dead wood and saplings that no file gives
    std::string tree_area;            ///< CSV of polygons: the list of trees holds there, records elsewhere

    // [soil]
    std::string soil_map;    ///< grid of soil codes
    std::string soil_types;  ///< CSV: code, water_capacity_mm, ...
    std::string soil_type;   ///< name of a shipped type, wherever the map says nothing

    // [climate]
    std::string climate;  ///< CSV of months
    double climate_elevation_m = 0.0;
    ClimateOrder order = ClimateOrder::once;
    std::uint64_t window_first_year = 0;  ///< 0: first of the series
    std::uint64_t window_last_year = 0;   ///< 0: last of the series
    double temperature_change_k = 0.0;
    double precipitation_change = 1.0;      ///< factor
    std::string climate_change;             ///< CSV: month, temperature_k, precipitation
    std::uint64_t change_years = 0;         ///< until the change is complete; 0: from the first year on
    double co2_ppm = 0.0;                   ///< 0: the shipped series
    std::vector<double> dry_years;          ///< calendar years with a dry, warm season
    double dry_season_k = 2.5;              ///< added to April to September of such years
    double dry_season_precipitation = 0.7;  ///< factor on them
    std::string climate_variants;           ///< CSV: name and what differs from the above; empty: one climate

    // [regimes]
    std::string regimes = "none";  ///< names of shipped regimes or CSV files, parted by commas
    std::string timber_prices;     ///< CSV, with
    std::string work_costs;        ///< CSV; both empty: the shipped ones
    double machine_m3ph = 8.0;     ///< stem wood that a machine brings out in an hour of work

    DecisionSettings decision;  ///< [decision]

    // [feedback]
    bool feedback = false;        ///< rocks break and wound trees
    double rocks_per_year = 0.0;  ///< that really fall on the whole slope

    // [output]
    std::vector<double> tree_list_years;  ///< years of simulation, 0 = the start
    std::vector<double> map_years;
    bool list_all_removed = false;   ///< removed_trees.csv lists all causes
    bool living_trees_alone = true;  ///< the same rocks also fall through the living trees without dead wood
};

/// Declares all of them. The options keep references into the settings.
void declare(config::Options& options, ForestSettings& settings);

/// What contradicts itself or misses for a simulation of `years` (0: nothing is asked for). `listed_trees`
/// says whether the scenario names a tree list.
void check(const ForestSettings& settings, std::uint64_t years, bool listed_trees,
           const config::Options& options, config::Problems& problems);

/// Years of simulation, rising and each once: those asked for, else the first (0) and the last.
std::vector<int> chosen_years(const std::vector<double>& asked_for, std::uint64_t years);

}  // namespace coupling
