#include "coupling/assessments/today/figures/forest_today.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "forest/stand/patch.hpp"

namespace coupling {
namespace {

using forest::closing_dbh_cm;
using forest::dbh_class_cm;
using forest::patch_side_m;

/// How far from a stem the forest reaches [choice].
constexpr double forest_reach_m = 30.0;

bool is_living(const TreeRecord& tree) {
    return tree.stem.strength >= 1.0 && tree.stem.broken_at_m <= 0.0;
}

/// Cells of 10 m at multiples of 10 m over the map.
config::GridFrame patch_frame(const config::GridFrame& map) {
    config::GridFrame frame;
    frame.x_west_m = std::floor(map.x_west_m / patch_side_m) * patch_side_m;
    frame.y_south_m = std::floor(map.y_south_m / patch_side_m) * patch_side_m;
    frame.cell_width_m = patch_side_m;
    frame.cell_height_m = patch_side_m;
    frame.columns = static_cast<int>(std::ceil((map.x_east_m() - frame.x_west_m) / patch_side_m - 1e-9));
    frame.rows = static_cast<int>(std::ceil((map.y_north_m() - frame.y_south_m) / patch_side_m - 1e-9));
    return frame;
}

/// Cells that rocks cross without forest.
config::Raster<std::uint8_t> crossed_cells(const RunResults& results, const config::GridFrame& frame) {
    const config::Raster<float> passages = raster_of(raster_kind("Nr_passages"), results, Cover::bare);
    config::Raster<std::uint8_t> crossed{frame, 0};
    const auto mark = [&](double x_m, double y_m) {
        const config::Cell cell = frame.cell_at(x_m, y_m);
        if (frame.contains(cell)) {
            crossed.at(cell) = 1;
        }
    };
    for (std::size_t i = 0; i < passages.values.size(); ++i) {
        if (passages.values[i] > 0.0F) {
            const config::Cell cell = passages.frame.cell_of(i);
            mark(passages.frame.x_centre_m(cell.column), passages.frame.y_centre_m(cell.row));
        }
    }
    for (std::size_t i = 0; i < crossed.values.size(); ++i) {  // of maps with cells larger than 10 m
        const config::Cell cell = frame.cell_of(i);
        const config::Cell under =
            passages.frame.cell_at(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row));
        if (passages.frame.contains(under) && passages.at(under) > 0.0F) {
            crossed.values[i] = 1;
        }
    }
    return crossed;
}

/// Cells whose centre lies within reach of a stem.
config::Raster<std::uint8_t> cells_near_stems(const RunResults& results, const config::GridFrame& frame) {
    config::Raster<std::uint8_t> near{frame, 0};
    const int reach = static_cast<int>(forest_reach_m / patch_side_m) + 1;
    for (const TreeRecord& tree : results.site.trees) {
        if (!is_living(tree) || tree.stem.dbh_cm < closing_dbh_cm) {
            continue;
        }
        const config::Cell at = frame.cell_at(tree.stem.x_m, tree.stem.y_m);
        for (int row = at.row - reach; row <= at.row + reach; ++row) {
            for (int column = at.column - reach; column <= at.column + reach; ++column) {
                if (frame.contains({column, row}) &&
                    std::hypot(frame.x_centre_m(column) - tree.stem.x_m,
                               frame.y_centre_m(row) - tree.stem.y_m) <= forest_reach_m) {
                    near.at({column, row}) = 1;
                }
            }
        }
    }
    return near;
}

/// Heights at the centres of cells; NaN without ground.
config::Raster<double> ground_of(const Site& site, const config::GridFrame& frame) {
    config::Raster<double> ground{frame, std::numeric_limits<double>::quiet_NaN()};
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const config::Cell under =
            site.heights.frame.cell_at(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row));
        if (site.heights.frame.contains(under)) {
            ground.values[i] = site.heights.at(under);
        }
    }
    return ground;
}

/// Rise from one neighbour to the other along a side, per metre.
double rise(const config::Raster<double>& ground, config::Cell cell, int columns, int rows) {
    const auto height_m = [&](int sign) {
        const config::Cell next{cell.column + sign * columns, cell.row + sign * rows};
        const double found = ground.frame.contains(next) ? ground.at(next) : ground.at(cell);
        return std::isnan(found) ? ground.at(cell) : found;
    };
    return (height_m(1) - height_m(-1)) / (2.0 * patch_side_m);
}

forest::Patch patch_at(const config::Raster<double>& ground, config::Cell cell) {
    const double per_east = rise(ground, cell, 1, 0);
    const double per_north = rise(ground, cell, 0, -1);
    forest::Patch patch;
    patch.cell = cell;
    patch.ground_m = ground.at(cell);
    patch.slope = config::Angle::from_radians(std::atan(std::hypot(per_east, per_north)));
    const double aspect_rad = std::atan2(-per_east, -per_north);
    patch.aspect =
        config::Angle::from_radians(aspect_rad < 0.0 ? aspect_rad + 2.0 * std::numbers::pi : aspect_rad);
    return patch;
}

forest::PatchGrid forest_grid(const RunResults& results) {
    const config::GridFrame frame = patch_frame(results.site.map_frame);
    const config::Raster<std::uint8_t> crossed = crossed_cells(results, frame);
    const config::Raster<std::uint8_t> near = cells_near_stems(results, frame);
    const config::Raster<double> ground = ground_of(results.site, frame);
    std::vector<forest::Patch> patches;
    for (std::size_t i = 0; i < crossed.values.size(); ++i) {
        if (crossed.values[i] != 0 && near.values[i] != 0 && !std::isnan(ground.values[i])) {
            patches.push_back(patch_at(ground, frame.cell_of(i)));
        }
    }
    return {frame, std::move(patches)};
}

/// Sums over the stems on the area, in m2 and stems.
struct StemSums {
    std::uint64_t stems = 0;
    std::uint64_t from_12_cm = 0;
    double basal_area_m2 = 0.0;
    std::map<std::string, std::pair<std::uint64_t, double>> by_species;
    std::vector<std::uint64_t> by_class;
    std::vector<char> open;  ///< a mark for each patch without a stem of 12 cm
};

StemSums sums_over(const RunResults& results, const forest::PatchGrid& grid) {
    StemSums sums;
    sums.open.assign(grid.size(), 1);
    for (const TreeRecord& tree : results.site.trees) {
        const auto patch = grid.at(tree.stem.x_m, tree.stem.y_m);
        if (!patch || !is_living(tree)) {
            continue;
        }
        const double dbh_m = 0.01 * tree.stem.dbh_cm;
        const double basal_area_m2 = 0.25 * std::numbers::pi * dbh_m * dbh_m;
        const auto place = static_cast<std::size_t>(tree.stem.dbh_cm / dbh_class_cm);
        sums.by_class.resize(std::max(sums.by_class.size(), place + 1));
        ++sums.by_class[place];
        ++sums.stems;
        sums.basal_area_m2 += basal_area_m2;
        auto& [stems, area_m2] = sums.by_species[tree.species];
        ++stems;
        area_m2 += basal_area_m2;
        if (tree.stem.dbh_cm >= closing_dbh_cm) {
            ++sums.from_12_cm;
            sums.open[forest::index_of(*patch)] = 0;
        }
    }
    return sums;
}

/// Stems from a diameter on; limits of profiles fall on borders of classes.
double stems_from(const ForestToday& found, double dbh_cm) {
    double stems_pha = 0.0;
    for (auto place = static_cast<std::size_t>(dbh_cm / dbh_class_cm);
         place < found.stems_pha_by_class.size(); ++place) {
        stems_pha += found.stems_pha_by_class[place];
    }
    return stems_pha;
}

void hold_against_profile(const RunResults& results, ForestToday& found) {
    found.mean_block_m =
        rockfall::diameter_range(start_law(results.scenario.release), results.site.sources).mean_m;
    found.profile = forest::target_profile(found.mean_block_m);
    if (found.profile) {
        const double stems_pha = stems_from(found, found.profile->dbh_from_cm);
        found.check = {.stems_pha = stems_pha,
                       .gap_m = found.gaps.max_m,
                       .has_stems = stems_pha >= found.profile->least_stems_pha,
                       .has_ideal_stems = stems_pha >= found.profile->ideal_stems_pha,
                       .has_short_gaps = found.gaps.max_m <= found.profile->longest_gap_m};
    }
}

}  // namespace

std::optional<ForestToday> forest_today(const RunResults& results) {
    if (!results.with_forest || results.site.trees.empty()) {
        return std::nullopt;
    }
    const forest::PatchGrid grid = forest_grid(results);
    const StemSums sums = sums_over(results, grid);
    if (sums.stems == 0) {
        return std::nullopt;
    }
    ForestToday found;
    found.area_ha = grid.area_ha();
    const double per_ha = 1.0 / found.area_ha;
    found.stems = sums.stems;
    found.stems_pha = per_ha * static_cast<double>(sums.stems);
    found.stems_from_12_cm_pha = per_ha * static_cast<double>(sums.from_12_cm);
    found.basal_area_m2pha = per_ha * sums.basal_area_m2;
    found.mean_dbh_cm =
        100.0 * std::sqrt(4.0 / std::numbers::pi * sums.basal_area_m2 / static_cast<double>(sums.stems));
    for (const auto& [code, of] : sums.by_species) {
        found.species.push_back({code, per_ha * static_cast<double>(of.first), per_ha * of.second});
    }
    std::stable_sort(found.species.begin(), found.species.end(),
                     [](const ForestToday::Species& a, const ForestToday::Species& b) {
                         return a.basal_area_m2pha > b.basal_area_m2pha;
                     });
    for (const std::uint64_t stems : sums.by_class) {
        found.stems_pha_by_class.push_back(per_ha * static_cast<double>(stems));
    }
    found.gaps = forest::figures_of(grid, sums.open, forest::gaps_along_fall_line(grid, sums.open),
                                    [](const forest::Patch&) { return true; });
    hold_against_profile(results, found);
    return found;
}

}  // namespace coupling
