#include "forest/stand/species_fields.hpp"

namespace forest {

namespace {

constexpr bool above = true;  // the lower bound itself is excluded

// Where a column's value goes. A pointer to a member of a member cannot be written in C++.
#define AT(member)                   \
    [](Species & species) -> auto& { \
        return species.member;       \
    }

// clang-format off
constexpr NumberField numbers[] = {
    // allometry
    {"rho_growth", "kg_m-3", {100, 1500, above}, AT(allometry.stem_density_kgpm3)},
    {"rho_basic", "kg_m-3", {100, 1500, above}, AT(allometry.basic_density_kgpm3)},
    {"form_factor", "-", {0, 1, above}, AT(allometry.form_factor)},
    {"foliage_a", "kg_cm-b", {0, 10, above}, AT(allometry.foliage.factor)},
    {"foliage_b", "-", {0, 5, above}, AT(allometry.foliage.exponent)},
    {"branch_a", "kg_cm-b", {0, 10, above}, AT(allometry.branch.factor)},
    {"branch_b", "-", {0, 5, above}, AT(allometry.branch.exponent)},
    {"root_a", "kg_cm-b", {0, 10, above}, AT(allometry.coarse_root.factor)},
    {"root_b", "-", {0, 5, above}, AT(allometry.coarse_root.exponent)},
    // height_growth
    {"hd_low_a", "cm_cm-1", {0, 1000, above}, AT(height_growth.ratio_low.factor)},
    {"hd_low_b", "-", {-2, 1}, AT(height_growth.ratio_low.exponent)},
    {"hd_high_a", "cm_cm-1", {0, 1000, above}, AT(height_growth.ratio_high.factor)},
    {"hd_high_b", "-", {-2, 1}, AT(height_growth.ratio_high.exponent)},
    {"height_gdd_tau", "degC_d", {0, 3000, above}, AT(height_growth.degree_days_tau)},
    {"max_height", "m", {1, 120, above}, AT(height_growth.max_height_m)},
    {"max_dbh", "cm", {5, 500, above}, AT(height_growth.max_dbh_cm)},
    // crown
    {"crown_diam_a0", "-", {-10, 10}, AT(crown.diameter[0])},
    {"crown_diam_a1", "-", {-10, 10}, AT(crown.diameter[1])},
    {"crown_diam_a2", "-", {-10, 10}, AT(crown.diameter[2])},
    {"crown_diam_a3", "-", {-10, 10}, AT(crown.diameter[3])},
    {"crown_base_a0", "-", {-10, 10}, AT(crown.base[0])},
    {"crown_base_a1", "-", {-10, 10}, AT(crown.base[1])},
    {"crown_base_a2", "-", {-10, 10}, AT(crown.base[2])},
    {"crown_lad", "m2_m-3", {0, 10, above}, AT(crown.leaf_area_density_m2pm3)},
    // light
    {"sla_light", "m2_kg-1", {0, 60, above}, AT(light.sla_m2pkg)},
    {"k_path", "-", {0, 2, above}, AT(light.extinction)},
    {"light_class", "1-5", {1, 5}, AT(light.tolerance_class)},
    {"la_forclim", "1-9", {1, 9}, AT(light.response_class)},
    {"light_min_sapling", "fraction", {0, 1}, AT(light.min_sapling)},
    {"light_min_crown", "fraction", {0, 1}, AT(light.min_crown)},
    // three_pg
    {"pg_alphaCx", "mol_mol-1", {0, 0.2, above}, AT(three_pg.quantum_efficiency)},
    {"pg_Tmin", "degC", {-30, 30}, AT(three_pg.temperature.min_degc)},
    {"pg_Topt", "degC", {0, 40}, AT(three_pg.temperature.optimum_degc)},
    {"pg_Tmax", "degC", {10, 60}, AT(three_pg.temperature.max_degc)},
    {"pg_kF", "-", {0, 5}, AT(three_pg.frost_loss)},
    {"pg_CoeffCond", "mbar-1", {0, 1}, AT(three_pg.vpd_sensitivity_pmbar)},
    {"pg_fCalpha700", "-", {0.5, 1.9}, AT(three_pg.assimilation_at_700)},
    {"pg_fCg700", "-", {0.5, 1.5, above}, AT(three_pg.conductance_at_700)},
    {"pg_fN0", "-", {0, 1}, AT(three_pg.nutrition.at_zero)},
    {"pg_fNn", "-", {0, 10}, AT(three_pg.nutrition.power)},
    {"pg_MaxAge", "yr", {0, 5000, above}, AT(three_pg.age.max_years)},
    {"pg_nAge", "-", {0, 20}, AT(three_pg.age.power)},
    {"pg_rAge", "-", {0, 5, above}, AT(three_pg.age.relative_half)},
    {"pg_pRx", "-", {0, 1, above}, AT(three_pg.root_share.max)},
    {"pg_pRn", "-", {0, 1, above}, AT(three_pg.root_share.min)},
    {"pg_pFS2", "-", {0, 10, above}, AT(three_pg.foliage_to_stem.at_2cm)},
    {"pg_pFS20", "-", {0, 10, above}, AT(three_pg.foliage_to_stem.at_20cm)},
    {"pg_aWS", "-", {0, 10, above}, AT(three_pg.stem_mass.factor)},
    {"pg_nWS", "-", {0, 5, above}, AT(three_pg.stem_mass.exponent)},
    {"pg_gammaF1", "month-1", {0, 1}, AT(three_pg.litterfall.mature_pmonth)},
    {"pg_gammaF0", "month-1", {0, 1}, AT(three_pg.litterfall.initial_pmonth)},
    {"pg_tgammaF", "month", {0, 1000}, AT(three_pg.litterfall.median_months)},
    {"pg_gammaR", "month-1", {0, 1}, AT(three_pg.root_turnover_pmonth)},
    {"pg_wSx1000", "kg", {0, 5000, above}, AT(three_pg.max_stem_at_1000_kg)},
    {"pg_thinPower", "-", {0, 5, above}, AT(three_pg.thinning_power)},
    {"pg_mF", "-", {0, 2}, AT(three_pg.lost_foliage)},
    {"pg_mR", "-", {0, 2}, AT(three_pg.lost_root)},
    {"pg_mS", "-", {0, 2}, AT(three_pg.lost_stem)},
    {"pg_SLA0", "m2_kg-1", {0, 100, above}, AT(three_pg.sla_young_m2pkg)},
    {"pg_SLA1", "m2_kg-1", {0, 100, above}, AT(three_pg.sla_mature_m2pkg)},
    {"pg_tSLA", "yr", {0, 500}, AT(three_pg.sla_half_years)},
    {"pg_k", "-", {0, 2, above}, AT(three_pg.extinction)},
    {"pg_MaxIntcptn", "-", {0, 1}, AT(three_pg.interception.max_share)},
    {"pg_LAImaxIntcptn", "m2_m-2", {0, 20}, AT(three_pg.interception.full_lai)},
    {"pg_MaxCond", "m_s-1", {0, 0.2, above}, AT(three_pg.max_conductance_mps)},
    {"pg_LAIgcx", "m2_m-2", {0, 20, above}, AT(three_pg.full_conductance_lai)},
    {"pg_cVPD", "m2_m-2", {0, 50, above}, AT(three_pg.vpd_halving_lai)},
    {"pg_aV", "-", {0, 1}, AT(three_pg.volume_factor)},
    {"pg_nVB", "-", {0, 5}, AT(three_pg.volume_dbh_power)},
    {"pg_nVH", "-", {0, 5}, AT(three_pg.volume_height_power)},
    // vigour
    {"vigour_half", "-", {0, 10, above}, AT(vigour.half)},
    {"vigour_power", "-", {0.1, 20}, AT(vigour.power)},
    // response
    {"k_npp", "-", {0, 5, above}, AT(response.npp_multiplier)},
    {"psi_min", "MPa", {-10, -0.05}, AT(response.min_potential_mpa)},
    {"n_class", "1-3", {1, 3}, AT(response.nitrogen_class)},
    {"vpd_exp_iland", "kPa-1", {-5, 0}, AT(response.vpd_exponent_pkpa)},
    {"temp_min_iland", "degC", {-20, 20}, AT(response.zero_growth_degc)},
    {"temp_max_iland", "degC", {0, 40}, AT(response.full_growth_degc)},
    {"gdd_min", "degC_d", {0, 5000}, AT(response.min_degree_days)},
    {"gdd_max", "degC_d", {0, 10000}, AT(response.max_degree_days)},
    {"winter_tmin", "degC", {-99, 20}, AT(response.min_winter_degc)},
    {"ph_opt_min", "pH", {2, 9}, AT(response.min_optimum_ph)},
    // seeds
    {"maturity_age", "yr", {1, 300}, AT(seeds.maturity_years)},
    {"seed_year_interval", "yr", {1, 50}, AT(seeds.interval_years)},
    {"non_seed_year_fraction", "-", {0, 1}, AT(seeds.other_years_share)},
    {"fecundity", "seedlings_m-2", {0, 10000}, AT(seeds.seedlings_pm2)},
    {"seed_as1", "m", {0, 5000, above}, AT(seeds.kernel_m)},
    {"seed_as2", "m", {0, 20000}, AT(seeds.long_kernel_m)},
    {"seed_ks", "-", {0, 1}, AT(seeds.long_share)},
    // establishment
    {"est_tmin", "degC", {-99, 10}, AT(establishment.min_degc)},
    {"est_chill", "d", {0, 365}, AT(establishment.chilling_days)},
    {"est_gdd_min", "degC_d", {0, 5000}, AT(establishment.min_degree_days)},
    {"est_gdd_max", "degC_d", {0, 10000}, AT(establishment.max_degree_days)},
    {"est_gdd_base", "degC", {-5, 15}, AT(establishment.base_degc)},
    {"est_budburst_gdd", "degC_d", {0, 3000}, AT(establishment.budburst_degree_days)},
    {"est_frostfree_days", "d", {0, 365}, AT(establishment.frost_free_days)},
    {"est_frost_tol", "0-1", {0, 1}, AT(establishment.frost_tolerance)},
    // saplings
    {"sap_hmax", "m", {0, 120, above}, AT(saplings.max_height_m)},
    {"sap_rate", "yr-1", {0, 1, above}, AT(saplings.rate_pyear)},
    {"sap_max_stress", "yr", {0, 50}, AT(saplings.max_stress_years)},
    {"sap_stress_threshold", "-", {0, 1}, AT(saplings.stress_threshold)},
    {"sap_hd", "m_m-1", {10, 500, above}, AT(saplings.height_to_diameter)},
    {"sap_reineke", "stems_ha-1", {0, 10000, above}, AT(saplings.represented_stems_pha)},
    {"browse_p", "-", {0, 1}, AT(saplings.browsing_probability)},
    {"browse_tol", "1-5", {1, 5}, AT(saplings.browsing_class)},
    // mortality
    {"max_age", "yr", {1, 10000, above}, AT(mortality.max_age_years)},
    {"p_lucky", "-", {0, 1, above}, AT(mortality.lucky_share)},
    {"stress_b", "-", {0, 10}, AT(mortality.stress_coefficient)},
    {"thin_a", "-", {0, 30, above}, AT(mortality.thinning_intercept)},
    {"thin_b", "-", {-5, 0}, AT(mortality.thinning_slope)},
    // wind
    {"wind_Creg", "N_m_kg-1", {0, 1000, above}, AT(wind.anchorage_nmpkg)},
    {"wind_MOR", "MPa", {0, 300, above}, AT(wind.rupture_mpa)},
    {"wind_crown_share", "-", {0, 1, above}, AT(wind.crown_share)},
    // wounds
    {"bark_thickness", "cm_cm-1", {0, 0.5}, AT(wounds.bark_share)},
    {"wound_rot_p", "-", {0, 1}, AT(wounds.rot_probability)},
    {"rot_spread", "cm_yr-1", {0, 200}, AT(wounds.rot_spread_cmpyear)},
    // deadwood
    {"snag_ksw", "yr-1", {0, 1, above}, AT(deadwood.snag_decay_pyear)},
    {"snag_half_life", "yr", {0, 500, above}, AT(deadwood.snag_half_life_years)},
    {"log_k10", "yr-1", {0, 1, above}, AT(deadwood.log_decay_pyear)},
    // records
    {"usual_dbh_growth", "cm_yr-1", {0.01, 3}, AT(records.dbh_growth_cm_pyear)},
};

constexpr WholeField wholes[] = {
    {"leaf_on_month", "month", {0, 12}, AT(light.leaf_on_month)},
    {"leaf_off_month", "month", {0, 12}, AT(light.leaf_off_month)},
};

constexpr FlagField flags[] = {
    {"conifer", AT(conifer)},
    {"evergreen", AT(evergreen)},
    {"beetle_host", AT(beetle.host)},
    {"resprout", AT(wounds.resprouts)},
};

constexpr TextField texts[] = {
    {"species_code", AT(code)},
    {"latin_name", AT(latin_name)},
    {"german_name", AT(german_name)},
    {"source", AT(source)},
};
// clang-format on

#undef AT

}  // namespace

std::span<const NumberField> number_fields() {
    return numbers;
}
std::span<const WholeField> whole_fields() {
    return wholes;
}
std::span<const FlagField> flag_fields() {
    return flags;
}
std::span<const TextField> text_fields() {
    return texts;
}

}  // namespace forest
