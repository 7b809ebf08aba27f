#include "forest/treatment/young.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

#include "config/random/stream.hpp"

namespace forest {

namespace {

constexpr std::uint32_t cluster_stems = 25;
constexpr double m2_per_ha = 10'000.0;

Cohort planted(PatchId patch, const Planting& planting, std::uint32_t stems) {
    return {.patch = patch,
            .species = planting.species,
            .origin = Origin::planted,
            .stems = stems,
            .height_m = planting.height_m,
            .guarded_years = static_cast<std::uint16_t>(planting.guarded_years)};
}

std::uint64_t add(Stand& stand, const std::vector<Cohort>& plants) {
    std::uint64_t stems = 0;
    for (const Cohort& cohort : plants) {
        stems += cohort.stems;
    }
    stand.add_cohorts(plants);
    return stems;
}

bool is_favoured(const Tending& tending, SpeciesId species) {
    return std::find(tending.favoured.begin(), tending.favoured.end(), species) != tending.favoured.end();
}

}  // namespace

std::vector<double> young_trees_pha(const Stand& stand) {
    std::vector<double> young_pha(stand.grid().size(), 0.0);
    for (const Cohort& cohort : stand.cohorts()) {
        if (cohort.height_m >= established_height_m) {
            young_pha[index_of(cohort.patch)] += cohort.stems * m2_per_ha / patch_area_m2;
        }
    }
    for (const Tree& tree : stand.trees()) {
        if (tree.dbh_cm < young_dbh_cm) {
            young_pha[index_of(tree.patch)] += tree.stems * m2_per_ha / patch_area_m2;
        }
    }
    return young_pha;
}

std::vector<PatchId> patches_with_fewer(const Stand& stand, const TreatmentArea& area, double young_pha) {
    const std::vector<double> present_pha = young_trees_pha(stand);
    std::vector<PatchId> patches = patches_in(stand.grid(), area);
    std::erase_if(patches, [&](PatchId patch) { return present_pha[index_of(patch)] >= young_pha; });
    return patches;
}

std::uint64_t plant_on(Stand& stand, std::span<const PatchId> patches, const Planting& planting,
                       std::uint64_t seed, std::uint32_t replicate) {
    assert(planting.height_m > 0.0 && planting.stems_pha > 0.0);
    std::vector<Cohort> plants;
    for (const PatchId patch : patches) {
        const double u =
            config::RandomStream{{seed, replicate, static_cast<std::uint16_t>(stand.year()), index_of(patch)},
                                 config::Purpose::young_place}
                .uniforms_of(0xFFFFFF)[index_of(planting.species) % 4];
        const auto stems = static_cast<std::uint32_t>(planting.stems_pha * patch_area_m2 / m2_per_ha + u);
        if (stems > 0) {
            plants.push_back(planted(patch, planting, stems));
        }
    }
    return add(stand, plants);
}

std::uint64_t plant(Stand& stand, const TreatmentArea& area, const Planting& planting, std::uint64_t seed,
                    std::uint32_t replicate) {
    return plant_on(stand, patches_in(stand.grid(), area), planting, seed, replicate);
}

std::uint64_t plant_clusters(Stand& stand, const TreatmentArea& area, const Planting& planting,
                             int every_patches) {
    return plant_clusters_on(stand, patches_in(stand.grid(), area), planting, every_patches);
}

std::uint64_t plant_clusters_on(Stand& stand, std::span<const PatchId> patches, const Planting& planting,
                                int every_patches) {
    assert(every_patches >= 1);
    std::vector<Cohort> plants;
    for (const PatchId patch : patches) {
        const config::Cell cell = stand.grid()[patch].cell;
        if (cell.row % every_patches == 0 && cell.column % every_patches == 0) {
            plants.push_back(planted(patch, planting, cluster_stems));
        }
    }
    return add(stand, plants);
}

TendingDone tend(Stand& stand, const TreatmentArea& area, const Tending& tending) {
    const auto in_heights = [&](double height_m) {
        return height_m >= tending.from_height_m && height_m <= tending.to_height_m;
    };
    std::vector<char> in_area(stand.grid().size(), 0);
    for (const PatchId patch : patches_in(stand.grid(), area)) {
        in_area[index_of(patch)] = 1;
    }
    std::vector<char> has_favoured(stand.grid().size(), 0);
    for (const Cohort& cohort : stand.cohorts()) {
        if (is_favoured(tending, cohort.species) && in_heights(cohort.height_m)) {
            has_favoured[index_of(cohort.patch)] = in_area[index_of(cohort.patch)];
        }
    }
    for (const Tree& tree : stand.trees()) {
        if (is_favoured(tending, tree.species) && in_heights(tree.height_m)) {
            has_favoured[index_of(tree.patch)] = in_area[index_of(tree.patch)];
        }
    }

    TendingDone done;
    std::vector<char> is_tended(stand.grid().size(), 0);
    const auto note = [&](PatchId patch, std::uint32_t stems) {
        done.stems += stems;
        done.area_ha += is_tended[index_of(patch)] == 0 ? patch_area_m2 / 10'000.0 : 0.0;
        is_tended[index_of(patch)] = 1;
    };
    const auto share_of = [&](std::uint32_t stems) {
        return static_cast<std::uint32_t>(tending.cut_share * stems + 0.5);
    };
    std::vector<SaplingRemoval> saplings;
    for (std::size_t i = 0; i < stand.cohorts().size(); ++i) {
        const Cohort& cohort = stand.cohorts()[i];
        const std::uint32_t stems = share_of(cohort.stems);
        if (has_favoured[index_of(cohort.patch)] != 0 && !is_favoured(tending, cohort.species) &&
            in_heights(cohort.height_m) && stems > 0) {
            saplings.push_back({i, stems, Cause::felled});
            note(cohort.patch, stems);
        }
    }
    std::vector<Removal> trees;
    for (const Tree& tree : stand.trees()) {
        const std::uint32_t stems = share_of(tree.stems);
        if (has_favoured[index_of(tree.patch)] != 0 && !is_favoured(tending, tree.species) &&
            in_heights(tree.height_m) && stems > 0) {
            trees.push_back({tree.id, Cause::felled, stems});
            note(tree.patch, stems);
        }
    }
    stand.remove_saplings(saplings);
    stand.remove_trees(trees);
    return done;
}

double fence(Stand& stand, const TreatmentArea& area, int years) {
    assert(years >= 1 && years <= 1000);
    std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
    double fenced_ha = 0.0;
    for (const PatchId patch : patches_in(stand.grid(), area)) {
        PatchState& state = states[index_of(patch)];
        if (state.fenced_years < years) {
            state.fenced_years = static_cast<std::uint16_t>(years);
            fenced_ha += patch_area_m2 / m2_per_ha;
        }
    }
    stand.set_patch_states(states);
    return fenced_ha;
}

}  // namespace forest
