#include "validation/engine/forest_cases/yield_trial/trial.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "forest/stand/self_thinning.hpp"
#include "forest/start/starting_stand.hpp"
#include "forest/year.hpp"
#include "validation/engine/forest_cases/shared/level_forest.hpp"

namespace coupling::validation::forest_cases::yield_trial {

namespace {

using forest::ClimateYear;
using forest::PatchGrid;
using forest::PatchId;
using forest::Site;
using forest::SpeciesTable;
using forest::Stand;
using forest::StandFigures;
using forest::Tree;

constexpr int hectare_patches = 10;  // along each side
constexpr std::uint32_t replicate = 0;

std::vector<Tree> starting_trees(const YieldTrial& trial, const SpeciesTable& species,
                                 const PatchGrid& grid) {
    forest::StandRecord record;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = trial.species,
                       .stems_pha = trial.start.stems_pha,
                       .mean_dbh_cm = trial.start.mean_dbh_cm,
                       .mean_height_m = trial.start.mean_height_m,
                       .age_years = trial.start.age_years}};
    return forest::trees_from_record(record, grid, species, trial.seed, replicate, 0);
}

/// Takes the thinnest trees until so many stems are left.
void thin_from_below(Stand& stand, double stems_pha) {
    const auto left = static_cast<std::size_t>(std::lround(stems_pha * stand.grid().area_ha()));
    std::vector<const Tree*> trees;
    std::size_t standing = 0;
    for (const Tree& tree : stand.trees()) {
        trees.push_back(&tree);
        standing += tree.stems;
    }
    std::sort(trees.begin(), trees.end(), [](const Tree* a, const Tree* b) {
        return a->dbh_cm != b->dbh_cm ? a->dbh_cm < b->dbh_cm : a->id < b->id;
    });
    std::vector<forest::Removal> felled;
    for (const Tree* const tree : trees) {
        if (standing <= left) {
            break;
        }
        const auto stems = static_cast<std::uint32_t>(std::min<std::size_t>(tree->stems, standing - left));
        felled.push_back({tree->id, forest::Cause::felled, stems});
        standing -= stems;
    }
    stand.remove_trees(felled);
}

/// Height of the tree of mean basal area: the mean of stems of nearly its diameter.
double mean_height_m(std::span<const Tree> trees, double mean_dbh_cm) {
    constexpr double near = 0.1;
    double stems = 0.0;
    double sum_m = 0.0;
    const Tree* nearest = nullptr;
    for (const Tree& tree : trees) {
        const double off = std::abs(tree.dbh_cm - mean_dbh_cm);
        if (off <= near * mean_dbh_cm) {
            stems += tree.stems;
            sum_m += tree.stems * tree.height_m;
        }
        if (nearest == nullptr || off < std::abs(nearest->dbh_cm - mean_dbh_cm)) {
            nearest = &tree;
        }
    }
    return stems > 0.0 ? sum_m / stems : nearest != nullptr ? nearest->height_m : 0.0;
}

double dominant_dbh_cm(std::span<const Tree> trees, double area_ha) {
    std::vector<double> dbh_cm;
    for (const Tree& tree : trees) {
        dbh_cm.insert(dbh_cm.end(), tree.stems, tree.dbh_cm);
    }
    std::sort(dbh_cm.begin(), dbh_cm.end(), std::greater<>{});
    dbh_cm.resize(std::min(dbh_cm.size(), static_cast<std::size_t>(std::lround(100.0 * area_ha))));
    double sum_cm = 0.0;
    for (const double one_cm : dbh_cm) {
        sum_cm += one_cm;
    }
    return dbh_cm.empty() ? 0.0 : sum_cm / static_cast<double>(dbh_cm.size());
}

TrialState state_of(const Stand& stand, const SpeciesTable& species, int age_years) {
    const double area_ha = stand.grid().area_ha();
    TrialState state{.age_years = age_years,
                     .figures = forest::figures_of(stand.trees(), species, area_ha),
                     .mean_height_m = 0.0,
                     .dominant_slenderness = 0.0};
    state.mean_height_m = mean_height_m(stand.trees(), state.figures.mean_dbh_cm);
    const double thick_cm = dominant_dbh_cm(stand.trees(), area_ha);
    state.dominant_slenderness = thick_cm > 0.0 ? 100.0 * state.figures.dominant_height_m / thick_cm : 0.0;
    return state;
}

void note_density(const Stand& stand, const forest::Mortality& law, TrialRun& run) {
    constexpr double judged_dbh_cm = 25.0;
    double stems = 0.0;
    double squares_cm2 = 0.0;
    for (const Tree& tree : stand.trees()) {
        if (tree.dbh_cm >= forest::counted_dbh_cm) {
            stems += tree.stems;
            squares_cm2 += tree.stems * tree.dbh_cm * tree.dbh_cm;
        }
    }
    if (stems == 0.0) {
        return;
    }
    const double mean_dbh_cm = std::sqrt(squares_cm2 / stems);
    const double density = stems / stand.grid().area_ha() / forest::most_stems_pha(law, mean_dbh_cm);
    run.greatest_density = std::max(run.greatest_density, density);
    if (mean_dbh_cm >= judged_dbh_cm && !run.density_at_25cm) {
        run.density_at_25cm = density;
    }
}

}  // namespace

TrialRun grow_trial(const YieldTrial& trial, const SpeciesTable& species, std::span<const int> ages_years) {
    assert(!trial.weather.empty());
    PatchGrid grid = level_patches(hectare_patches, trial.soil);
    const Site site = level_site(grid, trial.latitude, trial.weather);
    std::vector<Tree> trees = starting_trees(trial, species, grid);
    Stand stand{std::move(grid), species.size(), std::move(trees), 0};

    TrialRun run;
    int age_years = trial.start.age_years;
    const auto treat = [&] {
        for (const Thinning& thinning : trial.thinnings) {
            if (thinning.age_years == age_years) {
                thin_from_below(stand, thinning.stems_pha);
            }
        }
    };
    for (const int wanted : ages_years) {
        for (; age_years < wanted;) {
            const auto past_years = static_cast<std::size_t>(age_years - trial.start.age_years);
            const std::vector<ClimateYear> weather(site.units().size(),
                                                   trial.weather[past_years % trial.weather.size()]);
            static_cast<void>(forest::grow_year(stand, site, species, {.units = weather}, trial.parameters,
                                                {trial.seed, replicate}));
            ++age_years;
            treat();
            note_density(stand, species[trial.species].mortality, run);
        }
        run.states.push_back(state_of(stand, species, wanted));
    }
    return run;
}

}  // namespace coupling::validation::forest_cases::yield_trial
