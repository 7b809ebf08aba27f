#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/validation/forest_cases/yield_trial/trial.hpp"

namespace coupling::validation::forest_cases::yield_trial {

/// A stand of a yield table.
struct YieldTableRow {
    std::string table;
    double site_class = 1.0;  ///< 1 is best; tables have halves, too
    int age_years = 0;
    double mean_height_m = 0.0;  ///< of the tree of mean basal area
    double mean_dbh_cm = 0.0;
    double stems_pha = 0.0;
    double basal_area_m2pha = 0.0;
    double volume_m3pha = 0.0;  ///< wood of 7 cm and more, over bark
};

/// A place where a trial grows.
struct YieldSite {
    std::string name;  ///< such as "piab_1000"
    forest::SpeciesId species{};
    double elevation_m = 0.0;
    double fertility = 0.0;
    std::string table;  ///< it is held against, "" for none
    double site_class = 0.0;
};

/// Sites, tables and climate of a comparison.
struct YieldCase {
    std::vector<YieldSite> sites;
    std::vector<YieldTableRow> rows;
    std::vector<forest::ClimateSeries> climates;  ///< one for each elevation, which they know
    forest::Parameters parameters;                ///< of grow_year: case.ini says which processes are off
};

/// Reads site,species,elevation_m,fertility,table,class. Each reader throws one InputError (data) for all
/// problems.
std::vector<YieldSite> read_yield_sites(const config::Table& table, const forest::SpeciesTable& species);
/// Reads table,class,age_years,mean_height_m,stems_pha,basal_area_m2pha,mean_dbh_cm,volume_m3pha.
std::vector<YieldTableRow> read_yield_rows(const config::Table& table);

/// A trial at an age beside its table.
struct YieldComparison {
    std::string site;
    int age_years = 0;
    forest::StandFigures simulated;
    std::optional<YieldTableRow> published;
};

/// Height of the tree of mean basal area from Lorey's mean height, as tables have it [choice].
inline constexpr double mean_per_lorey_height = 0.93;

/// Grows every site in one kind of light and sets it beside its table. Throws InputError (data) for a site
/// whose climate or table is missing.
std::vector<YieldComparison> compare_yields(const YieldCase& data, const forest::SpeciesTable& species,
                                            forest::TreeLight light, const std::vector<int>& ages_years);

/// The figures that criteria speak of, such as {"volume_ratio:piab_1000:100", 1.02}: volume_ratio, dbh_ratio,
/// height_ratio and stems_ratio (simulated / published) where there is a table, volume_m3pha, dbh_cm,
/// height_m and stems_pha everywhere.
std::vector<std::pair<std::string, double>> yield_figures(const std::vector<YieldComparison>& comparisons);

}  // namespace coupling::validation::forest_cases::yield_trial
