#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "config/random/stream.hpp"
#include "forest/start/starting_stand.hpp"
#include "forest/year.hpp"

namespace forest {

/// Square of forest on an even slope that faces south.
inline PatchGrid square_of_forest(int side, double slope_deg = 30.0) {
    const config::GridFrame frame{.columns = side, .rows = side, .cell_width_m = 10.0, .cell_height_m = 10.0};
    const config::Angle slope = config::Angle::from_degrees(slope_deg);
    std::vector<Patch> patches(frame.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].cell = frame.cell_of(i);
        patches[i].ground_m =
            1000.0 - std::tan(slope.in_radians()) * patch_side_m * (patches[i].cell.row + 0.5);
        patches[i].slope = slope;
        patches[i].aspect = config::Angle::from_degrees(180.0);
    }
    return {frame, patches};
}

/// A middling year of the montane belt.
inline ClimateYear montane_year() {
    constexpr std::array<double, 12> degc = {-4, -3, 1, 5, 10, 13, 15, 15, 11, 7, 1, -3};
    constexpr std::array<double, 12> radiation_mjpm2 = {4, 7, 11, 15, 18, 19, 19, 16, 12, 8, 4, 3};
    ClimateYear year;
    year.year = 2001;
    for (std::size_t m = 0; m < 12; ++m) {
        ClimateMonth& month = year.months[m];
        month.tave_degc = degc[m];
        month.tmin_degc = degc[m] - 4.0;
        month.tmax_degc = degc[m] + 5.0;
        month.prec_mm = 110.0;
        month.radiation_mjpm2 = radiation_mjpm2[m];
        month.vpd_kpa = 0.15 + 0.03 * std::max(0.0, degc[m]);
        month.frost_days = degc[m] < 0.0 ? 25.0 : degc[m] < 5.0 ? 10.0 : 0.0;
    }
    return year;
}

/// A site for a grid under the sky of the Alps; the same year everywhere.
struct SmallForest {
    explicit SmallForest(PatchGrid grid_in)
        : grid{std::move(grid_in)},
          site{grid, latitude(), light_frame(grid)},
          weather(site.units().size(), montane_year()) {}

    [[nodiscard]] YearReport grow(Stand& stand, std::uint64_t seed = 1) const {
        return grow_year(stand, site, species, {weather, 350.0, false}, parameters, {seed, 0});
    }

    static config::Angle latitude() { return config::Angle::from_degrees(47.0); }
    static LightFrame light_frame(const PatchGrid& grid) {
        config::Raster<double> heights{grid.frame(), 1000.0};
        for (const Patch& patch : grid.patches()) {
            heights.at(patch.cell) = patch.ground_m;
        }
        std::array<double, 12> radiation{};
        for (std::size_t m = 0; m < 12; ++m) {
            radiation[m] = montane_year().months[m].radiation_mjpm2;
        }
        SkySettings settings;
        settings.latitude = latitude();
        LightGround ground;
        ground.elevation_m = heights;
        ground.edges = Edges::mirror;
        return {Sky{settings, split_radiation(latitude(), radiation)}, ground, {Horizon{}}};
    }

    SpeciesTable species = SpeciesTable::shipped();
    PatchGrid grid;
    Site site;
    std::vector<ClimateYear> weather;
    Parameters parameters;
};

/// Spruce in two layers with beech and fir between, on all patches.
inline std::vector<Tree> mixed_stand(const SmallForest& forest, double stems_pha, std::uint64_t seed) {
    StandRecord record;
    for (std::uint32_t i = 0; i < forest.grid.size(); ++i) {
        record.patches.push_back(PatchId{i});
    }
    const auto kind = [&forest](const char* code) { return *forest.species.find(code); };
    record.species = {{.species = kind("piab"), .stems_pha = 0.3 * stems_pha, .mean_dbh_cm = 30.0},
                      {.species = kind("piab"), .stems_pha = 0.3 * stems_pha, .mean_dbh_cm = 12.0},
                      {.species = kind("fasy"), .stems_pha = 0.2 * stems_pha, .mean_dbh_cm = 15.0},
                      {.species = kind("abal"), .stems_pha = 0.2 * stems_pha, .mean_dbh_cm = 20.0}};
    record.degree_days = 1300.0;
    return trees_from_record(record, forest.grid, forest.species, seed, 0, 0);
}

/// Any trees: all species, sizes and crowns that can be, at random over the patches.
inline std::vector<Tree> any_trees(const PatchGrid& grid, const SpeciesTable& species, std::size_t count,
                                   std::uint64_t seed) {
    std::vector<Tree> trees;
    for (std::size_t i = 0; i < count; ++i) {
        config::RandomStream stream{{seed, 0, 0, i}, config::Purpose::test};
        const auto kind =
            SpeciesId{static_cast<std::uint16_t>(stream.uniform() * static_cast<double>(species.size()))};
        const HeightGrowth& limits = species[kind].height_growth;
        const auto patch =
            PatchId{static_cast<std::uint32_t>(stream.uniform() * static_cast<double>(grid.size()))};
        const double dbh_cm = 1.0 + stream.uniform() * stream.uniform() * (limits.max_dbh_cm - 1.0);
        const double height_m = 1.4 + stream.uniform() * std::min(dbh_cm, limits.max_height_m - 1.4);
        Tree tree = new_tree(species[kind], kind, grid.x_centre_m(patch) + 9.8 * (stream.uniform() - 0.5),
                             grid.y_centre_m(patch) + 9.8 * (stream.uniform() - 0.5), dbh_cm, height_m,
                             stream.uniform() * 300.0);
        tree.id = TreeId{i};
        tree.vitality = stream.uniform();
        tree.stems = dbh_cm < 5.0 ? 1 + static_cast<std::uint32_t>(stream.uniform() * 10.0) : 1;
        trees.push_back(tree);
    }
    return trees;
}

}  // namespace forest
