#include "validation/engine/forest_cases/demography_trial/trial.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "forest/climate/change.hpp"
#include "forest/climate/sequence.hpp"
#include "forest/climate/summary.hpp"
#include "forest/deadwood/decay.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/start/height_curve.hpp"
#include "forest/start/places.hpp"
#include "forest/start/settled_crowns.hpp"
#include "forest/start/starting_stand.hpp"
#include "validation/engine/forest_cases/shared/level_forest.hpp"
#include "validation/engine/forest_cases/yield_trial/trial.hpp"

namespace coupling::validation::forest_cases::demography_trial {

namespace {

using forest::ClimateYear;
using forest::Place;
using forest::Species;
using forest::SpeciesTable;
using forest::Tree;

constexpr int side_patches = 5;  // 50 m
constexpr double thicker_cm = 10.0;

std::vector<ClimateYear> changed_years(const std::vector<ClimateYear>& years, double warmer_k,
                                       double wetter) {
    std::vector<ClimateYear> result;
    result.reserve(years.size());
    const forest::ClimateChange change = forest::ClimateChange::of(warmer_k, wetter);
    for (const ClimateYear& year : years) {
        result.push_back(forest::changed(year, change));
    }
    return result;
}

std::vector<Place> target_places(const forest::PatchGrid& grid) {
    std::vector<Place> places;
    for (const double x_m : {12.5, 37.5}) {
        for (const double y_m : {12.5, 37.5}) {
            const double east_m = grid.frame().x_centre_m(0) - 5.0 + x_m;
            const double north_m = grid.frame().y_centre_m(side_patches - 1) - 5.0 + y_m;
            places.push_back({*grid.at(east_m, north_m), east_m, north_m});
        }
    }
    return places;
}

/// A tree of the species' usual height and age for its diameter.
Tree usual_tree(const DemographyTrial& trial, const Species& kind, const Place& place, double dbh_cm) {
    const double height_m = std::max(1.4, forest::height_by_growth(kind, dbh_cm, trial.degree_days));
    return forest::new_tree(kind, trial.species, place.x_m, place.y_m, dbh_cm, height_m,
                            forest::usual_age_years(kind, dbh_cm));
}

std::vector<Tree> trees_of(const DemographyTrial& trial, const SpeciesTable& species,
                           const forest::PatchGrid& grid, const forest::YearKey& key) {
    const Species& kind = species[trial.species];
    const std::vector<Place> targets = target_places(grid);
    std::vector<Tree> trees;
    for (const Place& place : targets) {
        trees.push_back(usual_tree(trial, kind, place, trial.dbh_cm));
    }
    const double thick_cm = trial.dbh_cm + thicker_cm;
    const auto larger = static_cast<std::size_t>(
        std::lround(trial.larger_m2pha * grid.area_ha() / forest::basal_area_m2(thick_cm)));
    std::vector<forest::PatchId> patches;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        patches.push_back(forest::PatchId{i});
    }
    const std::vector<double> diameters_cm(larger, thick_cm);
    for (const Place& place : forest::places_for(grid, patches, diameters_cm, forest::Structure::even_aged,
                                                 {key.seed, key.replicate, targets.size()}, targets)) {
        trees.push_back(usual_tree(trial, kind, place, thick_cm));
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
        trees[i].id = forest::TreeId{i};
    }
    forest::settle_crowns(trees, species, grid.area_m2());
    return trees;
}

}  // namespace

PlaceClimate climate_of(const std::vector<ClimateYear>& years) {
    double degree_days = 0.0;
    double rain_mm = 0.0;
    double demand_mm = 0.0;
    for (const ClimateYear& year : years) {
        degree_days += forest::degree_days(year) / static_cast<double>(years.size());
        demand_mm += forest::potential_evapotranspiration_mm(year);
        for (const forest::ClimateMonth& month : year.months) {
            rain_mm += month.prec_mm;
        }
    }
    return {degree_days, (rain_mm - demand_mm) / demand_mm};
}

std::vector<ClimateYear> shifted_to(const std::vector<ClimateYear>& years, const PlaceClimate& wanted) {
    double low_k = -15.0;
    double high_k = 15.0;
    for (int halving = 0; halving < 20; ++halving) {
        const double middle_k = 0.5 * (low_k + high_k);
        const bool too_cold =
            climate_of(changed_years(years, middle_k, 1.0)).degree_days < wanted.degree_days;
        (too_cold ? low_k : high_k) = middle_k;
    }
    const double warmer_k = 0.5 * (low_k + high_k);
    const PlaceClimate warm = climate_of(changed_years(years, warmer_k, 1.0));
    return changed_years(years, warmer_k, (1.0 + wanted.wetness) / (1.0 + warm.wetness));
}

Fate& Fate::operator+=(const Fate& other) {
    trees += other.trees;
    survivors += other.survivors;
    growth_mm_pyear += other.growth_mm_pyear;
    return *this;
}

double Fate::mean_growth_mm_pyear() const {
    return survivors > 0 ? growth_mm_pyear / static_cast<double>(survivors) : 0.0;
}

double Fate::mortality_pyear(int years) const {
    if (trees == 0) {
        return 0.0;
    }
    return 1.0 - std::pow(static_cast<double>(survivors) / static_cast<double>(trees), 1.0 / years);
}

forest::PatchGrid trial_grid() {
    return level_patches(side_patches, yield_trial::trial_soil);
}

Fate grow_demography(const DemographyTrial& trial, const forest::Site& site, const SpeciesTable& species,
                     const forest::YearKey& key) {
    forest::PatchGrid grid = trial_grid();
    std::vector<Tree> trees = trees_of(trial, species, grid, key);
    const std::size_t targets = target_places(grid).size();
    forest::Stand stand{std::move(grid), species.size(), std::move(trees), 0};
    const forest::YearSequence sequence =
        forest::YearSequence::drawn({0, static_cast<int>(trial.climate.size()) - 1}, key.seed, key.replicate);
    for (int year = 1; year <= trial.years; ++year) {
        const std::vector<ClimateYear> weather(
            site.units().size(), trial.climate[static_cast<std::size_t>(sequence.source_of(year))]);
        static_cast<void>(forest::grow_year(stand, site, species, {.units = weather}, trial.parameters, key));
    }
    Fate fate{.trees = targets};
    for (std::size_t i = 0; i < targets; ++i) {
        constexpr double mm_per_cm = 10.0;
        if (const auto place = stand.find(forest::TreeId{i})) {
            ++fate.survivors;
            fate.growth_mm_pyear += mm_per_cm * (stand.trees()[*place].dbh_cm - trial.dbh_cm) / trial.years;
        }
    }
    return fate;
}

}  // namespace coupling::validation::forest_cases::demography_trial
