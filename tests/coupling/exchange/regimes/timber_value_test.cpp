#include "coupling/exchange/regimes/timber_value.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::timber_value_test {
namespace {

const std::string price_head =
    "species,dbh_from_cm,dbh_to_cm,sold_share,revenue_eur_per_m3,felling_eur_per_m3,hauling_eur_per_m3\n";
const std::string work_table = "work,cost_eur\nplanted_tree,2\ntended_ha,500\nfenced_ha,3000\n";

PriceTable prices_of(const std::string& rows, const std::string& work = work_table) {
    return read_prices(table_of(price_head + rows), table_of(work), species_table());
}

TEST(ContributionMargin, IsRevenueOfWhatIsSoldLessTheCostOfWhatIsFelledAndHauled) {
    const PriceTable prices =
        prices_of("piab,0,20,0.8,40,20,30\npiab,20,,0.8,100,10,30\nany,0,,0.5,60,10,20\n");
    forest::Timber timber;
    timber.by_species.resize(species_table().size());
    auto& spruce = timber.by_species[forest::index_of(species_of("piab"))];
    spruce[forest::dbh_class_of(14.0)].taken_m3 = 10.0;
    spruce[forest::dbh_class_of(30.0)] = {.stems = 5, .taken_m3 = 20.0, .left_m3 = 5.0};
    timber.by_species[forest::index_of(species_of("fasy"))][forest::dbh_class_of(30.0)].taken_m3 = 2.0;
    const Margin margin = contribution_margin(timber, prices);
    EXPECT_NEAR(margin.revenue_eur, 10 * 0.8 * 40 + 20 * 0.8 * 100 + 2 * 0.5 * 60, 1e-9);
    EXPECT_NEAR(margin.harvest_eur, 10 * 50.0 + 25 * 10.0 + 20 * 30.0 + 2 * 30.0, 1e-9);
    EXPECT_NEAR(margin.contribution_eur(), margin.revenue_eur - margin.harvest_eur, 1e-9);

    RegimeReport report;
    report.timber = timber;
    report.entries.push_back(
        {.intervention = "plant", .treatment = Treatment::plant, .area_ha = 3.0, .plants = 100});
    report.entries.push_back({.intervention = "tend",
                              .treatment = Treatment::tend,
                              .area_ha = 9.0,
                              .tended = 7,
                              .tended_ha = 2.0});
    report.entries.push_back({.intervention = "nothing", .treatment = Treatment::tend, .area_ha = 9.0});
    report.entries.push_back(
        {.intervention = "fence", .treatment = Treatment::fence, .area_ha = 9.0, .fenced_ha = 0.5});
    EXPECT_NEAR(contribution_margin(report, prices).young_eur, 200.0 + 1000.0 + 1500.0, 1e-9);
    EXPECT_NEAR(contribution_margin(report, prices).revenue_eur, margin.revenue_eur, 1e-9);
}

// Felling gains what the stock loses, whichever trees are felled and whatever stays of them as a stock.
TEST(StandingValue, LosesWhatFellingGains) {
    const PriceTable prices =
        prices_of("piab,0,20,0.8,90,20,30\npiab,20,,0.8,100,10,30\nany,0,,0.5,60,10,20\n");
    for (const std::size_t step : {1U, 2U, 7U}) {
        forest::Stand stand = spruce_stand(4);
        const double before_eur = standing_value_eur(stand, species_table(), prices);
        std::vector<std::size_t> picks;
        for (std::size_t i = 0; i < stand.trees().size(); i += step) {
            picks.push_back(i);
        }
        const forest::Timber timber =
            forest::fell(stand, species_table(), picks, {.stump_height_m = 0.0}, 1, 0);
        const double gained_eur = contribution_margin(timber, prices).contribution_eur();
        EXPECT_GT(gained_eur, 0.0);
        EXPECT_NEAR(before_eur - standing_value_eur(stand, species_table(), prices), gained_eur,
                    1e-9 * before_eur);
    }
}

TEST(StandingValue, IsNothingWhereFellingDoesNotPay) {
    const PriceTable prices = prices_of("any,0,,0.5,60,10,20\n");
    EXPECT_EQ(standing_value_eur(spruce_stand(4), species_table(), prices), 0.0);
    EXPECT_GT(standing_value_eur(spruce_stand(4), species_table(), prices_of("any,0,,0.5,61,10,20\n")), 0.0);
}

TEST(ContributionMargin, HasFixedCostsOfEntriesThatFoundSomethingAndOfCableLines) {
    const std::string rows = "any,0,,0.5,60,10,20\n";
    const PriceTable prices = prices_of(rows, work_table + "entry,1200\ncable_setup,900\n");
    RegimeReport report;
    report.timber.by_species.resize(species_table().size());
    report.entries.push_back(
        {.intervention = "tend", .treatment = Treatment::tend, .area_ha = 9.0, .tended = 7});
    report.entries.push_back({.intervention = "nothing", .treatment = Treatment::tend, .area_ha = 9.0});
    EXPECT_EQ(contribution_margin(report, prices, 2.0).fixed_eur, 1200.0 + 2.0 * 900.0);
    EXPECT_EQ(contribution_margin(report, prices, 2.0).contribution_eur(), -3000.0);
    EXPECT_EQ(contribution_margin(report, prices_of(rows), 2.0).fixed_eur, 0.0);
}

TEST(ReadPrices, TakesTheShippedOnes) {
    const PriceTable prices = shipped_prices(species_table());
    ASSERT_EQ(prices.by_species.size(), species_table().size());
    for (const auto& classes : prices.by_species) {
        for (const TimberPrice& price : classes) {
            EXPECT_GT(price.revenue_eur_per_m3, 0.0);
            EXPECT_GT(price.felling_eur_per_m3 + price.hauling_eur_per_m3, 0.0);
        }
    }
    EXPECT_GT(prices.planted_tree_eur, 0.0);
}

}  // namespace
}  // namespace coupling::timber_value_test
