#include "forest/inventory/tables.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "forest/deadwood/deadwood.hpp"
#include "forest/saplings/saplings.hpp"
#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

constexpr double kg_per_t = 1000.0;

double reported_kg(const Tree& tree, const SpeciesTable& species) {
    return reported_mass_kg(species[tree.species].allometry, tree.above_ground_kg, tree.stem_kg);
}

/// Mean height of the thickest stems: 100 on a hectare.
double dominant_height_m(std::span<const Tree> trees, double area_ha) {
    struct Stem {
        double dbh_cm;
        double height_m;
        double number;
    };
    std::vector<Stem> stems;
    stems.reserve(trees.size());
    for (const Tree& tree : trees) {
        stems.push_back({tree.dbh_cm, tree.height_m, static_cast<double>(tree.stems)});
    }
    const auto thicker = [](const Stem& a, const Stem& b) {
        return a.dbh_cm != b.dbh_cm ? a.dbh_cm > b.dbh_cm : a.height_m > b.height_m;
    };
    const double wanted = 100.0 * area_ha;
    // Each record has at least one stem, so this many records are enough.
    const auto enough = std::min(stems.size(), static_cast<std::size_t>(std::ceil(wanted)));
    const auto middle = stems.begin() + static_cast<std::ptrdiff_t>(enough);
    std::partial_sort(stems.begin(), middle, stems.end(), thicker);
    double number = 0.0;
    double sum_m = 0.0;
    for (auto stem = stems.begin(); stem != middle && number < wanted; ++stem) {
        const double taken = std::min(stem->number, wanted - number);
        number += taken;
        sum_m += taken * stem->height_m;
    }
    return number > 0.0 ? sum_m / number : 0.0;
}

}  // namespace

std::size_t dbh_class_of(double dbh_cm) {
    const auto number = static_cast<std::size_t>(std::max(0.0, dbh_cm / dbh_class_cm));
    return std::min(number, dbh_classes - 1);
}

StandFigures figures_of(std::span<const Tree> trees, const SpeciesTable& species, double area_ha) {
    assert(area_ha > 0.0);
    constexpr double m2_per_ha = 10'000.0;
    StandFigures figures;
    double basal_area_height_m3 = 0.0;
    for (const Tree& tree : trees) {
        const double stems_pha = tree.stems / area_ha;
        const double basal_area = stems_pha * basal_area_m2(tree.dbh_cm);
        figures.stems_pha += stems_pha;
        figures.stems_pha_by_class[dbh_class_of(tree.dbh_cm)] += stems_pha;
        figures.basal_area_m2pha += basal_area;
        basal_area_height_m3 += basal_area * tree.height_m;
        const double volume_m3pha =
            stems_pha * stem_volume_m3(species[tree.species].allometry, tree.dbh_cm, tree.height_m);
        figures.volume_m3pha += volume_m3pha;
        for (std::size_t i = 0; i < counted_from_cm.size(); ++i) {
            if (tree.dbh_cm >= counted_from_cm[i]) {
                figures.from[i].stems_pha += stems_pha;
                figures.from[i].basal_area_m2pha += basal_area;
                figures.from[i].volume_m3pha += volume_m3pha;
            }
        }
        figures.above_ground_tpha += stems_pha * reported_kg(tree, species) / kg_per_t;
        figures.leaf_area_index += stems_pha * tree.crown.leaf_area_m2 / m2_per_ha;
    }
    if (figures.stems_pha > 0.0) {
        figures.mean_dbh_cm = std::sqrt(figures.basal_area_m2pha / figures.stems_pha / basal_area_m2(1.0));
        figures.lorey_height_m = basal_area_height_m3 / figures.basal_area_m2pha;
        figures.dominant_height_m = dominant_height_m(trees, area_ha);
    }
    return figures;
}

std::vector<StandFigures> figures_by_species(std::span<const Tree> trees, const SpeciesTable& species,
                                             double area_ha) {
    std::vector<std::vector<Tree>> own(species.size());
    for (const Tree& tree : trees) {
        own[index_of(tree.species)].push_back(tree);
    }
    std::vector<StandFigures> figures;
    figures.reserve(own.size());
    for (const std::vector<Tree>& trees_of_one : own) {
        figures.push_back(figures_of(trees_of_one, species, area_ha));
    }
    return figures;
}

std::vector<YoungFigures> young_figures_of(const Stand& stand, const std::function<bool(const Patch&)>& takes,
                                           double area_ha) {
    assert(area_ha > 0.0);
    std::vector<YoungFigures> figures(1 + stand.species_count());
    for (const Cohort& cohort : stand.cohorts()) {
        if (!takes(stand.grid()[cohort.patch])) {
            continue;
        }
        const double stems_pha = cohort.stems / area_ha;
        for (YoungFigures* young : {&figures.front(), &figures[1 + index_of(cohort.species)]}) {
            young->saplings_pha += stems_pha;
            young->from_20cm_pha += cohort.height_m >= 0.2 ? stems_pha : 0.0;
            young->on_wood_pha += cohort.on_wood ? stems_pha : 0.0;
            if (is_in_reach(cohort.height_m)) {
                young->in_reach_pha += stems_pha;
                young->browsed_pha += cohort.browsed ? stems_pha : 0.0;
            }
        }
    }
    return figures;
}

StandYear year_of(const Stand& stand, const SpeciesTable& species, double volume_increment_m3) {
    const double area_ha = stand.grid().area_ha();
    StandYear year;
    year.year = stand.year();
    year.all = figures_of(stand.trees(), species, area_ha);
    year.by_species = figures_by_species(stand.trees(), species, area_ha);
    year.volume_increment_m3pha = volume_increment_m3 / area_ha;
    year.ingrowth_stems_pha = static_cast<double>(stand.balance().all_stems_in()) / area_ha;
    year.losses_by_species.resize(species.size());
    for (const auto& [tree, cause] : stand.deaths()) {
        const double stems_pha = tree.stems / area_ha;
        const double volume_m3pha =
            stems_pha * stem_volume_m3(species[tree.species].allometry, tree.dbh_cm, tree.height_m);
        for (Loss* loss : {&year.losses[index_of(cause)],
                           &year.losses_by_species[index_of(tree.species)][index_of(cause)]}) {
            loss->stems_pha += stems_pha;
            loss->volume_m3pha += volume_m3pha;
            loss->above_ground_tpha += stems_pha * reported_kg(tree, species) / kg_per_t;
        }
    }
    year.saplings_pha = static_cast<double>(stand.saplings_standing()) / area_ha;
    const SnagsAndLogs& dead = stand.dead_wood();
    year.snags_pha = static_cast<double>(dead.snags.size()) / area_ha;
    year.logs_pha = static_cast<double>(dead.logs.size()) / area_ha;
    const auto by_class = [&year](double density_share) -> double& {
        return year.dead_wood_m3pha[static_cast<std::size_t>(decay_class_of(density_share) - 1)];
    };
    for (const Snag& snag : dead.snags) {
        const double snag_m3pha = volume_m3(snag, species) / area_ha;
        year.snags_m3pha += snag_m3pha;
        by_class(snag.density_share) += snag_m3pha;
    }
    for (const Log& log : dead.logs) {
        const double log_m3pha = volume_m3(log, species) / area_ha;
        year.logs_m3pha += log_m3pha;
        by_class(log.density_share) += log_m3pha;
    }
    year.dead_stems_tpha = stand.dead_wood_kg() / kg_per_t / area_ha;
    return year;
}

}  // namespace forest
