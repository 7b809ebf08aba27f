#include "validation/engine/forest_cases/remeasured/trial.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>

#include "forest/climate/co2.hpp"
#include "forest/climate/summary.hpp"
#include "forest/start/starting_stand.hpp"
#include "forest/treatment/felling.hpp"

namespace coupling::validation::forest_cases::remeasured {
namespace {

/// A plane that rises against its aspect.
struct Plane {
    double east_mpm = 0.0;   ///< rise along x
    double north_mpm = 0.0;  ///< rise along y

    explicit Plane(const MeasuredStand& stand)
        : east_mpm{-std::tan(stand.slope.in_radians()) * std::sin(stand.aspect.in_radians())},
          north_mpm{-std::tan(stand.slope.in_radians()) * std::cos(stand.aspect.in_radians())} {}
    [[nodiscard]] double height_m(double x_m, double y_m) const { return east_mpm * x_m + north_mpm * y_m; }
};

forest::PatchGrid patches_of(const MeasuredStand& stand) {
    const config::GridFrame frame{
        .columns = static_cast<int>(std::lround(stand.width_m / forest::patch_side_m)),
        .rows = static_cast<int>(std::lround(stand.length_m / forest::patch_side_m)),
        .cell_width_m = forest::patch_side_m,
        .cell_height_m = forest::patch_side_m};
    std::vector<forest::Patch> patches(frame.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].cell = frame.cell_of(i);
        patches[i].ground_m = stand.elevation_m;  // one climate for the whole plot
        patches[i].slope = stand.slope;
        patches[i].aspect = stand.aspect;
        patches[i].soil = stand.soil;
    }
    return {frame, patches};
}

forest::Site site_of(const MeasuredStand& stand, const forest::PatchGrid& grid) {
    std::array<double, 12> daily_mjpm2{};
    for (int year = stand.first_year + 1; year <= stand.last_year; ++year) {
        for (std::size_t m = 0; m < daily_mjpm2.size(); ++m) {
            daily_mjpm2[m] += stand.climate.find(year)->months[m].radiation_mjpm2 / stand.years();
        }
    }
    forest::SkySettings settings;
    settings.latitude = stand.latitude;
    const forest::Sky sky{settings, forest::split_radiation(stand.latitude, daily_mjpm2)};
    const Plane plane{stand};
    forest::LightGround ground{.elevation_m = config::Raster<double>{grid.frame()},
                               .edges = forest::Edges::torus};
    for (std::size_t i = 0; i < grid.frame().size(); ++i) {
        const config::Cell cell = grid.frame().cell_of(i);
        ground.elevation_m.values[i] =
            plane.height_m(grid.frame().x_centre_m(cell.column), grid.frame().y_centre_m(cell.row));
    }
    ground.gain_x_m = plane.east_mpm * stand.width_m;
    ground.gain_y_m = plane.north_mpm * stand.length_m;
    return {grid, stand.latitude, {sky, ground, {forest::Horizon{}}}};
}

double mean_degree_days(const MeasuredStand& stand) {
    double sum = 0.0;
    for (int year = stand.first_year + 1; year <= stand.last_year; ++year) {
        sum += forest::degree_days(*stand.climate.find(year)) / stand.years();
    }
    return sum;
}

std::vector<forest::Tree> starting_trees(const MeasuredStand& stand, const forest::PatchGrid& grid,
                                         const forest::SpeciesTable& species, config::Warnings& warnings) {
    std::vector<forest::ListedTree> list;
    for (const MeasuredTree& tree : stand.trees) {
        list.push_back({.id = tree.id,
                        .x_m = tree.x_m,
                        .y_m = tree.y_m,
                        .species = tree.species,
                        .dbh_cm = tree.dbh_cm,
                        .height_m = tree.height_m,
                        .age_years = tree.age_years});
    }
    return forest::trees_from_list(list, grid, species, mean_degree_days(stand), warnings).trees;
}

void fell_in(forest::Stand& stand, const MeasuredStand& of, const forest::SpeciesTable& species,
             const forest::YearKey& key) {
    std::vector<std::size_t> picks;
    for (const MeasuredTree& tree : of.trees) {
        if (tree.felled == stand.year()) {
            if (const auto place = stand.find(forest::TreeId{tree.id})) {
                picks.push_back(*place);
            }
        }
    }
    static_cast<void>(forest::fell(stand, species, picks, {}, key.seed, key.replicate));
}

forest::Stand start_of(const MeasuredStand& of, const forest::PatchGrid& grid,
                       const forest::SpeciesTable& species, const forest::YearKey& key) {
    config::Warnings noted;  // once for all replicates, by notes_on_start
    forest::Stand stand{grid, species.size(), starting_trees(of, grid, species, noted), of.first_year};
    forest::OnPatches<forest::SaplingRecord> saplings{.records = of.saplings};
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        saplings.patches.push_back(forest::PatchId{i});
    }
    stand.add_cohorts(forest::cohorts_from_records({&saplings, 1}, key.seed, key.replicate));
    fell_in(stand, of, species, key);
    return stand;
}

Regrown end_of(const forest::Stand& stand, const MeasuredStand& of) {
    Regrown end;
    std::set<forest::TreeId> known;
    for (const MeasuredTree& tree : of.trees) {
        const forest::TreeId id{tree.id};
        const auto place = stand.find(id);
        end.end_dbh_cm.push_back(place ? std::optional{stand.trees()[*place].dbh_cm} : std::nullopt);
        known.insert(id);
    }
    for (const forest::Tree& tree : stand.trees()) {
        if (!known.contains(tree.id) && tree.dbh_cm >= of.least_dbh_cm) {
            for (std::uint32_t stem = 0; stem < tree.stems; ++stem) {
                end.ingrown.push_back({tree.species, tree.dbh_cm});
            }
        }
    }
    return end;
}

}  // namespace

std::vector<std::string> notes_on_start(const MeasuredStand& stand, const forest::SpeciesTable& species) {
    config::Warnings warnings;
    static_cast<void>(starting_trees(stand, patches_of(stand), species, warnings));
    return warnings.all();
}

Regrown regrow(const MeasuredStand& of, const forest::SpeciesTable& species,
               const forest::Parameters& parameters, const forest::YearKey& key) {
    const forest::PatchGrid grid = patches_of(of);
    const forest::Site site = site_of(of, grid);
    forest::Stand stand = start_of(of, grid, species, key);
    const forest::Co2Series co2 = forest::Co2Series::shipped();
    for (int year = of.first_year + 1; year <= of.last_year; ++year) {
        const forest::ClimateYear* const climate = of.climate.find(year);
        assert(climate != nullptr);
        const std::vector<forest::ClimateYear> weather(site.units().size(), *climate);
        static_cast<void>(grow_year(
            stand, site, species,
            {.units = weather, .co2_ppm = co2.ppm(year), .co2_response = parameters.processes.co2_response},
            parameters, key));
        fell_in(stand, of, species, key);
    }
    return end_of(stand, of);
}

}  // namespace coupling::validation::forest_cases::remeasured
