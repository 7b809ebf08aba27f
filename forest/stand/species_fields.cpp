#include "forest/stand/species_fields.hpp"

namespace forest {

namespace {

using config::above;
using Column = config::ColumnOf<Species>;

template <class Of>
Column number(const char* name, const char* unit, config::NumberRange range, Of of) {
    return {name, of, "", {.unit = unit, .range = range}};
}

// Where a column's value goes. A pointer to a member of a member cannot be written in C++.
#define AT(member)                   \
    [](Species & species) -> auto& { \
        return species.member;       \
    }

// clang-format off
std::vector<Column> all_columns() {
    return {
    // allometry
    number("rho_growth", "kg_m-3", {100, 1500, above}, AT(allometry.stem_density_kgpm3)),
    number("rho_basic", "kg_m-3", {100, 1500, above}, AT(allometry.basic_density_kgpm3)),
    number("form_factor", "-", {0, 1, above}, AT(allometry.form_factor)),
    number("foliage_a", "kg_cm-b", {0, 10, above}, AT(allometry.foliage.factor)),
    number("foliage_b", "-", {0, 5, above}, AT(allometry.foliage.exponent)),
    number("branch_a", "kg_cm-b", {0, 10, above}, AT(allometry.branch.factor)),
    number("branch_b", "-", {0, 5, above}, AT(allometry.branch.exponent)),
    number("root_a", "kg_cm-b", {0, 10, above}, AT(allometry.coarse_root.factor)),
    number("root_b", "-", {0, 5, above}, AT(allometry.coarse_root.exponent)),
    // height_growth
    number("hd_low_a", "cm_cm-1", {0, 1000, above}, AT(height_growth.ratio_low.factor)),
    number("hd_low_b", "-", {-2, 1}, AT(height_growth.ratio_low.exponent)),
    number("hd_high_a", "cm_cm-1", {0, 1000, above}, AT(height_growth.ratio_high.factor)),
    number("hd_high_b", "-", {-2, 1}, AT(height_growth.ratio_high.exponent)),
    number("height_gdd_tau", "degC_d", {0, 3000, above}, AT(height_growth.degree_days_tau)),
    number("max_height", "m", {1, 120, above}, AT(height_growth.max_height_m)),
    number("max_dbh", "cm", {5, 500, above}, AT(height_growth.max_dbh_cm)),
    // crown
    number("crown_diam_a0", "-", {-10, 10}, AT(crown.diameter[0])),
    number("crown_diam_a1", "-", {-10, 10}, AT(crown.diameter[1])),
    number("crown_diam_a2", "-", {-10, 10}, AT(crown.diameter[2])),
    number("crown_diam_a3", "-", {-10, 10}, AT(crown.diameter[3])),
    number("crown_base_a0", "-", {-10, 10}, AT(crown.base[0])),
    number("crown_base_a1", "-", {-10, 10}, AT(crown.base[1])),
    number("crown_base_a2", "-", {-10, 10}, AT(crown.base[2])),
    number("crown_lad", "m2_m-3", {0, 10, above}, AT(crown.leaf_area_density_m2pm3)),
    // light
    number("sla_light", "m2_kg-1", {0, 60, above}, AT(light.sla_m2pkg)),
    number("k_path", "-", {0, 2, above}, AT(light.extinction)),
    number("light_class", "1-5", {1, 5}, AT(light.tolerance_class)),
    number("la_forclim", "1-9", {1, 9}, AT(light.response_class)),
    number("light_min_sapling", "fraction", {0, 1}, AT(light.min_sapling)),
    number("light_min_crown", "fraction", {0, 1}, AT(light.min_crown)),
    // three_pg
    number("pg_alphaCx", "mol_mol-1", {0, 0.2, above}, AT(three_pg.quantum_efficiency)),
    number("pg_Tmin", "degC", {-30, 30}, AT(three_pg.temperature.min_degc)),
    number("pg_Topt", "degC", {0, 40}, AT(three_pg.temperature.optimum_degc)),
    number("pg_Tmax", "degC", {10, 60}, AT(three_pg.temperature.max_degc)),
    number("pg_kF", "-", {0, 5}, AT(three_pg.frost_loss)),
    number("pg_CoeffCond", "mbar-1", {0, 1}, AT(three_pg.vpd_sensitivity_pmbar)),
    number("pg_fCalpha700", "-", {0.5, 1.9}, AT(three_pg.assimilation_at_700)),
    number("pg_fCg700", "-", {0.5, 1.5, above}, AT(three_pg.conductance_at_700)),
    number("pg_fN0", "-", {0, 1}, AT(three_pg.nutrition.at_zero)),
    number("pg_fNn", "-", {0, 10}, AT(three_pg.nutrition.power)),
    number("pg_MaxAge", "yr", {0, 5000, above}, AT(three_pg.age.max_years)),
    number("pg_nAge", "-", {0, 20}, AT(three_pg.age.power)),
    number("pg_rAge", "-", {0, 5, above}, AT(three_pg.age.relative_half)),
    number("pg_pRx", "-", {0, 1, above}, AT(three_pg.root_share.max)),
    number("pg_pRn", "-", {0, 1, above}, AT(three_pg.root_share.min)),
    number("pg_pFS2", "-", {0, 10, above}, AT(three_pg.foliage_to_stem.at_2cm)),
    number("pg_pFS20", "-", {0, 10, above}, AT(three_pg.foliage_to_stem.at_20cm)),
    number("pg_aWS", "-", {0, 10, above}, AT(three_pg.stem_mass.factor)),
    number("pg_nWS", "-", {0, 5, above}, AT(three_pg.stem_mass.exponent)),
    number("pg_gammaF1", "month-1", {0, 1}, AT(three_pg.litterfall.mature_pmonth)),
    number("pg_gammaF0", "month-1", {0, 1}, AT(three_pg.litterfall.initial_pmonth)),
    number("pg_tgammaF", "month", {0, 1000}, AT(three_pg.litterfall.median_months)),
    number("pg_gammaR", "month-1", {0, 1}, AT(three_pg.root_turnover_pmonth)),
    number("pg_wSx1000", "kg", {0, 5000, above}, AT(three_pg.max_stem_at_1000_kg)),
    number("pg_thinPower", "-", {0, 5, above}, AT(three_pg.thinning_power)),
    number("pg_mF", "-", {0, 2}, AT(three_pg.lost_foliage)),
    number("pg_mR", "-", {0, 2}, AT(three_pg.lost_root)),
    number("pg_mS", "-", {0, 2}, AT(three_pg.lost_stem)),
    number("pg_SLA0", "m2_kg-1", {0, 100, above}, AT(three_pg.sla_young_m2pkg)),
    number("pg_SLA1", "m2_kg-1", {0, 100, above}, AT(three_pg.sla_mature_m2pkg)),
    number("pg_tSLA", "yr", {0, 500}, AT(three_pg.sla_half_years)),
    number("pg_k", "-", {0, 2, above}, AT(three_pg.extinction)),
    number("pg_MaxIntcptn", "-", {0, 1}, AT(three_pg.interception.max_share)),
    number("pg_LAImaxIntcptn", "m2_m-2", {0, 20}, AT(three_pg.interception.full_lai)),
    number("pg_MaxCond", "m_s-1", {0, 0.2, above}, AT(three_pg.max_conductance_mps)),
    number("pg_LAIgcx", "m2_m-2", {0, 20, above}, AT(three_pg.full_conductance_lai)),
    number("pg_cVPD", "m2_m-2", {0, 50, above}, AT(three_pg.vpd_halving_lai)),
    number("pg_aV", "-", {0, 1}, AT(three_pg.volume_factor)),
    number("pg_nVB", "-", {0, 5}, AT(three_pg.volume_dbh_power)),
    number("pg_nVH", "-", {0, 5}, AT(three_pg.volume_height_power)),
    // vigour
    number("vigour_half", "-", {0, 10, above}, AT(vigour.half)),
    number("vigour_power", "-", {0.1, 20}, AT(vigour.power)),
    // response
    number("k_npp", "-", {0, 5, above}, AT(response.npp_multiplier)),
    number("psi_min", "MPa", {-10, -0.05}, AT(response.min_potential_mpa)),
    number("n_class", "1-3", {1, 3}, AT(response.nitrogen_class)),
    number("vpd_exp_iland", "kPa-1", {-5, 0}, AT(response.vpd_exponent_pkpa)),
    number("temp_min_iland", "degC", {-20, 20}, AT(response.zero_growth_degc)),
    number("temp_max_iland", "degC", {0, 40}, AT(response.full_growth_degc)),
    number("gdd_min", "degC_d", {0, 5000}, AT(response.min_degree_days)),
    number("gdd_max", "degC_d", {0, 10000}, AT(response.max_degree_days)),
    number("winter_tmin", "degC", {-99, 20}, AT(response.min_winter_degc)),
    number("ph_opt_min", "pH", {2, 9}, AT(response.min_optimum_ph)),
    // seeds
    number("maturity_age", "yr", {1, 300}, AT(seeds.maturity_years)),
    number("seed_year_interval", "yr", {1, 50}, AT(seeds.interval_years)),
    number("non_seed_year_fraction", "-", {0, 1}, AT(seeds.other_years_share)),
    number("fecundity", "seedlings_m-2", {0, 10000}, AT(seeds.seedlings_pm2)),
    number("seed_as1", "m", {0, 5000, above}, AT(seeds.kernel_m)),
    number("seed_as2", "m", {0, 20000}, AT(seeds.long_kernel_m)),
    number("seed_ks", "-", {0, 1}, AT(seeds.long_share)),
    // establishment
    number("est_tmin", "degC", {-99, 10}, AT(establishment.min_degc)),
    number("est_chill", "d", {0, 365}, AT(establishment.chilling_days)),
    number("est_gdd_min", "degC_d", {0, 5000}, AT(establishment.min_degree_days)),
    number("est_gdd_max", "degC_d", {0, 10000}, AT(establishment.max_degree_days)),
    number("est_gdd_base", "degC", {-5, 15}, AT(establishment.base_degc)),
    number("est_budburst_gdd", "degC_d", {0, 3000}, AT(establishment.budburst_degree_days)),
    number("est_frostfree_days", "d", {0, 365}, AT(establishment.frost_free_days)),
    number("est_frost_tol", "0-1", {0, 1}, AT(establishment.frost_tolerance)),
    // saplings
    number("sap_hmax", "m", {0, 120, above}, AT(saplings.max_height_m)),
    number("sap_rate", "yr-1", {0, 1, above}, AT(saplings.rate_pyear)),
    number("sap_max_stress", "yr", {0, 50}, AT(saplings.max_stress_years)),
    number("sap_stress_threshold", "-", {0, 1}, AT(saplings.stress_threshold)),
    number("sap_hd", "m_m-1", {10, 500, above}, AT(saplings.height_to_diameter)),
    number("sap_reineke", "stems_ha-1", {0, 10000, above}, AT(saplings.represented_stems_pha)),
    number("browse_p", "-", {0, 1}, AT(saplings.browsing_probability)),
    number("browse_tol", "1-5", {1, 5}, AT(saplings.browsing_class)),
    // mortality
    number("max_age", "yr", {1, 10000, above}, AT(mortality.max_age_years)),
    number("p_lucky", "-", {0, 1, above}, AT(mortality.lucky_share)),
    number("stress_b", "-", {0, 10}, AT(mortality.stress_coefficient)),
    number("thin_a", "-", {0, 30, above}, AT(mortality.thinning_intercept)),
    number("thin_b", "-", {-5, 0}, AT(mortality.thinning_slope)),
    // wind
    number("wind_Creg", "N_m_kg-1", {0, 1000, above}, AT(wind.anchorage_nmpkg)),
    number("wind_MOR", "MPa", {0, 300, above}, AT(wind.rupture_mpa)),
    number("wind_crown_share", "-", {0, 1, above}, AT(wind.crown_share)),
    // wounds
    number("bark_thickness", "cm_cm-1", {0, 0.5}, AT(wounds.bark_share)),
    number("wound_rot_p", "-", {0, 1}, AT(wounds.rot_probability)),
    number("rot_spread", "cm_yr-1", {0, 200}, AT(wounds.rot_spread_cmpyear)),
    // deadwood
    number("snag_ksw", "yr-1", {0, 1, above}, AT(deadwood.snag_decay_pyear)),
    number("snag_half_life", "yr", {0, 500, above}, AT(deadwood.snag_half_life_years)),
    number("log_k10", "yr-1", {0, 1, above}, AT(deadwood.log_decay_pyear)),
    // records
    number("usual_dbh_growth", "cm_yr-1", {0.01, 3}, AT(records.dbh_growth_cm_pyear)),
    number("leaf_on_month", "month", {0, 12}, AT(light.leaf_on_month)),
    number("leaf_off_month", "month", {0, 12}, AT(light.leaf_off_month)),
    {"conifer", AT(conifer), "yes (1) or no (0)"},
    {"evergreen", AT(evergreen), "yes (1) or no (0)"},
    {"beetle_host", AT(beetle.host), "yes (1) or no (0)"},
    {"resprout", AT(wounds.resprouts), "yes (1) or no (0)"},
    {"crown_shape", AT(crown.shape), "P (paraboloid) or E (ellipsoid)", {.words = {"P", "E"}}},
    {"species_code", AT(code), "four capitals"},
    {"latin_name", AT(latin_name), "binomial"},
    {"german_name", AT(german_name), "for pages", {.may_be_empty = true}},
    {"source", AT(source), "where the values come from", {.may_be_empty = true}}};
}
// clang-format on

#undef AT

}  // namespace

const config::Schema<Species>& species_columns() {
    static const config::Schema<Species> columns{{.role = "species",
                                                  .setting = "forest.species",
                                                  .row = "species",
                                                  .no_rows = "a row for each",
                                                  .checks_units = true},
                                                 all_columns()};
    return columns;
}

}  // namespace forest
