#include "validation/engine/forest_cases/plain_3pg/stand.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

constexpr double mbar_per_kpa = 10.0;

#define AT(expression) [](const Row& r) -> double { return expression; }

// clang-format off
constexpr Column all_columns[] = {
    {"tmp_min", "degC", AT(r.climate.tmin_degc)},
    {"tmp_max", "degC", AT(r.climate.tmax_degc)},
    {"tmp_ave", "degC", AT(r.climate.tave_degc)},
    {"frost_days", "day", AT(r.climate.frost_days)},
    {"solar_rad", "MJ/m2/day", AT(r.climate.radiation_mjpm2)},
    {"day_length", "s", AT(r.day_length_s)},
    {"prcp", "mm", AT(r.climate.prec_mm)},
    {"vpd_day", "mbar", AT(mbar_per_kpa * r.climate.vpd_kpa)},
    {"co2", "ppm", AT(r.climate.co2_ppm)},
    {"age", "year", AT(r.state.age.years)},
    {"stems_n", "1/ha", AT(r.state.stocks.stems_pha)},
    {"basal_area", "m2/ha", AT(r.state.sizes.basal_area_m2pha)},
    {"basal_area_prop", "-", AT(r.state.sizes.basal_area_share)},
    {"dbh", "cm", AT(r.state.sizes.dbh_cm)},
    {"height", "m", AT(r.state.sizes.height_m)},
    {"crown_length", "m", AT(r.state.sizes.crown_length_m)},
    {"crown_width", "m", AT(r.state.sizes.crown_width_m)},
    {"volume", "m3/ha", AT(r.state.sizes.volume_m3pha)},
    {"volume_change", "m3/ha", AT(r.state.sizes.volume_change_m3pha)},
    {"volume_cum", "m3/ha", AT(r.state.sizes.volume_total_m3pha)},
    {"volume_mai", "m3/ha/year", AT(r.state.sizes.volume_total_m3pha / r.state.age.years)},
    {"sla", "m2/kg", AT(r.state.age.sla_m2pkg)},
    {"lai", "m2/m2", AT(r.state.canopy.lai)},
    {"lai_above", "m2/m2", AT(r.state.canopy.lai_above)},
    {"lai_sa_ratio", "-", AT(r.state.canopy.leaf_to_surface)},
    {"layer_id", "-", AT(r.state.canopy.layer)},
    {"canopy_vol_frac", "-", AT(r.state.canopy.filled_share)},
    {"canopy_cover", "-", AT(r.state.canopy.cover)},
    {"lambda_v", "-", AT(r.state.canopy.vertical)},
    {"lambda_h", "-", AT(r.state.canopy.horizontal)},
    {"aero_resist", "s/m", AT(r.state.water.air_resistance_spm)},
    {"vpd_sp", "mbar", AT(mbar_per_kpa * r.state.water.vpd_kpa)},
    {"biom_stem", "t/ha", AT(r.state.stocks.stem)},
    {"biom_root", "t/ha", AT(r.state.stocks.root)},
    {"biom_foliage", "t/ha", AT(r.state.stocks.foliage)},
    {"biom_foliage_debt", "t/ha", AT(r.state.stocks.foliage_debt)},
    {"biom_tree", "kg", AT(r.state.sizes.tree_kg)},
    {"wood_density", "t/m3", AT(r.state.age.wood_density_tpm3)},
    {"fracBB", "-", AT(r.state.age.branch_share)},
    {"biom_loss_foliage", "t/ha", AT(r.state.production.foliage_loss)},
    {"biom_loss_root", "t/ha", AT(r.state.production.root_loss)},
    {"biom_incr_foliage", "t/ha", AT(r.state.production.foliage_growth)},
    {"biom_incr_root", "t/ha", AT(r.state.production.root_growth)},
    {"biom_incr_stem", "t/ha", AT(r.state.production.stem_growth)},
    {"f_age", "-", AT(r.state.modifiers.age)},
    {"f_vpd", "-", AT(r.state.modifiers.vpd)},
    {"f_tmp", "-", AT(r.state.modifiers.temperature)},
    {"f_tmp_gc", "-", AT(r.state.modifiers.temperature_of_conductance)},
    {"f_frost", "-", AT(r.state.modifiers.frost)},
    {"f_sw", "-", AT(r.state.modifiers.soil_water)},
    {"f_nutr", "-", AT(r.state.modifiers.nutrition)},
    {"f_calpha", "-", AT(r.state.modifiers.co2_assimilation)},
    {"f_cg", "-", AT(r.state.modifiers.co2_conductance)},
    {"f_phys", "-", AT(r.state.modifiers.physiology)},
    {"gammaF", "1/month", AT(r.state.age.litterfall_pmonth)},
    {"f_transp_scale", "-", AT(r.water.supply)},
    {"gpp", "t/ha", AT(r.state.production.gpp)},
    {"npp", "t/ha", AT(r.state.production.npp)},
    {"apar", "MJ/m2", AT(r.state.canopy.absorbed_mjpm2)},
    {"fi", "-", AT(r.state.canopy.absorbed_share)},
    {"alpha_c", "mol/mol", AT(r.state.production.quantum_efficiency)},
    {"npp_fract_stem", "-", AT(r.state.production.stem_share)},
    {"npp_fract_foliage", "-", AT(r.state.production.foliage_share)},
    {"npp_fract_root", "-", AT(r.state.production.root_share)},
    {"pFS", "-", AT(r.state.sizes.foliage_to_stem)},
    {"conduct_canopy", "m/s", AT(r.state.water.conductance_mps)},
    {"conduct_soil", "m/s", AT(r.water.soil_conductance_mps)},
    {"evapotra_soil", "mm", AT(r.water.soil_evaporation_mm)},
    {"prcp_interc", "mm", AT(r.state.water.interception_mm)},
    {"prcp_interc_fract", "-", AT(r.state.water.interception_share)},
    {"prcp_runoff", "mm", AT(r.water.runoff_mm)},
    {"irrig_supl", "mm", AT(r.water.irrigation_mm)},
    {"evapo_transp", "mm", AT(r.water.evapotranspiration_mm)},
    {"transp_veg", "mm", AT(r.state.water.transpiration_mm)},
    {"asw", "mm", AT(r.water.soil_mm)},
    {"biom_tree_max", "kg", AT(r.state.deaths.thinning_limit_kg)},
    {"gammaN", "%/year", AT(r.state.age.random_mortality)},
    {"mort_thinn", "1/ha", AT(r.state.deaths.self_thinned_pha)},
    {"mort_stress", "1/ha", AT(r.state.deaths.random_pha)},
};
// clang-format on

#undef AT

}  // namespace

std::span<const Column> columns() {
    return all_columns;
}

}  // namespace coupling::validation::forest_cases::plain_3pg
