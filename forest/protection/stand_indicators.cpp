#include "forest/protection/stand_indicators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "forest/deadwood/deadwood.hpp"

namespace forest {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double dominant_pha = 100.0;
constexpr double plant_radius_share = 0.2;

double slenderness_of(const Tree& tree) {
    constexpr double cm_per_m = 100.0;
    return cm_per_m * tree.height_m / tree.dbh_cm;
}

double disc_m2(double radius_m) {
    return std::numbers::pi * radius_m * radius_m;
}

/// Mean slenderness and crown ratio of the thickest stems.
void add_bearers(std::vector<const Tree*> trees, double area_ha, StandIndicators& found) {
    std::stable_sort(trees.begin(), trees.end(),
                     [](const Tree* a, const Tree* b) { return a->dbh_cm > b->dbh_cm; });
    const double wanted = std::max(1.0, dominant_pha * area_ha);
    double stems = 0.0;
    double slenderness = 0.0;
    double ratio = 0.0;
    for (const Tree* tree : trees) {
        const double counted = std::min<double>(tree->stems, wanted - stems);
        stems += counted;
        slenderness += counted * slenderness_of(*tree);
        ratio += counted * (1.0 - tree->crown.base_m / tree->height_m);
        if (stems >= wanted) {
            break;
        }
    }
    found.slenderness = stems > 0.0 ? slenderness / stems : unknown;
    found.crown_ratio_percent = stems > 0.0 ? 100.0 * ratio / stems : unknown;
}

/// Areas of crowns by patch.
struct Crowns {
    double bearing_m2 = 0.0;
    double young_m2 = 0.0;
};

}  // namespace

double cover_of(double crown_area_share) {
    return -std::expm1(-crown_area_share);
}

StandIndicators indicators_of(const Stand& stand, const SpeciesTable& species,
                              const std::function<bool(const Patch&)>& counts) {
    const PatchGrid& grid = stand.grid();
    std::vector<Crowns> crowns(grid.size());
    StandIndicators found;
    std::vector<const Tree*> bearing;
    double bearing_stems = 0.0;
    double slender_stems = 0.0;
    double young_stems = 0.0;
    for (const Tree& tree : stand.trees()) {
        if (!counts(grid[tree.patch])) {
            continue;
        }
        Crowns& here = crowns[index_of(tree.patch)];
        if (tree.dbh_cm >= bearing_dbh_cm) {
            here.bearing_m2 += tree.stems * disc_m2(tree.crown.radius_m);
            bearing_stems += tree.stems;
            slender_stems += slenderness_of(tree) > slender_above ? tree.stems : 0.0;
            bearing.push_back(&tree);
        } else {
            here.young_m2 += tree.stems * disc_m2(tree.crown.radius_m);
            young_stems += tree.stems;
        }
    }
    for (const Cohort& cohort : stand.cohorts()) {
        if (cohort.height_m >= young_growth_m && counts(grid[cohort.patch])) {
            crowns[index_of(cohort.patch)].young_m2 +=
                cohort.stems * disc_m2(plant_radius_share * cohort.height_m);
            young_stems += cohort.stems;
        }
    }
    double patches = 0.0;
    for (std::uint32_t p = 0; p < grid.size(); ++p) {
        if (counts(grid[PatchId{p}])) {
            patches += 1.0;
            found.cover_percent += 100.0 * cover_of(crowns[p].bearing_m2 / patch_area_m2);
            found.regeneration_percent += 100.0 * cover_of(crowns[p].young_m2 / patch_area_m2);
        }
    }
    double logs_m3 = 0.0;
    for (const Log& log : stand.dead_wood().logs) {
        const auto patch = grid.at(log.x_m, log.y_m);
        logs_m3 += patch && counts(grid[*patch]) ? volume_m3(log, species) : 0.0;
    }
    const double area_ha = patches * patch_area_m2 / square_metres_per_hectare;
    if (patches > 0.0) {
        found.cover_percent /= patches;
        found.regeneration_percent /= patches;
        found.regeneration_pha = young_stems / area_ha;
        found.logs_m3pha = logs_m3 / area_ha;
    }
    found.slender_percent = bearing_stems > 0.0 ? 100.0 * slender_stems / bearing_stems : unknown;
    add_bearers(std::move(bearing), area_ha, found);
    return found;
}

}  // namespace forest
