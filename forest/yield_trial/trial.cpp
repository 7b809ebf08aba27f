#include "forest/yield_trial/trial.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "forest/allometry.hpp"
#include "forest/crown.hpp"
#include "forest/growth.hpp"
#include "forest/layer_light.hpp"
#include "forest/production/allocation.hpp"
#include "forest/self_thinning.hpp"

namespace forest {

namespace {

constexpr int hectare_patches = 10;  // along each side
constexpr std::uint32_t replicate = 0;

PatchGrid level_hectare(const YieldTrial& trial) {
    const config::GridFrame frame{.columns = hectare_patches,
                                  .rows = hectare_patches,
                                  .cell_width_m = patch_side_m,
                                  .cell_height_m = patch_side_m};
    std::vector<Patch> patches(frame.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].cell = frame.cell_of(i);
        patches[i].soil.fertility = trial.fertility;
        patches[i].soil.ph = trial.ph;
    }
    return {frame, patches};
}

Stand plantation(const YieldTrial& trial, const SpeciesTable& species) {
    PatchGrid grid = level_hectare(trial);
    const Species& kind = species[trial.species];
    std::vector<Tree> trees(static_cast<std::size_t>(std::lround(trial.stems_pha)));
    for (std::size_t i = 0; i < trees.size(); ++i) {
        config::RandomStream stream{{trial.seed, replicate, 0, i}, config::Purpose::starting_tree};
        Tree& tree = trees[i];
        tree.id = TreeId{i};
        tree.species = trial.species;
        tree.x_m = stream.uniform() * grid.frame().x_east_m();
        tree.y_m = (1.0 - stream.uniform()) * grid.frame().y_north_m();
        const double around =
            std::clamp(config::normal(stream.uniform(), 1.0, trial.start_scatter), 0.5, 1.5);
        tree.dbh_cm = trial.start_dbh_cm * around;
        tree.height_m = std::max(1.4, kind.saplings.height_to_diameter * tree.dbh_cm / 100.0);
        tree.age_years = trial.start_age_years;
        tree.crown = starting_crown(kind, tree.dbh_cm, tree.height_m);
        tree.above_ground_kg =
            part_masses(kind.allometry, tree.dbh_cm, tree.height_m, tree.crown.completeness)
                .above_ground_kg();
    }
    return {std::move(grid), species.size(), std::move(trees), 0};
}

/// What the trees have to grow with when light goes by layers.
std::vector<TreeSeason> seasons_in_layers(Stand& stand, const YieldTrial& trial, const TrialYear& weather,
                                          const SpeciesTable& species) {
    const std::span<const Tree> trees = stand.trees();
    const std::vector<LayerLight> light = layer_light(trees, species, stand.grid().area_m2());
    std::vector<double> ratios(trees.size());
    std::vector<AbsorbedByMonth> absorbed(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        ratios[i] = light[i].light_ratio;
        for (std::size_t m = 0; m < absorbed[i].size(); ++m) {
            const bool in_leaf = species[trees[i].species].light.in_leaf(static_cast<int>(m) + 1);
            absorbed[i][m] = in_leaf ? light[i].absorbed_m2 * weather.radiation_mjpm2[m] : 0.0;
        }
    }
    stand.set_light_ratios(ratios);

    const Species& kind = species[trial.species];
    const std::vector<std::uint32_t> one_unit(trees.size(), 0);
    std::vector<YearOfLightUse> light_use(species.size());
    light_use[index_of(trial.species)] = light_use_of_year(kind, weather.months, trial.fertility, trial.ph);
    const std::vector<TreeProduction> production =
        share_production(trees, species, absorbed, one_unit, light_use);
    std::vector<TreeSeason> seasons(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        seasons[i] = {
            .npp_kg = production[i].npp_kg,
            .root_share = root_share(kind.three_pg.root_share, production[i].physiology, trial.fertility),
            .degree_days = weather.degree_days,
            .shaded_below_m = light[i].shaded_below_m};
    }
    return seasons;
}

void let_die(Stand& stand, const YieldTrial& trial, const SpeciesTable& species,
             const ThinningWindows& windows) {
    const MortalityLaw law{
        .stress_death = trial.stress_death, .stress_death_by_class = 0.0, .background = false};
    const std::vector<std::uint32_t> one_unit(stand.trees().size(), 0);
    stand.set_stress_years(stress_years_after(stand, law, one_unit, 1));
    stand.remove_trees(natural_deaths(stand, species, law, trial.seed, replicate));
    stand.remove_trees(self_thinning(stand, species, windows, trial.seed, replicate));
}

}  // namespace

std::vector<TrialState> grow_in_layers(const YieldTrial& trial, const SpeciesTable& species,
                                       std::span<const int> ages_years) {
    assert(!trial.weather.empty());
    Stand stand = plantation(trial, species);
    const ThinningWindows windows{stand.grid()};
    std::vector<TrialState> states;
    int age_years = trial.start_age_years;
    for (const int wanted : ages_years) {
        for (; age_years < wanted; ++age_years) {
            const auto place = static_cast<std::size_t>(age_years) % trial.weather.size();
            stand.begin_year();
            stand.grow(growth_of_trees(stand, species,
                                       seasons_in_layers(stand, trial, trial.weather[place], species)));
            let_die(stand, trial, species, windows);
        }
        states.push_back({wanted, figures_of(stand.trees(), species, stand.grid().area_ha())});
    }
    return states;
}

}  // namespace forest
