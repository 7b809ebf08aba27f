#include "forest/growth.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/math/elementary.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/stand/crown.hpp"
#include "forest/stand/height_growth.hpp"
#include "forest/stand/site_height.hpp"

namespace forest {

namespace {

/// Above-ground mass and its slope at a diameter increment.
struct MassAt {
    double kg = 0.0;
    double kg_pcm = 0.0;
};

/// Above-ground mass along the path that a tree grows on: height rises from `height_m` by `rise_m_pcm` a cm.
struct GrowthPath {
    const Allometry& allometry;
    double dbh_cm;
    double height_m;
    double rise_m_pcm;
    double completeness;

    [[nodiscard]] MassAt at(double increment_cm) const {
        const double d_cm = dbh_cm + increment_cm;
        const double h_m = height_m + rise_m_pcm * increment_cm;
        const double log2_d = config::log2_of(d_cm);
        const double stem_factor = allometry.form_factor * allometry.stem_density_kgpm3 * basal_area_m2(1.0);
        const double branch_kg =
            allometry.branch.factor * config::exp2_of(allometry.branch.exponent * log2_d);
        const double foliage_kg =
            completeness * allometry.foliage.factor * config::exp2_of(allometry.foliage.exponent * log2_d);
        const double stem_slope = stem_factor * d_cm * (2.0 * h_m + d_cm * rise_m_pcm);
        const double green_slope =
            (branch_kg * allometry.branch.exponent + foliage_kg * allometry.foliage.exponent) / d_cm;
        return {.kg = stem_factor * d_cm * d_cm * h_m + branch_kg + foliage_kg,
                .kg_pcm = stem_slope + green_slope};
    }

    /// The increment at which the mass is `target_kg`. Requires a target of at least the mass at 0.
    [[nodiscard]] double increment_to(double target_kg) const {
        constexpr int most_steps = 30;
        constexpr double close_enough_cm = 1e-6;  // what is left then is of the order of its square
        MassAt mass = at(0.0);
        double increment_cm = (target_kg - mass.kg) / mass.kg_pcm;
        for (int step = 0; step < most_steps; ++step) {
            mass = at(increment_cm);
            const double back_cm = (mass.kg - target_kg) / mass.kg_pcm;
            increment_cm -= back_cm;
            if (back_cm < close_enough_cm) {
                break;
            }
        }
        return std::max(increment_cm, 0.0);
    }
};

}  // namespace

Increment increment_of(const Species& species, const Size& size, double ratio, double gain_kg) {
    if (!(gain_kg > 0.0)) {
        return {};
    }
    constexpr double cm_per_m = 100.0;
    const double room_m = std::max(0.0, species.height_growth.max_height_m - size.height_m);
    const double most_cm =
        std::clamp(species.height_growth.max_dbh_cm - size.dbh_cm, 0.0, largest_increment_cm);
    const GrowthPath free{species.allometry, size.dbh_cm, size.height_m, ratio / cm_per_m, size.completeness};
    const double before_kg = free.at(0.0).kg;

    double dbh_cm = std::min(free.increment_to(before_kg + gain_kg), most_cm);
    double height_m = free.rise_m_pcm * dbh_cm;
    if (height_m <= room_m) {
        return {dbh_cm, height_m, dbh_cm < most_cm ? gain_kg : free.at(dbh_cm).kg - before_kg};
    }
    // The top is reached within the year: the rest grows the diameter.
    const GrowthPath at_top{species.allometry, size.dbh_cm, size.height_m + room_m, 0.0, size.completeness};
    dbh_cm = std::min(at_top.increment_to(before_kg + gain_kg), most_cm);
    return {dbh_cm, room_m, dbh_cm < most_cm ? gain_kg : at_top.at(dbh_cm).kg - before_kg};
}

std::vector<TreeGrowth> growth_of_trees(const Stand& stand, const SpeciesTable& species,
                                        std::span<const TreeSeason> seasons) {
    const std::span<const Tree> trees = stand.trees();
    assert(seasons.size() == trees.size());
    std::vector<TreeGrowth> growth(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Tree& tree = trees[i];
        const Species& kind = species[tree.species];
        const TreeSeason& season = seasons[i];

        const double gain_kg = season.npp_kg * (1.0 - season.root_share) * std::sqrt(tree.vitality);
        const double ratio =
            height_diameter_ratio(kind.height_growth, tree.dbh_cm, tree.light_ratio,
                                  site_height_factor(kind.height_growth, season.degree_days)) *
            height_room(tree.height_m, season.site_height_m);
        const Increment increment =
            increment_of(kind, {tree.dbh_cm, tree.height_m, tree.crown.completeness}, ratio, gain_kg);

        const double dbh_cm = tree.dbh_cm + increment.dbh_cm;
        const double height_m = tree.height_m + increment.height_m;
        growth[i].dbh_cm = increment.dbh_cm;
        growth[i].height_m = increment.height_m;
        growth[i].crown = next_crown(kind, tree.crown,
                                     {.dbh_cm = dbh_cm,
                                      .height_m = height_m,
                                      .height_growth_m = increment.height_m,
                                      .light_ratio = tree.light_ratio,
                                      .shaded_below_m = season.shaded_below_m});
        const PartMasses masses = part_masses(kind.allometry, dbh_cm, height_m, growth[i].crown.completeness);
        growth[i].above_ground_kg = masses.above_ground_kg();
        growth[i].stem_kg = masses.stem_kg;
        growth[i].gain_kg = gain_kg;
    }
    return growth;
}

}  // namespace forest
