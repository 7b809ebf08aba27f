#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Where the seeds of one patch land, on the raster of patches; the shares add up to 1.
///
/// Density at a distance r (iLand): [(1 - k) / a1 exp(-r / a1) + k / a2 exp(-r / a2)] / (2 pi r), k the share
/// that animals carry. Cut at four lengths; what lands beyond stays on the mother's own patch, with what the
/// middles of the cells miss.
class SeedKernel {
public:
    explicit SeedKernel(const Seeds& seeds);

    /// Patches to either side that get seeds.
    [[nodiscard]] int reach() const { return reach_; }
    /// Share that lands on the patch that many columns and rows away; 0 beyond the reach.
    [[nodiscard]] double at(int columns, int rows) const;
    /// Shares of a row of patches, from `reach` columns to the west to `reach` to the east. Requires a row
    /// within reach.
    [[nodiscard]] std::span<const float> row(int rows) const;

private:
    int reach_ = 0;
    std::vector<float> shares_;
};

/// The kernel of some seeds. Each thread makes it when it first asks for it and keeps it, as every year asks
/// for the same ones.
const SeedKernel& kernel_of(const Seeds& seeds);

/// Crop of each species in a year, relative to that of a seed year: the same over the whole area. A seed year
/// has the probability 1 / mean interval [iLand].
std::vector<double> crops_of_year(const SpeciesTable& species, std::uint64_t seed, std::uint32_t replicate,
                                  int year);

/// Seed production of a species on each patch [0, 1]: leaf area of its seed trees, full from a leaf
/// area index of 3 on. Seed trees have the age for it and a light ratio of at least 0.25 [choice].
std::vector<float> seed_sources(const Stand& stand, const SpeciesTable& species, SpeciesId kind);

/// Spreads sources over the grid: what each patch gets.
std::vector<float> spread(const PatchGrid& grid, std::span<const float> sources, const SeedKernel& kernel);

/// Seeds that the wind and birds bring from outside the area.
struct SeedsFromOutside {
    double share = 0.02;               ///< [0, 1], of the species' fecundity [choice]
    std::vector<SpeciesId> species{};  ///< that the region has; empty = all of the table
};

/// Seedlings that seeds of a year could become, by species and patch [1/m2].
class SeedRain {
public:
    /// A share of the fecundity comes from outside the area, in the crop of the year [choice].
    SeedRain(const Stand& stand, const SpeciesTable& species, std::span<const double> crops,
             const SeedsFromOutside& outside);

    [[nodiscard]] double seedlings_pm2(SpeciesId species, PatchId patch) const {
        return by_species_[index_of(species)].empty()
                   ? background_pm2_[index_of(species)]
                   : background_pm2_[index_of(species)] +
                         static_cast<double>(by_species_[index_of(species)][index_of(patch)]) *
                             full_pm2_[index_of(species)];
    }

private:
    std::vector<std::vector<float>> by_species_;  ///< empty for species without seed trees
    std::vector<double> full_pm2_;                ///< under a full source in this year
    std::vector<double> background_pm2_;
};

}  // namespace forest
