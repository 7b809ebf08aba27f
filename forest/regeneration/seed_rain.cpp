#include "forest/regeneration/seed_rain.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <tuple>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"

namespace forest {

namespace {

constexpr double cut_lengths = 4.0;
constexpr double least_light_of_seed_trees = 0.25;
constexpr double full_leaf_area_index = 4.5;

double exponential_density_pm2(double distance_m, double length_m) {
    return config::exp_of(-distance_m / length_m) / (length_m * 2.0 * std::numbers::pi * distance_m);
}

/// Seeds that land at a distance, per area and seed.
double density_pm2(const Seeds& seeds, double distance_m) {
    const double wind = exponential_density_pm2(distance_m, seeds.kernel_m);
    if (seeds.long_share <= 0.0 || seeds.long_kernel_m <= 0.0) {
        return wind;
    }
    const double animals = exponential_density_pm2(distance_m, seeds.long_kernel_m);
    return (1.0 - seeds.long_share) * wind + seeds.long_share * animals;
}

}  // namespace

SeedKernel::SeedKernel(const Seeds& seeds) {
    const double longest_m =
        seeds.long_share > 0.0 ? std::max(seeds.kernel_m, seeds.long_kernel_m) : seeds.kernel_m;
    const double cut_m = cut_lengths * longest_m;
    reach_ = static_cast<int>(std::floor(cut_m / patch_side_m));
    const auto width = static_cast<std::size_t>(2 * reach_ + 1);
    shares_.assign(width * width, 0.0F);

    double elsewhere = 0.0;
    for (int rows = -reach_; rows <= reach_; ++rows) {
        for (int columns = -reach_; columns <= reach_; ++columns) {
            const double distance_m =
                patch_side_m * std::sqrt(static_cast<double>(rows * rows + columns * columns));
            if (distance_m == 0.0 || distance_m > cut_m) {
                continue;
            }
            const double share = density_pm2(seeds, distance_m) * patch_area_m2;
            shares_[static_cast<std::size_t>(rows + reach_) * width +
                    static_cast<std::size_t>(columns + reach_)] = static_cast<float>(share);
            elsewhere += share;
        }
    }
    // Kernels shorter than a patch would put more on the neighbours' middles than there is.
    const double scale = std::min(1.0, 1.0 / elsewhere);
    if (scale < 1.0) {
        for (float& share : shares_) {
            share = static_cast<float>(share * scale);
        }
    }
    shares_[width * width / 2] = static_cast<float>(std::max(0.0, 1.0 - elsewhere));
}

double SeedKernel::at(int columns, int rows) const {
    if (std::abs(columns) > reach_ || std::abs(rows) > reach_) {
        return 0.0;
    }
    return static_cast<double>(row(rows)[static_cast<std::size_t>(columns + reach_)]);
}

std::span<const float> SeedKernel::row(int rows) const {
    assert(std::abs(rows) <= reach_);
    const auto width = static_cast<std::size_t>(2 * reach_ + 1);
    return std::span{shares_}.subspan(static_cast<std::size_t>(rows + reach_) * width, width);
}

const SeedKernel& kernel_of(const Seeds& seeds) {
    using Key = std::tuple<double, double, double>;
    thread_local std::map<Key, SeedKernel> made;
    const Key key{seeds.kernel_m, seeds.long_kernel_m, seeds.long_share};
    const auto found = made.find(key);
    return found != made.end() ? found->second : made.emplace(key, SeedKernel{seeds}).first->second;
}

std::vector<double> crops_of_year(const SpeciesTable& species, std::uint64_t seed, std::uint32_t replicate,
                                  int year) {
    std::vector<double> crops;
    for (std::size_t s = 0; s < species.size(); ++s) {
        const Seeds& seeds = species.all()[s].seeds;
        config::RandomStream stream{{seed, replicate, static_cast<std::uint16_t>(year), s},
                                    config::Purpose::seed_year};
        crops.push_back(stream.uniform() * seeds.interval_years < 1.0 ? 1.0 : seeds.other_years_share);
    }
    return crops;
}

std::vector<float> seed_sources(const Stand& stand, const SpeciesTable& species, SpeciesId kind) {
    std::vector<double> leaves_m2(stand.grid().size(), 0.0);
    for (const Tree& tree : stand.trees()) {
        if (tree.species == kind && tree.age_years >= species[kind].seeds.maturity_years &&
            tree.light_ratio >= least_light_of_seed_trees) {
            leaves_m2[index_of(tree.patch)] += tree.stems * tree.crown.leaf_area_m2;
        }
    }
    std::vector<float> sources(leaves_m2.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        sources[i] = static_cast<float>(std::min(1.0, leaves_m2[i] / (patch_area_m2 * full_leaf_area_index)));
    }
    return sources;
}

std::vector<float> spread(const PatchGrid& grid, std::span<const float> sources, const SeedKernel& kernel) {
    assert(sources.size() == grid.size());
    const config::GridFrame& frame = grid.frame();
    const int reach = kernel.reach();
    config::Raster<float> fallen{frame, 0.0F};
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (sources[i] == 0.0F) {
            continue;
        }
        const config::Cell from = grid.patches()[i].cell;
        const int west = std::max(0, from.column - reach);
        const int east = std::min(frame.columns - 1, from.column + reach);
        const int last_row = std::min(frame.rows - 1, from.row + reach);
        for (int row = std::max(0, from.row - reach); row <= last_row; ++row) {
            // Plain pointers over one row of both, which the compiler can add several cells at a time.
            const float* share = kernel.row(row - from.row).data() + (west - from.column + reach);
            float* cell = &fallen.at({west, row});
            const float source = sources[i];
            const int count = east - west + 1;
            for (int k = 0; k < count; ++k) {
                cell[k] += source * share[k];
            }
        }
    }
    std::vector<float> on_patches(grid.size());
    for (std::size_t i = 0; i < on_patches.size(); ++i) {
        on_patches[i] = fallen.at(grid.patches()[i].cell);
    }
    return on_patches;
}

SeedRain::SeedRain(const Stand& stand, const SpeciesTable& species, std::span<const double> crops,
                   const SeedsFromOutside& outside)
    : by_species_(species.size()), full_pm2_(species.size()), background_pm2_(species.size()) {
    assert(crops.size() == species.size());
    for (std::size_t s = 0; s < species.size(); ++s) {
        const SpeciesId kind{static_cast<std::uint16_t>(s)};
        full_pm2_[s] = species[kind].seeds.seedlings_pm2 * crops[s];
        const bool in_region =
            outside.species.empty() ||
            std::find(outside.species.begin(), outside.species.end(), kind) != outside.species.end();
        background_pm2_[s] = in_region ? full_pm2_[s] * outside.share : 0.0;
        const std::vector<float> sources = seed_sources(stand, species, kind);
        if (std::any_of(sources.begin(), sources.end(), [](float source) { return source > 0.0F; })) {
            by_species_[s] = spread(stand.grid(), sources, kernel_of(species[kind].seeds));
        }
    }
}

}  // namespace forest
