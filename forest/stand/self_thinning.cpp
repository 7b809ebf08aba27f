#include "forest/stand/self_thinning.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

/// Stems of one species in one window and the sum of their squared diameters.
struct Stems {
    double number = 0.0;
    double dbh2_cm2 = 0.0;
};

double relative_density(const Mortality& species, const Stems& stems, double area_ha) {
    if (stems.number < 0.5) {
        return 0.0;
    }
    const double mean_dbh_cm = std::sqrt(stems.dbh2_cm2 / stems.number);
    return stems.number / area_ha / most_stems_pha(species, mean_dbh_cm);
}

double relative_density(const SpeciesTable& species, std::span<const Stems> stems, double area_ha) {
    double density = 0.0;
    for (std::size_t s = 0; s < stems.size(); ++s) {
        density += relative_density(species.all()[s].mortality, stems[s], area_ha);
    }
    return density;
}

/// Stems by window and species, of the trees that `counts` takes.
template <class Counts>
std::vector<Stems> stems_by_window(const Stand& stand, const ThinningWindows& windows, Counts counts) {
    std::vector<Stems> stems(windows.size() * stand.species_count());
    for (const Tree& tree : stand.trees()) {
        if (counts(tree)) {
            Stems& sum =
                stems[windows.window_of(tree.patch) * stand.species_count() + index_of(tree.species)];
            sum.number += tree.stems;
            sum.dbh2_cm2 += tree.stems * tree.dbh_cm * tree.dbh_cm;
        }
    }
    return stems;
}

struct Ranked {
    double rank = 0.0;
    std::size_t window = 0;
    std::size_t tree = 0;  ///< place in the stand
};

/// The trees of overcrowded windows, window by window, the next to die first.
template <class Counts>
std::vector<Ranked> ranked_trees(const Stand& stand, const ThinningWindows& windows,
                                 const std::vector<char>& overcrowded, std::uint64_t seed,
                                 std::uint32_t replicate, Counts counts) {
    std::vector<Ranked> ranked;
    const std::span<const Tree> trees = stand.trees();
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const std::size_t window = windows.window_of(trees[i].patch);
        if (overcrowded[window] == 0 || !counts(trees[i])) {
            continue;
        }
        config::RandomStream stream{
            {seed, replicate, static_cast<std::uint16_t>(stand.year()), number_of(trees[i].id)},
            config::Purpose::tree_rank};
        ranked.push_back(
            {trees[i].increments_cm[0] * (1.0 + config::normal(stream.uniform(), 0.0, rank_scatter)), window,
             i});
    }
    std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
        return a.window != b.window ? a.window < b.window
               : a.rank != b.rank   ? a.rank < b.rank
                                    : a.tree < b.tree;
    });
    return ranked;
}

template <class Counts>
void thin(const Stand& stand, const SpeciesTable& species, const ThinningWindows& windows, std::uint64_t seed,
          std::uint32_t replicate, Counts counts, std::vector<Removal>& removals) {
    const std::size_t kinds = stand.species_count();
    std::vector<Stems> stems = stems_by_window(stand, windows, counts);
    const auto stems_in = [&](std::size_t window) { return std::span{stems}.subspan(window * kinds, kinds); };
    std::vector<double> density(windows.size());
    std::vector<char> overcrowded(windows.size(), 0);
    for (std::size_t w = 0; w < windows.size(); ++w) {
        density[w] = relative_density(species, stems_in(w), windows.area_ha(w));
        overcrowded[w] = density[w] > 1.0 ? 1 : 0;
    }
    for (const Ranked& next : ranked_trees(stand, windows, overcrowded, seed, replicate, counts)) {
        const Tree& tree = stand.trees()[next.tree];
        const Mortality& law = species[tree.species].mortality;
        Stems& own = stems_in(next.window)[index_of(tree.species)];
        std::uint32_t dying = 0;
        while (density[next.window] > 1.0 && dying < tree.stems) {
            ++dying;
            density[next.window] -= relative_density(law, own, windows.area_ha(next.window));
            own.number -= 1.0;
            own.dbh2_cm2 -= tree.dbh_cm * tree.dbh_cm;
            density[next.window] += relative_density(law, own, windows.area_ha(next.window));
        }
        if (dying > 0) {
            removals.push_back({tree.id, Cause::self_thinning, dying});
        }
    }
}

bool is_counted(const Tree& tree) {
    return tree.dbh_cm >= counted_dbh_cm;
}

}  // namespace

double most_stems_pha(const Mortality& species, double mean_dbh_cm) {
    return config::exp_of(species.thinning_intercept + species.thinning_slope * config::ln_of(mean_dbh_cm));
}

ThinningWindows::ThinningWindows(const PatchGrid& grid) : window_of_patch_(grid.size()) {
    constexpr int half_full = window_patches * window_patches / 2 + 1;
    const int across = (grid.frame().columns + window_patches - 1) / window_patches;
    const int down = (grid.frame().rows + window_patches - 1) / window_patches;
    const auto block_of = [across](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(across) +
               static_cast<std::size_t>(column);
    };
    std::vector<int> patches(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), 0);
    for (const Patch& patch : grid.patches()) {
        ++patches[block_of(patch.cell.column / window_patches, patch.cell.row / window_patches)];
    }

    // A block that is not half full joins the fullest of its four neighbours.
    std::vector<std::size_t> joined(patches.size());
    for (int row = 0; row < down; ++row) {
        for (int column = 0; column < across; ++column) {
            const std::size_t block = block_of(column, row);
            joined[block] = block;
            if (patches[block] >= half_full) {
                continue;
            }
            int fullest = half_full - 1;
            for (const auto& [dx, dy] :
                 std::array<std::pair<int, int>, 4>{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}}) {
                const int c = column + dx;
                const int r = row + dy;
                if (c >= 0 && c < across && r >= 0 && r < down && patches[block_of(c, r)] > fullest) {
                    fullest = patches[block_of(c, r)];
                    joined[block] = block_of(c, r);
                }
            }
        }
    }

    std::vector<std::uint32_t> window_of_block(patches.size(), 0);
    std::vector<char> seen(patches.size(), 0);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const config::Cell cell = grid.patches()[i].cell;
        const std::size_t block = joined[block_of(cell.column / window_patches, cell.row / window_patches)];
        if (seen[block] == 0) {
            seen[block] = 1;
            window_of_block[block] = static_cast<std::uint32_t>(areas_ha_.size());
            areas_ha_.push_back(0.0);
        }
        window_of_patch_[i] = window_of_block[block];
        areas_ha_[window_of_patch_[i]] += patch_area_m2 / 10'000.0;
    }
}

std::vector<double> window_basal_areas_m2pha(const Stand& stand, const ThinningWindows& windows) {
    std::vector<double> areas_m2pha(windows.size(), 0.0);
    for (const Tree& tree : stand.trees()) {
        if (is_counted(tree)) {
            areas_m2pha[windows.window_of(tree.patch)] += tree.stems * basal_area_m2(tree.dbh_cm);
        }
    }
    for (std::size_t w = 0; w < windows.size(); ++w) {
        areas_m2pha[w] /= windows.area_ha(w);
    }
    return areas_m2pha;
}

std::vector<double> larger_basal_areas_m2pha(const Stand& stand, const ThinningWindows& windows) {
    const std::span<const Tree> trees = stand.trees();
    std::vector<std::size_t> order(trees.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return trees[a].dbh_cm != trees[b].dbh_cm ? trees[a].dbh_cm > trees[b].dbh_cm : a < b;
    });
    std::vector<double> sums_m2(windows.size(), 0.0);
    std::vector<double> larger_m2pha(trees.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last < order.size() && trees[order[last]].dbh_cm == trees[order[first]].dbh_cm) {
            const std::size_t window = windows.window_of(trees[order[last]].patch);
            larger_m2pha[order[last++]] = sums_m2[window] / windows.area_ha(window);
        }
        for (; first < last; ++first) {
            const Tree& tree = trees[order[first]];
            if (is_counted(tree)) {
                sums_m2[windows.window_of(tree.patch)] += tree.stems * basal_area_m2(tree.dbh_cm);
            }
        }
    }
    return larger_m2pha;
}

std::vector<double> relative_densities(const Stand& stand, const SpeciesTable& species,
                                       const ThinningWindows& windows) {
    const std::vector<Stems> stems = stems_by_window(stand, windows, is_counted);
    std::vector<double> densities(windows.size());
    for (std::size_t w = 0; w < windows.size(); ++w) {
        densities[w] = relative_density(
            species, std::span{stems}.subspan(w * stand.species_count(), stand.species_count()),
            windows.area_ha(w));
    }
    return densities;
}

std::vector<Removal> self_thinning(const Stand& stand, const SpeciesTable& species,
                                   const ThinningWindows& windows, std::uint64_t seed,
                                   std::uint32_t replicate) {
    std::vector<Removal> removals;
    thin(stand, species, windows, seed, replicate, is_counted, removals);
    thin(
        stand, species, windows, seed, replicate, [](const Tree& tree) { return !is_counted(tree); },
        removals);
    return removals;
}

}  // namespace forest
