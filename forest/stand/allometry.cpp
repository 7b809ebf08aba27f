#include "forest/stand/allometry.hpp"

#include "config/math/elementary.hpp"

namespace forest {

double at_dbh(const Power& power, double dbh_cm) {
    return power.factor * config::pow_of(dbh_cm, power.exponent);
}

double stem_volume_m3(const Allometry& allometry, double dbh_cm, double height_m) {
    return allometry.form_factor * basal_area_m2(dbh_cm) * height_m;
}

PartMasses part_masses(const Allometry& allometry, double dbh_cm, double height_m, double completeness) {
    return {.stem_kg = stem_volume_m3(allometry, dbh_cm, height_m) * allometry.stem_density_kgpm3,
            .branch_kg = at_dbh(allometry.branch, dbh_cm),
            .foliage_kg = at_dbh(allometry.foliage, dbh_cm) * completeness,
            .coarse_root_kg = at_dbh(allometry.coarse_root, dbh_cm)};
}

double reported_mass_kg(const Allometry& allometry, double above_ground_kg, double stem_kg) {
    return above_ground_kg - stem_kg * (1.0 - allometry.basic_density_kgpm3 / allometry.stem_density_kgpm3);
}

double leaf_area_m2(const Species& species, double dbh_cm, double completeness) {
    return at_dbh(species.allometry.foliage, dbh_cm) * completeness * species.light.sla_m2pkg;
}

}  // namespace forest
