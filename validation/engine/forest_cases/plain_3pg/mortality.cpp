#include "validation/engine/forest_cases/plain_3pg/mortality.hpp"

#include <algorithm>
#include <cmath>

#include "forest/production/power.hpp"
#include "validation/engine/forest_cases/plain_3pg/sizes.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

constexpr double kg_per_t = 1000.0;

/// Foliage a species has, be it on the tree or to be grown again.
double& foliage_of(Stocks& stocks, bool leaves_off) {
    return leaves_off ? stocks.foliage_debt : stocks.foliage;
}

/// Takes a share of the mean tree's biomass for each part, `shares` times the share of trees.
void take(Stocks& stocks, double share_of_trees, const LostShares& shares, bool leaves_off) {
    double& foliage = foliage_of(stocks, leaves_off);
    foliage *= 1.0 - share_of_trees * shares.foliage;
    stocks.root *= 1.0 - share_of_trees * shares.root;
    stocks.stem *= 1.0 - share_of_trees * shares.stem;
    stocks.stems_pha *= 1.0 - share_of_trees;
}

void take_all(Stocks& stocks, bool leaves_off) {
    foliage_of(stocks, leaves_off) = 0.0;
    stocks.root = 0.0;
    stocks.stem = 0.0;
    stocks.stems_pha = 0.0;
}

void thin(SpeciesMonth& species, const Thinning& thinning, bool leaves_off) {
    Stocks& stocks = species.stocks;
    const double share = (stocks.stems_pha - thinning.stems_pha) / stocks.stems_pha;
    species.deaths.cut_pha = stocks.stems_pha - thinning.stems_pha;
    const LostShares shares{thinning.foliage, thinning.root, thinning.stem};
    // Thinning from above can ask for more than there is; then nothing is left, as in r3PG.
    if (share * std::max({shares.foliage, shares.root, shares.stem}) > 1.0) {
        take_all(stocks, leaves_off);
    } else {
        take(stocks, share, shares, leaves_off);
    }
}

}  // namespace

ThinningList::ThinningList(const Inputs& inputs)
    : due_(inputs.species.size()), next_(inputs.species.size(), 0) {
    for (std::size_t i = 0; i < inputs.species.size(); ++i) {
        for (const Thinning& thinning : inputs.thinnings) {
            if (thinning.species == inputs.species[i].species) {
                due_[i].push_back(thinning);
            }
        }
        std::stable_sort(due_[i].begin(), due_[i].end(),
                         [](const Thinning& a, const Thinning& b) { return a.age_years < b.age_years; });
    }
}

void ThinningList::thin(Stand& stand, const Inputs& inputs, int month) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        SpeciesMonth& species = stand.species[i];
        species.deaths.cut_pha = 0.0;
        if (next_[i] == due_[i].size() || species.age.years < due_[i][next_[i]].age_years) {
            continue;
        }
        const Thinning& thinning = due_[i][next_[i]++];
        if (species.stocks.stems_pha > thinning.stems_pha) {
            plain_3pg::thin(species, thinning, dormant(inputs.parameters[i], month));
            stand.sizes_outdated = true;
        }
    }
}

void die_at_random(Stand& stand, const Inputs& inputs, int month) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        SpeciesMonth& species = stand.species[i];
        species.deaths.random_pha = 0.0;
        if (species.age.random_mortality <= 0.0 || dormant(inputs.parameters[i], month)) {
            continue;
        }
        constexpr double months_times_percent = 1200.0;
        const double share = std::min(species.age.random_mortality / months_times_percent, 1.0);
        species.deaths.random_pha = share * species.stocks.stems_pha;
        take(species.stocks, share, inputs.parameters[i].lost, false);
        stand.sizes_outdated = true;
    }
}

void thin_themselves(Stand& stand, const Inputs& inputs, int month) {
    update_basal_area_shares(stand);
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        SpeciesMonth& species = stand.species[i];
        const SelfThinning& limit = inputs.parameters[i].self_thinning;
        species.deaths.self_thinned_pha = 0.0;
        species.deaths.thinning_limit_kg = 0.0;
        const double share = species.sizes.basal_area_share;
        if (species.stocks.stems_pha <= 0.0 || share <= 0.0) {
            continue;
        }
        const double stems_pha = species.stocks.stems_pha / share;  // if it grew alone on the hectare
        species.deaths.thinning_limit_kg = limit.at_1000_kg * forest::power(1000.0 / stems_pha, limit.power);
        if (dormant(inputs.parameters[i], month) ||
            species.deaths.thinning_limit_kg >= species.sizes.tree_kg) {
            continue;
        }
        const LostShares& lost = inputs.parameters[i].lost;
        const double dead_pha =
            share * self_thinned_pha(stems_pha, species.stocks.stem / share, lost.stem, limit);
        species.deaths.self_thinned_pha = dead_pha;
        if (dead_pha < species.stocks.stems_pha) {
            take(species.stocks, dead_pha / species.stocks.stems_pha, lost, false);
        } else {
            take_all(species.stocks, false);
        }
        stand.sizes_outdated = true;
    }
}

double self_thinned_pha(double stems_pha, double stem_tpha, double lost_stem, const SelfThinning& limit) {
    constexpr double accuracy = 1e-3;  // thousand trees
    constexpr int most_steps = 5;
    const double lost_per_thousand = kg_per_t * lost_stem * stem_tpha / stems_pha;
    double thousands = stems_pha / 1000.0;
    for (int step = 0; step < most_steps && thousands > 0.0; ++step) {
        const double limit_tpha = limit.at_1000_kg * forest::power(thousands, 1.0 - limit.power);
        const double excess = limit_tpha - lost_per_thousand * thousands - (1.0 - lost_stem) * stem_tpha;
        const double slope = (1.0 - limit.power) * limit_tpha / thousands - lost_per_thousand;
        const double change = -excess / slope;
        thousands += change;
        if (std::abs(change) <= accuracy) {
            break;
        }
    }
    return stems_pha - 1000.0 * thousands;
}

}  // namespace coupling::validation::forest_cases::plain_3pg
