#pragma once

#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "config/units/angle.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// A calendar month.
struct YearMonth {
    int year = 0;
    int month = 1;  ///< 1-12

    /// Months from year 0 on.
    [[nodiscard]] int count() const { return 12 * year + month - 1; }
};

/// Where the stand grows and when.
struct Site {
    config::Angle latitude;
    int soil_class = 0;  ///< 1 sand ... 4 clay; 0 no effect of soil water; below 0 the species' own curve
    double start_water_mm = 0.0;  ///< available to roots
    double min_water_mm = 0.0;    ///< held by irrigation
    double max_water_mm = 0.0;
    YearMonth from;
    YearMonth to;
};

/// A species at the start.
struct StartingSpecies {
    std::string species;
    YearMonth planted;
    double fertility = 0.0;  ///< 0-1
    double stems_pha = 0.0;
    double stem_tpha = 0.0;
    double root_tpha = 0.0;
    double foliage_tpha = 0.0;
};

/// Climate of a month.
struct ClimateMonth {
    YearMonth when;
    double tmin_degc = 0.0;
    double tmax_degc = 0.0;
    double tave_degc = 0.0;
    double prec_mm = 0.0;
    double radiation_mjpm2 = 0.0;  ///< per day, flat ground
    double frost_days = 0.0;
    double co2_ppm = 350.0;
    double vpd_kpa = 0.0;  ///< daytime
};

/// Stems are taken out down to a number once an age is reached.
struct Thinning {
    std::string species;
    double age_years = 0.0;
    double stems_pha = 0.0;  ///< left
    double stem = 1.0;       ///< stem mass of a tree taken / that of the mean tree [-]
    double root = 1.0;
    double foliage = 1.0;
};

// Readers of r3PG's tables. Each throws one InputError (data) with all problems of its table.

Site read_site(const config::Table& table);
std::vector<StartingSpecies> read_species(const config::Table& table);
/// The months of the site's period; `vpd_day` (mbar), `tmp_ave` and `co2` may be absent: deficit from
/// temperatures, the middle of minimum and maximum, 350 ppm. Missing months are a problem, those outside are
/// read over.
std::vector<ClimateMonth> read_climate(const config::Table& table, const Site& site);
std::vector<Thinning> read_thinnings(const config::Table& table);

}  // namespace coupling::validation::forest_cases::plain_3pg
