#include "validation/engine/forest_cases/plain_3pg/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/units/constants.hpp"
#include "forest/production/power.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

using config::breast_height_m;

double competition_of(const Stand& stand) {
    double sum = 0.0;
    for (const SpeciesMonth& species : stand.species) {
        sum += species.age.wood_density_tpm3 * species.sizes.basal_area_m2pha;
    }
    return sum;
}

double lai_of(const Stand& stand) {
    double sum = 0.0;
    for (const SpeciesMonth& species : stand.species) {
        sum += species.canopy.lai;
    }
    return sum;
}

/// Height of the mean tree of all species.
double mean_height_m(const Stand& stand) {
    double height = 0.0;
    double stems = 0.0;
    for (const SpeciesMonth& species : stand.species) {
        height += species.sizes.height_m * species.stocks.stems_pha;
        stems += species.stocks.stems_pha;
    }
    return stems > 0.0 ? height / stems : 0.0;
}

void set_diameter(SpeciesMonth& species, const Parameters& parameters) {
    Sizes& sizes = species.sizes;
    sizes.dbh_cm =
        forest::power(sizes.tree_kg / parameters.stem_mass.factor, 1.0 / parameters.stem_mass.exponent);
    constexpr double m2_per_cm2 = 1e-4;
    sizes.basal_area_m2pha =
        0.25 * std::numbers::pi * sizes.dbh_cm * sizes.dbh_cm * m2_per_cm2 * species.stocks.stems_pha;
}

double exponential_law(const SizeLaw& law, double dbh_cm, double competition) {
    const double by_diameter = dbh_cm > 0.0 ? law.factor * config::exp_of(-law.dbh / dbh_cm) : 0.0;
    return breast_height_m + by_diameter + law.competition * competition * dbh_cm;
}

double height_by(const SizeLaw& law, double dbh_cm, double competition, HeightModel model) {
    if (model == HeightModel::exponential) {
        return exponential_law(law, dbh_cm, competition);
    }
    return law.factor * forest::power(dbh_cm, law.dbh) * forest::power(competition, law.competition);
}

/// What the sizes of a stand's trees depend on besides their own diameter.
struct Surroundings {
    double lai;
    double competition;
    double mean_height_m;
};

void set_sizes(SpeciesMonth& species, const Parameters& parameters, const Surroundings& around,
               HeightModel model) {
    Sizes& sizes = species.sizes;
    const double relative_height = around.mean_height_m > 0.0 ? sizes.height_m / around.mean_height_m : 1.0;
    set_diameter(species, parameters);
    const double dbh_cm = sizes.dbh_cm;
    sizes.height_m = height_by(parameters.height_m, dbh_cm, around.competition, model);

    const SizeLaw& length = parameters.crown_length_m;
    const double crown_length_m = model == HeightModel::exponential
                                      ? exponential_law(length, dbh_cm, around.competition)
                                      : length.factor * forest::power(dbh_cm, length.dbh) *
                                            forest::power(around.lai, length.lai) *
                                            forest::power(around.competition, length.competition) *
                                            forest::power(relative_height, length.relative_height);
    sizes.crown_length_m = std::min(crown_length_m, sizes.height_m);

    const SizeLaw& width = parameters.crown_width_m;
    sizes.crown_width_m = species.canopy.lai == 0.0
                              ? 0.0
                              : width.factor * forest::power(dbh_cm, width.dbh) *
                                    forest::power(sizes.height_m, width.height) *
                                    forest::power(around.competition, width.competition) *
                                    forest::power(relative_height, width.relative_height);
    sizes.foliage_to_stem = forest::FoliageToStemLaw{parameters.foliage_to_stem}.at(dbh_cm);
}

}  // namespace

void start_sizes(Stand& stand, const Inputs& inputs, HeightModel height) {
    update_leaves_and_trees(stand);
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        set_diameter(stand.species[i], inputs.parameters[i]);
    }
    const double competition = competition_of(stand);
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        Sizes& sizes = stand.species[i].sizes;
        sizes.height_m = height_by(inputs.parameters[i].height_m, sizes.dbh_cm, competition, height);
    }
    update_sizes(stand, inputs, height);
}

void update_sizes(Stand& stand, const Inputs& inputs, HeightModel height) {
    for (int pass = 0; pass < 2; ++pass) {
        const Surroundings around{lai_of(stand), competition_of(stand), mean_height_m(stand)};
        for (std::size_t i = 0; i < stand.species.size(); ++i) {
            set_sizes(stand.species[i], inputs.parameters[i], around, height);
        }
    }
}

void update_sizes_if_outdated(Stand& stand, const Inputs& inputs, HeightModel height) {
    if (stand.sizes_outdated) {
        update_leaves_and_trees(stand);
        update_sizes(stand, inputs, height);
        stand.sizes_outdated = false;
    }
}

void update_leaves_and_trees(Stand& stand) {
    constexpr double m2pm2_per_m2pkg_tpha = 0.1;
    constexpr double kg_per_t = 1000.0;
    for (SpeciesMonth& species : stand.species) {
        const Stocks& stocks = species.stocks;
        species.sizes.tree_kg = stocks.stems_pha > 0.0 ? stocks.stem * kg_per_t / stocks.stems_pha : 0.0;
        species.canopy.lai = stocks.foliage * species.age.sla_m2pkg * m2pm2_per_m2pkg_tpha;
    }
}

double volume_m3pha(const SpeciesMonth& species, const Parameters& parameters) {
    const VolumeLaw& law = parameters.volume_m3;
    if (law.factor == 0.0) {
        return species.stocks.stem * (1.0 - species.age.branch_share) / species.age.wood_density_tpm3;
    }
    const double dbh_cm = species.sizes.dbh_cm;
    const double height_m = species.sizes.height_m;
    return law.factor * forest::power(dbh_cm, law.dbh) * forest::power(height_m, law.height) *
           forest::power(dbh_cm * dbh_cm * height_m, law.joint) * species.stocks.stems_pha;
}

void update_basal_area_shares(Stand& stand) {
    double total = 0.0;
    for (const SpeciesMonth& species : stand.species) {
        total += species.sizes.basal_area_m2pha;
    }
    for (SpeciesMonth& species : stand.species) {
        species.sizes.basal_area_share = total > 0.0 ? species.sizes.basal_area_m2pha / total : 0.0;
    }
}

}  // namespace coupling::validation::forest_cases::plain_3pg
