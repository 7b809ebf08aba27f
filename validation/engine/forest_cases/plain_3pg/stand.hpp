#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "forest/production/allocation.hpp"
#include "validation/engine/forest_cases/plain_3pg/inputs.hpp"
#include "validation/engine/forest_cases/plain_3pg/parameters.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// How light is shared.
enum class LightModel {
    one_canopy,  ///< each species as if it were alone [3-PGpjs; r3PG's light 1]
    layers,      ///< crowns in layers, shared within them [3-PGmix, Forrester et al. 2014; r3PG's light 2]
};

/// How water leaves the stand.
enum class TranspirationModel {
    one_canopy,  ///< no soil evaporation [3-PGpjs; r3PG's transpiration 1]
    by_species,  ///< radiation and air of each species, soil evaporation [3-PGmix; r3PG's transpiration 2]
};

/// How height follows diameter.
enum class HeightModel {
    power,        ///< a * D^b * C^c [r3PG's height 1]
    exponential,  ///< 1.3 + a * exp(-b / D) + c * C * D [Michajlow; r3PG's height 2]
};

/// The models of a run; as they stand here, those of 3-PGpjs.
struct Settings {
    LightModel light = LightModel::one_canopy;
    TranspirationModel transpiration = TranspirationModel::one_canopy;
    forest::Physiology physiology = forest::Physiology::scarcer;
    HeightModel height = HeightModel::power;
};

/// The models of 3-PGmix.
inline constexpr Settings mixture_settings{LightModel::layers, TranspirationModel::by_species,
                                           forest::Physiology::product, HeightModel::power};

/// What depends on age alone.
struct AgeState {
    double years = 0.0;           ///< at the end of the month
    double previous_years = 0.0;  ///< at its beginning
    double sla_m2pkg = 0.0;
    double branch_share = 0.0;
    double wood_density_tpm3 = 0.0;
    double random_mortality = 0.0;  ///< % a year
    double litterfall_pmonth = 0.0;
};

/// Dry mass [t/ha].
struct Stocks {
    double stems_pha = 0.0;
    double stem = 0.0;
    double root = 0.0;
    double foliage = 0.0;
    double foliage_debt = 0.0;  ///< foliage shed for the winter, to be grown again
};

/// Mean tree and what follows from it.
struct Sizes {
    double tree_kg = 0.0;  ///< woody tissue above ground
    double dbh_cm = 0.0;
    double basal_area_m2pha = 0.0;
    double basal_area_share = 0.0;  ///< [-]
    double height_m = 0.0;
    double crown_length_m = 0.0;
    double crown_width_m = 0.0;
    double foliage_to_stem = 0.0;  ///< share of production [-]
    double volume_m3pha = 0.0;
    double volume_change_m3pha = 0.0;
    double volume_total_m3pha = 0.0;  ///< grown since the start
};

/// Leaves and the light they absorb.
struct Canopy {
    double lai = 0.0;
    double lai_above = 0.0;
    double cover = 0.0;            ///< share of ground under crowns of a young stand [-]
    int layer = 0;                 ///< 1 is the highest
    double leaf_to_surface = 0.0;  ///< leaf area / crown surface [-]
    double filled_share = 0.0;     ///< of the layer's volume [-]
    double vertical = 0.0;         ///< lambda_v of Forrester et al. 2014 [-]
    double horizontal = 0.0;       ///< lambda_h
    double absorbed_mjpm2 = 0.0;   ///< in the month
    double absorbed_share = 0.0;   ///< of the light above the stand, where it is layered [-]
};

/// Modifiers of the month [-].
struct Modifiers {
    double temperature = 0.0;
    double temperature_of_conductance = 0.0;
    double frost = 0.0;
    double co2_assimilation = 0.0;
    double co2_conductance = 0.0;
    double age = 0.0;
    double vpd = 0.0;
    double soil_water = 0.0;
    double nutrition = 0.0;
    double physiology = 0.0;
};

/// Production of the month [t/ha].
struct Production {
    double quantum_efficiency = 0.0;  ///< mol/mol
    double gpp = 0.0;
    double npp = 0.0;
    double root_share = 0.0;
    double stem_share = 0.0;
    double foliage_share = 0.0;
    double root_growth = 0.0;
    double stem_growth = 0.0;
    double foliage_growth = 0.0;
    double root_loss = 0.0;
    double foliage_loss = 0.0;
};

/// Water of a species in the month.
struct Water {
    double vpd_kpa = 0.0;  ///< at the height of the crowns
    double air_resistance_spm = 0.0;
    double conductance_mps = 0.0;
    double transpiration_mm = 0.0;
    double interception_share = 0.0;  ///< [-]
    double interception_mm = 0.0;
};

/// Trees that died in the month [stems/ha], and the limit to the mean tree.
struct Deaths {
    double thinning_limit_kg = 0.0;
    double self_thinned_pha = 0.0;
    double random_pha = 0.0;
    double cut_pha = 0.0;
};

/// A species at the end of a month.
struct SpeciesMonth {
    AgeState age;
    Stocks stocks;
    Sizes sizes;
    Canopy canopy;
    Modifiers modifiers;
    Production production;
    Water water;
    Deaths deaths;
};

/// Water of the stand in the month [mm].
struct StandWater {
    double soil_mm = 0.0;  ///< available to roots, at the end
    double soil_conductance_mps = 0.0;
    double soil_evaporation_mm = 0.0;
    double evapotranspiration_mm = 0.0;
    double runoff_mm = 0.0;
    double irrigation_mm = 0.0;
    double supply = 0.0;  ///< actual / demanded evapotranspiration [-]
};

/// What stays the same over a run.
struct Inputs {
    Site site;
    std::vector<StartingSpecies> species;
    std::vector<Parameters> parameters;  ///< of species[i] at i
    std::vector<ClimateMonth> climate;   ///< every month of the site's period
    std::vector<Thinning> thinnings;
};

/// The stand while it grows.
struct Stand {
    std::vector<SpeciesMonth> species;
    StandWater water;
    double day_length_s = 0.0;
    bool sizes_outdated = false;  ///< something happened to trees or leaves since sizes were computed
};

/// One line of the result: a species at the end of a month.
struct Row {
    YearMonth when;
    std::size_t species = 0;  ///< index into the inputs
    ClimateMonth climate;
    double day_length_s = 0.0;
    SpeciesMonth state;
    StandWater water;
};

/// A column of the result under r3PG's name and in its unit.
struct Column {
    std::string_view name;
    std::string_view unit;
    double (*of)(const Row&);
};

std::span<const Column> columns();

}  // namespace coupling::validation::forest_cases::plain_3pg
