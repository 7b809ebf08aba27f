#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"

namespace forest {

// What sets one species apart, one struct for each process. Values stand in config/data/species.csv, the
// source of each column in config/data/species_dictionary.csv. Units and allowed ranges stand once, in
// species_fields.cpp.

/// Position of a species in the table in use.
enum class SpeciesId : std::uint16_t {};

/// The position as an index into arrays by species.
constexpr std::size_t index_of(SpeciesId species) {
    return static_cast<std::size_t>(species);
}

/// factor * D^exponent, with the DBH D in cm.
struct Power {
    double factor = 0.0;
    double exponent = 0.0;
};

/// Dry mass of the parts of a tree by its DBH [iLand species database].
struct Allometry {
    double stem_density_kgpm3 = 0.0;   ///< stem mass per stem volume, used with the form factor
    double basic_density_kgpm3 = 0.0;  ///< oven-dry mass per fresh volume
    double form_factor = 0.0;          ///< stem volume / (cross-section at 1.3 m * height) [-]
    Power foliage;                     ///< kg of a tree in full leaf
    Power branch;                      ///< kg
    Power coarse_root;                 ///< kg
};

/// How height follows diameter [iLand species database], with caps.
struct HeightGrowth {
    Power ratio_low;   ///< height increment / diameter increment in full light [-]
    Power ratio_high;  ///< the same in deep shade [-]
    double degree_days_tau =
        0.0;  ///< degree-days by which the site's height factor has risen to 1 - 1/e [choice]
    double max_height_m = 0.0;
    double max_dbh_cm = 0.0;
};

enum class CrownShape : std::uint8_t { paraboloid, ellipsoid };

/// Size and shape of crowns [SILVA, Pretzsch; shapes Samsara2].
struct Crown {
    /// Crown diameter [m] = exp(a0 + a1 ln D + a2 H + a3 ln(H / D)), D in cm, H in m.
    std::array<double, 4> diameter{};
    /// Crown base [m] = H (1 - exp(a0 + a1 H / D + a2 D)).
    std::array<double, 3> base{};
    CrownShape shape = CrownShape::paraboloid;
    double leaf_area_density_m2pm3 = 0.0;  ///< of explicit crowns, extinction 0.5
};

/// Leaves, and what they need of light.
struct Light {
    double sla_m2pkg = 0.0;        ///< projected leaf area per kg of foliage
    double extinction = 0.0;       ///< along the ray in cells of 10 x 10 x 5 m, clumping included [-]
    double tolerance_class = 0.0;  ///< 1 intolerant ... 5 tolerant [iLand]
    double response_class = 0.0;   ///< 1 tolerant ... 9 intolerant [ForClim]
    double min_sapling = 0.0;      ///< share of open light below which nothing establishes [-]
    double min_crown = 0.0;        ///< share of open light at its base below which a crown recedes [-]
    int leaf_on_month = 0;         ///< first month with leaves; 0 for evergreen species
    int leaf_off_month = 0;        ///< first month without leaves; 0 for evergreen species

    /// Whether the species has leaves in a month (1-12).
    [[nodiscard]] bool in_leaf(int month) const {
        return leaf_on_month == leaf_off_month || (month >= leaf_on_month && month < leaf_off_month);
    }
};

/// Growth by temperature between two limits, highest at the optimum.
struct TemperatureCurve {
    double min_degc = 0.0;
    double optimum_degc = 0.0;
    double max_degc = 0.0;
};

/// Growth by site fertility (0-1).
struct NutritionCurve {
    double at_zero = 0.0;  ///< growth at fertility 0, as a share [-]
    double power = 0.0;    ///< of (1 - fertility) [-]
};

/// Loss of vigour of tall and old trees: 1 / (1 + (x / half)^power) (form of iLand).
struct Vigour {
    double half = 0.0;   ///< share of height and life spent at which production has halved [-]
    double power = 0.0;  ///< how suddenly [-]
};

/// Decline with age, of a plain 3-PG stand; trees lose vigour instead.
struct AgeCurve {
    double max_years = 0.0;
    double power = 0.0;          ///< of relative age [-]
    double relative_half = 0.0;  ///< relative age at which growth has halved [-]
};

/// Lowest and highest share of production used for roots [-].
struct RootShare {
    double min = 0.0;
    double max = 0.0;
};

/// Production for foliage per production for stem, by DBH [-].
struct FoliageToStem {
    double at_2cm = 0.0;
    double at_20cm = 0.0;
};

/// Loss of foliage by age of the stand.
struct Litterfall {
    double mature_pmonth = 0.0;   ///< share a month, old stands
    double initial_pmonth = 0.0;  ///< share a month at age 0
    double median_months = 0.0;   ///< age at which the rate has its median
};

/// Rain that stays in the canopy.
struct Interception {
    double max_share = 0.0;  ///< [-]
    double full_lai = 0.0;   ///< leaf area index from which on the share is highest [m2/m2]
};

/// The 3-PG parameters of a species [Forrester et al. 2021, Swiss forest inventory].
struct ThreePg {
    double quantum_efficiency = 0.0;  ///< mol C / mol photons
    TemperatureCurve temperature;
    double frost_loss = 0.0;             ///< days of production lost with a day of frost [-]
    double vpd_sensitivity_pmbar = 0.0;  ///< of stomata to vapour pressure deficit [1/mbar]
    double assimilation_at_700 = 0.0;    ///< quantum efficiency at 700 ppm CO2 / that at 350 ppm [-]
    double conductance_at_700 = 0.0;     ///< canopy conductance at 700 ppm CO2 / that at 350 ppm [-]
    NutritionCurve nutrition;
    AgeCurve age;
    RootShare root_share;
    FoliageToStem foliage_to_stem;
    Power stem_mass;  ///< kg of woody tissue above ground
    Litterfall litterfall;
    double root_turnover_pmonth = 0.0;
    double max_stem_at_1000_kg = 0.0;  ///< largest mean stem in a stand of 1000 stems/ha
    double thinning_power = 0.0;       ///< of that limit in stem number [-]
    double lost_foliage = 0.0;         ///< foliage of a dying tree / that of the mean tree [-]
    double lost_root = 0.0;            ///< the same of roots [-]
    double lost_stem = 0.0;            ///< the same of stems [-]
    double sla_young_m2pkg = 0.0;
    double sla_mature_m2pkg = 0.0;
    double sla_half_years = 0.0;  ///< age half-way between the two
    double extinction = 0.0;      ///< of a stand, vertically [-]
    Interception interception;
    double max_conductance_mps = 0.0;   ///< of the canopy
    double full_conductance_lai = 0.0;  ///< leaf area index from which on it is highest [m2/m2]
    double vpd_halving_lai = 0.0;       ///< leaf area above that halves the vapour pressure deficit [m2/m2]
    double volume_factor = 0.0;         ///< V = factor * D^p * H^q, m3 of a stem
    double volume_dbh_power = 0.0;
    double volume_height_power = 0.0;
};

/// How the site limits a species.
struct Response {
    double npp_multiplier = 0.0;     ///< stand production -> production of the trees [choice, calibrated]
    double min_potential_mpa = 0.0;  ///< soil water potential at which growth stops [iLand]
    double nitrogen_class = 0.0;     ///< 1 frugal ... 3 demanding [iLand]
    double vpd_exponent_pkpa = 0.0;  ///< alternative response to vapour pressure deficit [iLand]
    double zero_growth_degc = 0.0;   ///< alternative linear temperature response [iLand]
    double full_growth_degc = 0.0;
    double min_degree_days = 0.0;  ///< above 5.5 degC, per year [LandClim, ForClim]
    double max_degree_days = 0.0;
    double min_winter_degc = 0.0;  ///< coldest monthly mean survived; -99 for none
    double min_optimum_ph = 0.0;   ///< lower end of the best top-soil pH [choice]
};

/// Seeds and their dispersal [iLand].
struct Seeds {
    double maturity_years = 0.0;     ///< age of the first seeds
    double interval_years = 0.0;     ///< mean interval of seed years
    double other_years_share = 0.0;  ///< crop of other years / that of a seed year [-]
    double seedlings_pm2 = 0.0;      ///< per m2 of canopy in a seed year
    double kernel_m = 0.0;           ///< length of the wind kernel
    double long_kernel_m = 0.0;      ///< length of the animals' kernel
    double long_share = 0.0;         ///< share of seeds in the latter [-]
};

/// What a seedling needs [iLand; ForClim].
struct Establishment {
    double min_degc = 0.0;       ///< lowest temperature survived
    double chilling_days = 0.0;  ///< days of -5 to 5 degC needed
    double min_degree_days = 0.0;
    double max_degree_days = 0.0;
    double base_degc = 0.0;  ///< of these degree-days
    double budburst_degree_days = 0.0;
    double frost_free_days = 0.0;
    double frost_tolerance = 0.0;  ///< of late frost [-]
};

/// From seedling to tree, and deer [iLand; LandClim].
struct Saplings {
    double max_height_m = 0.0;  ///< asymptote of the height potential
    double rate_pyear = 0.0;
    double max_stress_years = 0.0;
    double stress_threshold = 0.0;  ///< growth, as a share, below which a year counts as stress [-]
    double height_to_diameter = 0.0;
    double represented_stems_pha = 0.0;  ///< density constant of a cohort
    double browsing_probability = 0.0;   ///< a year at pressure 1 [-]
    double browsing_class = 0.0;         ///< 1 tolerant ... 5 suffers most
};

/// Why standing trees die [iLand; French inventory].
struct Mortality {
    double max_age_years = 0.0;
    double lucky_share = 0.0;         ///< share of trees that reach it [-]
    double stress_coefficient = 0.0;  ///< of p = 1 - exp(-b stress)
    double thinning_intercept = 0.0;  ///< ln(largest stems/ha) = intercept + slope ln(mean DBH [cm])
    double thinning_slope = 0.0;
};

/// Stability in storm [iLand].
struct Wind {
    double anchorage_nmpkg = 0.0;  ///< turning resistance per kg of green stem
    double rupture_mpa = 0.0;      ///< modulus of rupture of green wood
    double crown_share = 0.0;      ///< crown length / height [-]
};

/// Bark beetle.
struct Beetle {
    bool host = false;  ///< of Ips typographus
};

/// Wounds by rocks and felling.
struct Wounds {
    double bark_share = 0.0;          ///< bark thickness / DBH [-]
    double rot_probability = 0.0;     ///< that a deep wound leads to rot [-]
    double rot_spread_cmpyear = 0.0;  ///< along the stem
    bool resprouts = false;           ///< from the stump after breakage
};

/// Standing and lying dead wood.
struct Deadwood {
    double snag_decay_pyear = 0.0;  ///< at the reference climate [iLand]
    double snag_half_life_years = 0.0;
    double log_decay_pyear = 0.0;  ///< at 10 degC [Herrmann et al. 2015]
};

/// What a stand put in from records does not say.
struct Records {
    double dbh_growth_cm_pyear = 0.0;  ///< usual diameter growth, for missing ages
};

/// All of one species.
struct Species {
    std::string code;         ///< such as "abal"
    std::string latin_name;   ///< such as "Abies alba"
    std::string german_name;  ///< such as "Weisstanne"
    bool conifer = false;
    bool evergreen = false;
    Allometry allometry;
    HeightGrowth height_growth;
    Crown crown;
    Light light;
    ThreePg three_pg;
    Vigour vigour;
    Response response;
    Seeds seeds;
    Establishment establishment;
    Saplings saplings;
    Mortality mortality;
    Wind wind;
    Beetle beetle;
    Wounds wounds;
    Deadwood deadwood;
    Records records;
    std::string source;
};

/// The species of a run.
class SpeciesTable {
public:
    /// Reads a table with the columns of config/data/species.csv, in any order; others are read over.
    /// Throws one InputError (data) with file, line and column for all missing columns, values that are no
    /// numbers or out of range, units other than ours, values that contradict each other and doubled species.
    static SpeciesTable read(const config::Table& table);
    /// The eleven species shipped with the program.
    static SpeciesTable shipped();

    /// Puts another species in the place of one. Requires an identity of this table.
    void replace(SpeciesId id, Species species) { species_[index_of(id)] = std::move(species); }

    [[nodiscard]] std::size_t size() const { return species_.size(); }
    /// Requires an identity of this table.
    [[nodiscard]] const Species& operator[](SpeciesId id) const { return species_[index_of(id)]; }
    [[nodiscard]] const std::vector<Species>& all() const { return species_; }

    /// By code or latin name, case ignored.
    [[nodiscard]] std::optional<SpeciesId> find(std::string_view name) const;
    /// The same; otherwise adds a problem with the nearest name.
    std::optional<SpeciesId> find(std::string_view name, const config::Place& place,
                                  config::Problems& problems) const;

private:
    std::vector<Species> species_;
};

}  // namespace forest
