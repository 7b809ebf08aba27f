#include "coupling/assessments/decades/members/record_forest.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "coupling/exchange/stems_and_logs.hpp"
#include "forest/deadwood/deadwood.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::decades {
namespace {

constexpr double kg_per_t = 1000.0;

/// What only a season of growth can show is not known at the start, in year 0.
double of_a_season(std::int32_t year, double value) {
    return year == 0 ? std::numeric_limits<double>::quiet_NaN() : value;
}

/// The whole of some trees and young trees and each species that has any. `young` begins with the whole.
void add_stands(std::span<const forest::Tree> trees, std::span<const forest::YoungFigures> young,
                const forest::SpeciesTable& species, double area_ha, std::int32_t year, std::uint32_t unit,
                double drought_index, MemberYears& kept) {
    kept.stands.push_back(
        {year, unit, all, forest::figures_of(trees, species, area_ha), drought_index, young.front()});
    const std::vector<forest::StandFigures> by_species = forest::figures_by_species(trees, species, area_ha);
    for (std::uint32_t s = 0; s < by_species.size(); ++s) {
        if (by_species[s].stems_pha > 0.0 || young[s + 1].saplings_pha > 0.0) {
            kept.stands.push_back({year, unit, s, by_species[s], drought_index, young[s + 1]});
        }
    }
}

struct Unit {
    std::size_t patches = 0;
    double drought = 0.0;  ///< sum of the index over the patches
    std::vector<forest::Tree> trees;

    [[nodiscard]] double drought_index() const {
        return patches > 0 ? drought / static_cast<double>(patches) : 0.0;
    }
};

/// Gaps of the whole forest and of each management unit.
void add_gaps(const forest::Stand& stand, const std::map<std::uint32_t, Unit>& units, std::int32_t year,
              MemberYears& kept) {
    const forest::PatchGrid& grid = stand.grid();
    const std::vector<char> open = forest::open_patches(grid, stand.trees());
    const std::vector<forest::Gap> gaps = forest::gaps_along_fall_line(grid, open);
    kept.gaps.push_back(
        {year, all, forest::figures_of(grid, open, gaps, [](const forest::Patch&) { return true; })});
    for (const auto& [number, unit] : units) {
        if (units.size() > 1) {
            kept.gaps.push_back(
                {year, number,
                 forest::figures_of(grid, open, gaps, [number = number](const forest::Patch& patch) {
                     return patch.management_unit == number;
                 })});
        }
    }
}

/// Indicators of the whole forest and of each management unit.
void add_indicators(const forest::Stand& stand, const forest::SpeciesTable& species,
                    const std::map<std::uint32_t, Unit>& units, std::int32_t year, MemberYears& kept) {
    kept.indicators.push_back(
        {year, all, forest::indicators_of(stand, species, [](const forest::Patch&) { return true; })});
    for (const auto& [number, unit] : units) {
        if (units.size() > 1) {
            kept.indicators.push_back(
                {year, number,
                 forest::indicators_of(stand, species, [number = number](const forest::Patch& patch) {
                     return patch.management_unit == number;
                 })});
        }
    }
}

/// What became of the wood of stems this year.
void add_wood(const forest::Stand& stand, YearRow& row) {
    const double kg_per_tpha = kg_per_t * stand.grid().area_ha();
    const forest::StandBalance& balance = stand.balance();
    double litter_kg = 0.0;
    for (const auto& [tree, cause] : stand.deaths()) {
        litter_kg += tree.dbh_cm < forest::least_dead_wood_cm ? tree.stems * tree.stem_kg : 0.0;
    }
    row.stem_growth_tpha = balance.stem_grown_kg / kg_per_tpha;
    row.stem_ingrowth_tpha = balance.stem_in_kg / kg_per_tpha;
    row.stem_losses_tpha = balance.all_stem_lost_kg() / kg_per_tpha;
    row.stem_litter_tpha = litter_kg / kg_per_tpha;
    row.dead_wood_in_tpha = balance.dead_wood_in_kg / kg_per_tpha;
    row.stem_hauled_tpha = row.stem_losses_tpha - row.stem_litter_tpha - row.dead_wood_in_tpha;
    row.dead_wood_decayed_tpha = balance.dead_wood_decayed_kg / kg_per_tpha;
    row.dead_wood_to_soil_tpha = balance.dead_wood_to_soil_kg / kg_per_tpha;
    row.dead_wood_taken_tpha = balance.dead_wood_taken_kg / kg_per_tpha;
}

std::map<std::uint32_t, Unit> units_of(const forest::Stand& stand) {
    std::map<std::uint32_t, Unit> units;
    for (std::size_t i = 0; i < stand.grid().size(); ++i) {
        Unit& unit = units[stand.grid().patches()[i].management_unit];
        ++unit.patches;
        unit.drought += stand.patch_states()[i].drought_index;
    }
    if (units.size() > 1) {
        for (const forest::Tree& tree : stand.trees()) {
            units[stand.grid()[tree.patch].management_unit].trees.push_back(tree);
        }
    }
    return units;
}

}  // namespace

void record_year(const forest::Stand& stand, const forest::SpeciesTable& species, std::int32_t year,
                 const std::optional<forest::YearReport>& report, double mean_temperature_degc,
                 MemberYears& kept) {
    const double area_ha = stand.grid().area_ha();
    const std::map<std::uint32_t, Unit> units = units_of(stand);
    Unit whole_forest;
    for (const auto& [number, unit] : units) {
        whole_forest.patches += unit.patches;
        whole_forest.drought += unit.drought;
    }
    add_stands(stand.trees(),
               forest::young_figures_of(
                   stand, [](const forest::Patch&) { return true; }, area_ha),
               species, area_ha, year, all, of_a_season(year, whole_forest.drought_index()), kept);
    if (units.size() > 1) {
        for (const auto& [number, unit] : units) {
            const double unit_ha = static_cast<double>(unit.patches) * forest::patch_area_m2 / 10'000.0;
            const auto in_unit = [number = number](const forest::Patch& patch) {
                return patch.management_unit == number;
            };
            add_stands(unit.trees, forest::young_figures_of(stand, in_unit, unit_ha), species, unit_ha, year,
                       number, of_a_season(year, unit.drought_index()), kept);
        }
    }

    add_gaps(stand, units, year, kept);
    add_indicators(stand, species, units, year, kept);

    const forest::StandYear whole =
        forest::year_of(stand, species, report ? report->volume_increment_m3 : 0.0);
    YearRow row;
    row.year = year;
    row.calendar_year = stand.year();
    row.saplings_pha = whole.saplings_pha;
    row.snags_pha = whole.snags_pha;
    row.snags_m3pha = whole.snags_m3pha;
    row.logs_pha = whole.logs_pha;
    row.logs_m3pha = whole.logs_m3pha;
    row.dead_stems_tpha = whole.dead_stems_tpha;
    row.dead_wood_m3pha = whole.dead_wood_m3pha;
    row.stem_wood_tpha = stand.stem_mass_standing_kg() / kg_per_t / area_ha;
    if (report) {
        row.volume_increment_m3pha = whole.volume_increment_m3pha;
        row.production_tpha = report->production_kg / kg_per_t / area_ha;
        row.ingrowth_stems_pha = whole.ingrowth_stems_pha;
        row.precipitation_mm = report->water.precipitation_mm;
        row.evapotranspiration_mm = report->water.evapotranspiration_mm;
        row.runoff_mm = report->water.runoff_mm;
        row.storage_gain_mm = report->water.storage_gain_mm;
        row.mean_temperature_degc = mean_temperature_degc;
    }
    kept.years.push_back(row);
}

void record_losses(const forest::Stand& stand, const forest::SpeciesTable& species, std::int32_t year,
                   bool list_all, MemberYears& kept) {
    add_wood(stand, kept.years.back());
    const forest::StandYear whole = forest::year_of(stand, species, 0.0);
    for (std::size_t cause = 0; cause < forest::cause_count; ++cause) {
        for (std::uint32_t s = 0; s < whole.losses_by_species.size(); ++s) {
            const forest::Loss& loss = whole.losses_by_species[s][cause];
            if (loss.stems_pha > 0.0) {
                kept.losses.push_back({year, s, static_cast<forest::Cause>(cause), loss});
            }
        }
    }
    for (const auto& [tree, cause] : stand.deaths()) {
        const bool is_listed = list_all || cause == forest::Cause::rock || cause == forest::Cause::wound;
        if (is_listed && tree.dbh_cm >= forest::least_dead_wood_cm) {
            kept.removed.push_back({.year = year,
                                    .species = static_cast<std::uint32_t>(forest::index_of(tree.species)),
                                    .tree = forest::number_of(tree.id),
                                    .x_m = tree.x_m,
                                    .y_m = tree.y_m,
                                    .dbh_cm = static_cast<float>(tree.dbh_cm),
                                    .height_m = static_cast<float>(tree.height_m),
                                    .cause = cause});
        }
    }
}

void record_trees(const forest::Stand& stand, std::int32_t year, MemberYears& kept) {
    for (const forest::Tree& tree : stand.trees()) {
        kept.trees.push_back({.year = year,
                              .species = static_cast<std::uint32_t>(forest::index_of(tree.species)),
                              .tree = forest::number_of(tree.id),
                              .x_m = tree.x_m,
                              .y_m = tree.y_m,
                              .dbh_cm = static_cast<float>(tree.dbh_cm),
                              .height_m = static_cast<float>(tree.height_m),
                              .crown_base_m = static_cast<float>(tree.crown.base_m),
                              .crown_radius_m = static_cast<float>(tree.crown.radius_m),
                              .age_years = static_cast<float>(tree.age_years),
                              .light_ratio = static_cast<float>(of_a_season(year, tree.light_ratio)),
                              .vitality = static_cast<float>(tree.vitality),
                              .stems = tree.stems});
    }
}

void record_dead_wood(const forest::Stand& stand, std::int32_t year, MemberYears& kept) {
    for (const forest::Snag& snag : stand.dead_wood().snags) {
        kept.dead_wood.push_back({.year = year,
                                  .species = static_cast<std::uint32_t>(forest::index_of(snag.species)),
                                  .x_m = snag.x_m,
                                  .y_m = snag.y_m,
                                  .thick_cm = static_cast<float>(diameter_left(snag) * snag.dbh_cm),
                                  .height_m = static_cast<float>(snag.height_m),
                                  .broken = snag.height_m < snag.tree_height_m ? 1U : 0U});
    }
    for (const forest::Log& log : stand.dead_wood().logs) {
        kept.dead_wood.push_back({.year = year,
                                  .species = static_cast<std::uint32_t>(forest::index_of(log.species)),
                                  .x_m = log.x_m,
                                  .y_m = log.y_m,
                                  .thick_cm = static_cast<float>(diameter_left(log) * log.thick_end_cm),
                                  .plan_m = static_cast<float>(exchange::plan_length_m(log, stand.grid())),
                                  .direction_rad = static_cast<float>(log.direction_rad)});
    }
}

void record_patches(const forest::Stand& stand, const forest::SpeciesTable& species, std::int32_t year,
                    MemberYears& kept) {
    constexpr double patches_pha = 10'000.0 / forest::patch_area_m2;
    const std::size_t first = kept.patches.size();
    for (std::uint32_t p = 0; p < stand.grid().size(); ++p) {
        kept.patches.push_back(
            {.year = year,
             .patch = p,
             .ground_light = static_cast<float>(of_a_season(year, stand.patch_states()[p].ground_light))});
    }
    for (const forest::Tree& tree : stand.trees()) {
        PatchRow& row = kept.patches[first + forest::index_of(tree.patch)];
        const double stems_pha = tree.stems * patches_pha;
        row.stems_pha += static_cast<float>(stems_pha);
        row.basal_area_m2pha += static_cast<float>(stems_pha * forest::basal_area_m2(tree.dbh_cm));
        row.volume_m3pha += static_cast<float>(
            stems_pha * forest::stem_volume_m3(species[tree.species].allometry, tree.dbh_cm, tree.height_m));
        row.top_height_m = std::max(row.top_height_m, static_cast<float>(tree.height_m));
        row.leaf_area_index +=
            static_cast<float>(tree.stems * tree.crown.leaf_area_m2 / forest::patch_area_m2);
    }
}

}  // namespace coupling::decades
