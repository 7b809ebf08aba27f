#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/table/table.hpp"
#include "validation/engine/forest_cases/yield_trial/trial.hpp"

namespace coupling::validation::forest_cases::yield_trial {

/// A stand of a yield table.
struct YieldTableRow {
    std::string table;
    std::string site_class;  ///< as the table names it, such as "1", "2.5", "III" or "M34"
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
    forest::Soil soil = trial_soil;
    std::string table;  ///< it is held against, "" for none
    std::string site_class;
    config::Angle latitude = config::Angle::from_degrees(47.7);
};

/// Sites, tables and climate of a comparison.
struct YieldCase {
    std::vector<YieldSite> sites;
    std::vector<YieldTableRow> rows;
    std::vector<forest::ClimateSeries> climates;  ///< one for each elevation, which they know
    forest::Parameters parameters;                ///< of grow_year: case.ini says which processes are off
};

/// How a stand is treated.
enum class Treatment : std::uint8_t {
    as_the_table,  ///< thinned from below to the stems of its table at each of its ages
    left_alone,
};

/// The columns that the readers below know.
std::vector<std::string> site_columns();
std::vector<std::string> row_columns();

/// Reads site,species,elevation_m,fertility,table,class and, where they are there, nitrogen_kg_ha_yr and
/// latitude_deg. Each reader throws one InputError (data) for all problems.
std::vector<YieldSite> read_yield_sites(const config::Table& table, const forest::SpeciesTable& species);
/// Reads table,class,age_years,mean_height_m,stems_pha,mean_dbh_cm,volume_m3pha and, where it is there,
/// basal_area_m2pha. Other columns are read over; an age stands once in a class.
std::vector<YieldTableRow> read_yield_rows(const config::Table& table);

/// Rows of the table and class of a site, by rising age.
std::vector<YieldTableRow> rows_of(const YieldCase& data, const YieldSite& site);

/// Whether two classes are the same: "2" and "2.0" are, "II" is another.
bool is_same_class(const std::string& a, const std::string& b);

/// All ages at which some site can be compared with its table, rising.
std::vector<int> ages_of_tables(const YieldCase& data);

/// Ages that a site is compared at: all for one without a table; else those of its table that come after the
/// first, at which its stand starts.
std::vector<int> ages_of(const YieldCase& data, const YieldSite& site, const std::vector<int>& ages_years);

/// A trial at an age beside its table.
struct YieldComparison {
    std::string site;
    int age_years = 0;
    TrialState simulated;
    std::optional<YieldTableRow> published;
};

/// A site grown in one way.
struct SiteYields {
    std::vector<YieldComparison> ages;
    double greatest_density = 0.0;
    std::optional<double> density_at_25cm;
};

/// Grows a site and sets it beside its table. It starts as the youngest stand of its table, or as a
/// plantation of 3000 stems/ha of 2 cm at age 12 where it has none. Throws InputError (data) for a site whose
/// climate or table is missing.
SiteYields compare_yields(const YieldCase& data, const YieldSite& site, const forest::SpeciesTable& species,
                          Treatment treatment, forest::TreeLight light, const std::vector<int>& ages_years);

/// Height of the 100 thickest stems of a hectare / height of the mean tree of a thinned stand [choice]:
/// standard height curves of Germany (Sloboda et al. 1993) give 1.05 to 1.11 for stems 1.25 to 1.4 times as
/// thick as the mean tree.
inline constexpr double top_per_mean_height = 1.08;

/// Figures of a stand as criteria name them, such as {"volume_ratio:piab_1000:100", 1.02}: volume_ratio,
/// dbh_ratio, height_ratio and stems_ratio (simulated / published) where there is a table, volume_m3pha,
/// dbh_cm, height_m and stems_pha everywhere.
std::vector<std::pair<std::string, double>> yield_figures(const SiteYields& yields);

/// Figures of a stand left alone: twin_volume_m3pha, twin_stems_pha, top_height_ratio (height of the 100
/// thickest stems / that of the table), slenderness (of these stems) at each age; greatest_density and
/// density_at_25cm of the site (stems / self-thinning line).
std::vector<std::pair<std::string, double>> twin_figures(const SiteYields& yields);

/// Rows whose volume, mean diameter and mean height agree with the table.
struct Agreement {
    std::size_t figures = 0;  ///< compared: three for each age
    std::size_t agree = 0;    ///< within 15 %
    [[nodiscard]] double share() const {
        return figures > 0 ? static_cast<double>(agree) / static_cast<double>(figures) : 1.0;
    }
    Agreement& operator+=(const Agreement& other);
};

/// Agreement of the ages from `from_years` to `to_years`.
Agreement agreement_of(const SiteYields& yields, int from_years, int to_years);

}  // namespace coupling::validation::forest_cases::yield_trial
