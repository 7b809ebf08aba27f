#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/table/table.hpp"
#include "forest/production/light_use.hpp"
#include "forest/production/three_pg_modifiers.hpp"
#include "forest/production/transpiration.hpp"
#include "forest/stand/species.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// A property that changes with age from young to mature, half-way at `half_years`.
struct ByAge {
    double young = 0.0;
    double mature = 0.0;
    double half_years = 0.0;  ///< 0: mature at any age
};

/// Size of a mean tree by the others of its size: factor * D^dbh * H^height * C^competition * (H / mean
/// H)^relative, times L^lai for crown length; C is the sum of basal area times wood density.
struct SizeLaw {
    double factor = 0.0;
    double dbh = 0.0;
    double height = 0.0;
    double lai = 0.0;
    double competition = 0.0;
    double relative_height = 0.0;
};

/// Random death of trees by age [% a year].
struct RandomMortality {
    double initial = 0.0;
    double mature = 0.0;
    double median_years = 0.0;
    double shape = 1.0;
};

/// What a dying tree has of foliage, roots and stem, relative to the mean tree [-].
struct LostShares {
    double foliage = 0.0;
    double root = 0.0;
    double stem = 0.0;
};

/// Largest mean stem: `at_1000_kg` * (1000 / N)^power.
struct SelfThinning {
    double at_1000_kg = 0.0;
    double power = 0.0;
};

/// Crowns for the light model of 3-PGmix.
enum class CrownForm : int { cone = 1, ellipsoid = 2, half_ellipsoid = 3, box = 4 };

/// Volume of a stem by its size [m3]: factor * D^dbh * H^height * (D^2 H)^joint; by mass and density where
/// the factor is 0.
struct VolumeLaw {
    double factor = 0.0;
    double dbh = 0.0;
    double height = 0.0;
    double joint = 0.0;
};

/// The 3-PG parameters of one species, under r3PG's names in its tables (parameters.cpp).
struct Parameters {
    std::string species;
    forest::FoliageToStem foliage_to_stem;
    forest::Power stem_mass;  ///< kg
    forest::RootShare root_share;
    forest::Litterfall litterfall;
    double root_turnover_pmonth = 0.0;
    double leaf_grow_month = 0.0;  ///< 0 for evergreen species
    double leaf_fall_month = 0.0;
    forest::TemperatureCurve temperature;
    double frost_loss = 0.0;
    forest::SoilWaterCurve soil_water;  ///< used where the site's soil class is below 0
    double assimilation_at_700 = 0.0;
    double conductance_at_700 = 0.0;
    double root_response_at_zero = 0.0;  ///< m at fertility 0
    forest::NutritionCurve nutrition;
    forest::AgeCurve age;
    RandomMortality random_mortality;
    SelfThinning self_thinning;
    LostShares lost;
    ByAge sla_m2pkg;
    double extinction = 0.0;
    double full_canopy_years = 0.0;
    forest::Interception interception;
    double vpd_halving_lai = 0.0;
    double quantum_efficiency = 0.0;
    forest::LightUse light_use;
    double min_conductance_mps = 0.0;
    double max_conductance_mps = 0.0;
    double full_conductance_lai = 0.0;
    double vpd_sensitivity_pmbar = 0.0;
    double boundary_layer_mps = 0.0;
    ByAge branch_share;  ///< branches and bark of the stem mass
    ByAge wood_density_tpm3;
    CrownForm crown_form = CrownForm::half_ellipsoid;
    SizeLaw height_m;
    VolumeLaw volume_m3;
    SizeLaw crown_width_m;
    SizeLaw crown_length_m;
    forest::NetRadiation net_radiation;
};

/// Whether leaves are off in a month; month 0 counts as the month before January in r3PG.
bool dormant(const Parameters& species, int month);

/// One row of a parameter table: r3PG's name, the default where a table leaves it out, what it may be.
struct ParameterField {
    std::string_view name;
    std::string_view unit;
    double default_value;
    config::NumberRange range;
    double& (*of)(Parameters&);
};

std::span<const ParameterField> parameter_fields();

/// Reads a table of r3PG's form: a column `parameter`, then one column for each species; rows in any order,
/// missing ones take their default (`defaults_in`). Throws one InputError (data) for unknown and doubled
/// parameters, a table without any row, and values that are no numbers or out of range. Rows for carbon
/// isotopes are read over: they change no other result.
std::vector<Parameters> read_parameters(const config::Table& table);

/// The parameters that a table has no row for, each with its default, such as "k = 0.5".
std::vector<std::string> defaults_in(const config::Table& table);

}  // namespace coupling::validation::forest_cases::plain_3pg
