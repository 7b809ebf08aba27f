// A hundred years of each shipped regime on twelve hectares: about a minute, so it is asked for by name,
//   coupling_tests --gtest_also_run_disabled_tests --gtest_filter='RegimeExperiment*'
// It prints the table of coupling/exchange/regimes/README.md and holds the ranking of harvests.

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <map>

#include "coupling/exchange/regimes/shipped.hpp"
#include "coupling/exchange/regimes/timber_value.hpp"
#include "forest/inventory/tables.hpp"
#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::experiment_test {
namespace {

constexpr int years = 100;

/// A slope of 600 x 200 m.
forest::PatchGrid slope() {
    const forest::PatchGrid square = forest::square_of_forest(60);
    config::GridFrame frame = square.frame();
    frame.rows = 20;
    std::vector<forest::Patch> patches = square.patches();
    std::erase_if(patches, [](const forest::Patch& patch) { return patch.cell.row >= 20; });
    return {frame, patches};
}

/// Spruce of 90 years: 700 stems a hectare of 30 cm and 25 m.
forest::Stand old_spruce(const forest::PatchGrid& grid) {
    forest::StandRecord record;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        record.patches.push_back(forest::PatchId{i});
    }
    record.species = {{.species = species_of("piab"),
                       .stems_pha = 700.0,
                       .mean_dbh_cm = 30.0,
                       .mean_height_m = 25.0,
                       .age_years = 90.0}};
    record.degree_days = 1300.0;
    return {grid, species_table().size(), forest::trees_from_record(record, grid, species_table(), 1, 0, 0),
            2000};
}

/// Means over the years, per hectare and year; figures at the end per hectare.
struct Outcome {
    double taken_m3 = 0.0;
    double left_m3 = 0.0;
    double increment_m3 = 0.0;
    double contribution_eur = 0.0;
    double volume_m3pha = 0.0;
    double stems_from_12cm_pha = 0.0;
};

Outcome outcome_of(const std::string& name) {
    const forest::SmallForest place{slope()};
    const double per_ha_and_year = 1.0 / (place.grid.area_ha() * years);
    const Regime regime = regime_of(std::string{shipped_regime(name)}, place.grid);
    const PriceTable prices = shipped_prices(species_table());
    forest::Stand stand = old_spruce(place.grid);
    RegimeState state;
    Outcome outcome;
    for (int year = 0; year < years; ++year) {
        outcome.increment_m3 += per_ha_and_year * place.grow(stand).volume_increment_m3;
        const RegimeReport report = apply(regime, year, stand, species_table(), state, {1, 0});
        outcome.taken_m3 += per_ha_and_year * report.timber.total().taken_m3;
        outcome.left_m3 += per_ha_and_year * report.timber.total().left_m3;
        outcome.contribution_eur += per_ha_and_year * contribution_margin(report, prices).contribution_eur();
    }
    outcome.volume_m3pha = volume_m3(stand) / place.grid.area_ha();
    for (const forest::Tree& tree : stand.trees()) {
        outcome.stems_from_12cm_pha += tree.dbh_cm >= 12.0 ? tree.stems / place.grid.area_ha() : 0.0;
    }
    EXPECT_TRUE(books_close(stand));
    return outcome;
}

TEST(RegimeExperiment, DISABLED_HundredYearsOfEachShippedRegime) {
    std::map<std::string, Outcome> outcomes;
    std::cout << std::fixed;
    for (const std::string& name : shipped_regime_names()) {
        const Outcome& o = outcomes[name] = outcome_of(name);
        std::cout << "| `" << name << "` | " << std::setprecision(1) << o.taken_m3 + o.left_m3 << " | "
                  << o.taken_m3 << " | " << o.increment_m3 << " | " << std::setprecision(0)
                  << o.contribution_eur << " | " << o.volume_m3pha << " | " << o.stems_from_12cm_pha << " |"
                  << std::endl;
    }
    EXPECT_EQ(outcomes["none"].taken_m3, 0.0);
    for (const std::string& slits : {std::string{"pfm1"}, std::string{"pfm2"}}) {
        // Rammer et al. 2015: 6.7 with BAU, 5.7-5.9 with PFM.
        EXPECT_LT(outcomes[slits].taken_m3, outcomes["bau_shelterwood"].taken_m3);
        EXPECT_GT(outcomes[slits].taken_m3, 0.4 * outcomes["bau_shelterwood"].taken_m3);
    }
}

}  // namespace
}  // namespace coupling::experiment_test
