// One year of a small forest: what grew, what died, what became dead wood.
//
// For those who build on the library `bannwald_forest`: no files, no settings, nothing of the program.
// The exit code is 1 if the balance of the wood does not close.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "forest/start/starting_stand.hpp"
#include "forest/year.hpp"

using namespace forest;

/// Radiation of the months, mean of their days [MJ/m2].
constexpr std::array<double, 12> radiation_mjpm2{4, 7, 11, 15, 18, 19, 19, 16, 12, 8, 4, 3};

/// A usual year of the montane belt, made in code.
ClimateYear montane_year() {
    constexpr std::array<double, 12> degc{-4, -3, 1, 5, 10, 13, 15, 15, 11, 7, 1, -3};
    ClimateYear year{.year = 2025};
    for (std::size_t m = 0; m < 12; ++m) {
        year.months[m] = {.tmin_degc = degc[m] - 4.0,
                          .tmax_degc = degc[m] + 5.0,
                          .tave_degc = degc[m],
                          .prec_mm = 110.0,
                          .radiation_mjpm2 = radiation_mjpm2[m],
                          .vpd_kpa = 0.15 + 0.03 * std::max(0.0, degc[m]),
                          .frost_days = degc[m] < 0.0   ? 25.0
                                        : degc[m] < 5.0 ? 10.0
                                                        : 0.0};
    }
    return year;
}

int main() {
    // 1. The species that the program ships.
    const SpeciesTable species = SpeciesTable::shipped();

    // 2. The ground: a hectare in patches of 10 m on a slope of 30 degrees that faces south.
    const config::Angle slope = config::Angle::from_degrees(30.0);
    const config::GridFrame frame{.columns = 10, .rows = 10, .cell_width_m = 10.0, .cell_height_m = 10.0};
    config::Raster<double> heights{frame};
    std::vector<Patch> patches(frame.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].cell = frame.cell_of(i);
        patches[i].ground_m = 1000.0 - std::tan(slope.in_radians()) * patch_side_m * patches[i].cell.row;
        patches[i].slope = slope;
        patches[i].aspect = config::Angle::from_degrees(180.0);
        heights.values[i] = patches[i].ground_m;
    }
    const PatchGrid grid{frame, patches};

    // 3. The climate, and the sky: how light falls on the slope. Beyond the border stands the mirror image.
    const ClimateYear climate = montane_year();
    SkySettings sky;
    sky.latitude = config::Angle::from_degrees(47.0);
    const LightGround light_ground{.elevation_m = heights, .edges = Edges::mirror};
    const Sky zones{sky, split_radiation(sky.latitude, radiation_mjpm2)};
    const Site site{grid, sky.latitude, {zones, light_ground, {Horizon{}}}};

    // 4. The stand as an inventory has it: stems per hectare and mean diameter of each species.
    StandRecord record;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {
        {.species = species.find("Picea abies").value(), .stems_pha = 300, .mean_dbh_cm = 30},
        {.species = species.find("Abies alba").value(), .stems_pha = 200, .mean_dbh_cm = 25},
        {.species = species.find("Fagus sylvatica").value(), .stems_pha = 500, .mean_dbh_cm = 14}};
    record.degree_days = 1300.0;  // of a usual year; heights follow from it
    const YearKey key{.seed = 1, .replicate = 0};
    Stand stand{grid, species.size(), trees_from_record(record, grid, species, key.seed, key.replicate, 0),
                climate.year - 1};
    const double living_before_kg = stand.stem_mass_standing_kg();

    // 5. One year, with the same weather for all units of the site. The same key gives the same year.
    const std::vector<ClimateYear> weather(site.units().size(), climate);
    const YearReport report = grow_year(stand, site, species, {.units = weather}, Parameters{}, key);

    // 6. What grew. A tree holds the diameter growth of its last three years, latest first.
    std::printf("year %d, %.0f ha\nspecies            trees  growth_mm\n", stand.year(), grid.area_ha());
    std::vector<int> trees(species.size());
    std::vector<double> growth_mm(species.size());
    for (const Tree& tree : stand.trees()) {
        ++trees[index_of(tree.species)];
        growth_mm[index_of(tree.species)] += 10.0 * tree.increments_cm[0];
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
        if (trees[i] > 0) {
            std::printf("%-16s %7d %10.1f\n", species.all()[i].latin_name.c_str(), trees[i],
                        growth_mm[i] / trees[i]);
        }
    }
    std::printf("stems grew by %.1f m3\n", report.volume_increment_m3);

    // 7. What died.
    for (const DeadTree& dead : stand.deaths()) {
        std::printf("died of %s: %s of %.0f cm, %.0f m high\n", std::string{name_of(dead.cause)}.c_str(),
                    species[dead.tree.species].latin_name.c_str(), dead.tree.dbh_cm, dead.tree.height_m);
    }

    // 8. What must hold: the wood of stems, living and dead, is what was there, came, grew and left.
    const StandBalance& balance = stand.balance();
    const double living_kg =
        living_before_kg + balance.stem_in_kg + balance.stem_grown_kg - balance.all_stem_lost_kg();
    const double dead_kg = balance.dead_wood_in_kg - balance.all_dead_wood_out_kg();
    const double error_kg =
        std::abs(stand.stem_mass_standing_kg() - living_kg) + std::abs(stand.dead_wood_kg() - dead_kg);
    const bool is_right = balance.stem_grown_kg > 0.0 && error_kg < 1e-9 * living_kg;  // but for rounding
    std::printf("stems %.0f kg, grown %.0f kg, died %.0f kg, dead wood %.0f kg: %s\n",
                stand.stem_mass_standing_kg(), balance.stem_grown_kg, balance.all_stem_lost_kg(),
                stand.dead_wood_kg(), is_right ? "right" : "WRONG");
    return is_right ? 0 : 1;
}
