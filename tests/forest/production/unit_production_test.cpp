#include "forest/production/unit_production.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "forest/production/light_response.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::unit_production_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();

std::array<MonthConditions, 12> same_month(const MonthConditions& month) {
    std::array<MonthConditions, 12> months;
    months.fill(month);
    return months;
}

TEST(LightUseOfYear, IsThatOf3PgTimesTheMultiplier) {
    const Species& spruce = table[*table.find("piab")];
    const MonthConditions best{.mean_degc = spruce.three_pg.temperature.optimum_degc};
    const YearOfLightUse year = light_use_of_year(spruce, same_month(best), {.fertility = 1.0, .ph = 7.0});
    // 24 g/mol * 2.3 mol/MJ * 0.47 * alpha, nothing limiting.
    EXPECT_NEAR(year.npp_gpmj[5],
                24.0 * 2.3 * 0.47 * spruce.three_pg.quantum_efficiency * spruce.response.npp_multiplier,
                1e-9);
}

TEST(LightUseOfYear, LosesLessOnAShadySlopeThanLight) {
    const Species& spruce = table[*table.find("piab")];
    const MonthConditions flat{.mean_degc = 15.0};
    MonthConditions shady = flat;
    shady.slope_radiation = 0.668;
    const Soil soil{.fertility = 0.7, .ph = 6.0};
    const double gain = light_use_of_year(spruce, same_month(shady), soil).npp_gpmj[6] /
                        light_use_of_year(spruce, same_month(flat), soil).npp_gpmj[6];
    EXPECT_NEAR(0.668 * gain, 0.754, 0.001);
}

TEST(LightUseOfYear, LeavesAshBehindSpruceOnPoorSoil) {
    // The ratio of their production falls by that of their responses to nitrogen, classes 2.5 and 2.
    const MonthConditions month{.mean_degc = 15.0};
    const auto ash_to_spruce = [&](double nitrogen_kg) {
        const Soil soil{.fertility = 0.7, .nitrogen_kg_per_ha_year = nitrogen_kg, .ph = 7.0};
        return light_use_of_year(table[*table.find("frex")], same_month(month), soil).npp_gpmj[6] /
               light_use_of_year(table[*table.find("piab")], same_month(month), soil).npp_gpmj[6];
    };
    EXPECT_NEAR(ash_to_spruce(60.0) / ash_to_spruce(100.0), 0.946 / 0.999, 0.001);
}

TEST(LightUseOfYear, NeverExceedsThatOfFertileSoil) {
    const Species& birch = table[*table.find("bepe")];
    const MonthConditions month{.mean_degc = 15.0};
    const Soil fertile{.fertility = 1.0, .nitrogen_kg_per_ha_year = 90.0, .ph = 7.0};
    const Soil poor{.fertility = 0.9, .nitrogen_kg_per_ha_year = 30.0, .ph = 7.0};
    EXPECT_LE(light_use_of_year(birch, same_month(month), poor).npp_gpmj[6],
              light_use_of_year(birch, same_month(month), fertile).npp_gpmj[6]);
}

TEST(ShareProduction, GivesOutExactlyWhatTheUnitsMake) {
    const PatchGrid grid = square_of_forest(4);
    Stand stand{grid, table.size(), any_trees(grid, table, 300, 5), 2000};
    std::vector<AbsorbedByMonth> absorbed(300);
    std::vector<std::uint32_t> unit(300);
    std::vector<double> light(300);
    std::vector<double> factors(300);
    std::vector<YearOfLightUse> use(2 * table.size());
    for (std::size_t i = 0; i < 300; ++i) {
        absorbed[i].fill(10.0 + static_cast<double>(i));
        unit[i] = static_cast<std::uint32_t>(i % 2);
        light[i] = static_cast<double>(i) / 300.0;
        factors[i] = 0.4 + 0.2 * static_cast<double>(i % 7);
    }
    for (YearOfLightUse& one : use) {
        one.npp_gpmj.fill(0.5);
        one.physiology.fill(0.8);
    }
    std::vector<Tree> young{stand.trees().begin(), stand.trees().end()};
    for (std::size_t i = 0; i < 300; ++i) {
        young[i].light_ratio = light[i];
        young[i].age_years = 1.0;
    }
    double made_kg = 0.0;
    double given_kg = 0.0;
    const std::vector<TreeProduction> production =
        share_production(young, table, absorbed, std::vector<double>(300, 1.0), factors, unit, use);
    for (std::size_t i = 0; i < 300; ++i) {
        made_kg += 12.0 * absorbed[i][0] * 0.5 / 1000.0;
        given_kg += young[i].stems * production[i].npp_kg;
        EXPECT_GE(production[i].npp_kg, 0.0);
    }
    EXPECT_NEAR(given_kg, made_kg, 1e-6 * made_kg);
}

TEST(ShareProduction, GoesByLeafAreaWhereNobodyHasLight) {
    std::vector<Tree> trees = any_trees(square_of_forest(1), table, 2, 5);
    for (Tree& tree : trees) {
        tree = new_tree(table[SpeciesId{0}], SpeciesId{0}, 5.0, 5.0, 20.0, 15.0, 50.0);
        tree.light_ratio = 0.0;
    }
    std::vector<AbsorbedByMonth> absorbed(2);
    absorbed[0].fill(10.0);
    std::vector<YearOfLightUse> use(table.size());
    use[0].npp_gpmj.fill(1.0);
    const std::vector<TreeProduction> production =
        share_production(trees, table, absorbed, std::vector<double>(2, 1.0), std::vector<double>(2, 1.0),
                         std::vector<std::uint32_t>(2, 0), use);
    EXPECT_GT(production[1].npp_kg, 0.0);
    EXPECT_DOUBLE_EQ(production[0].npp_kg, production[1].npp_kg);
}

TEST(ShareProduction, GivesAShadedLeafNearlyAsMuchAsALitOne) {
    std::vector<Tree> trees(2, new_tree(table[SpeciesId{0}], SpeciesId{0}, 5.0, 5.0, 20.0, 15.0, 50.0));
    trees[0].light_ratio = 1.0;
    std::vector<AbsorbedByMonth> absorbed(2);
    absorbed[0].fill(10.0);
    std::vector<YearOfLightUse> use(table.size());
    use[0].npp_gpmj.fill(1.0);
    const std::vector<std::uint32_t> unit(2, 0);
    const double lit = light_response(table[SpeciesId{0}].light.response_class, 1.0);
    for (const double light : {0.0, 0.2, 0.5}) {
        trees[1].light_ratio = light;
        const double shaded = light_response(table[SpeciesId{0}].light.response_class, light);
        const auto of = share_production(trees, table, absorbed, std::vector<double>(2, 1.0),
                                         std::vector<double>(2, 1.0), unit, use);
        EXPECT_NEAR(of[1].npp_kg / of[0].npp_kg, std::pow(std::max(shaded, 0.1) / lit, 0.1), 1e-6) << light;
    }
}

TEST(ShareProduction, GivesATreeWhatItsFactorTakesFromItsLike) {
    const std::vector<Tree> trees(2, new_tree(table[SpeciesId{0}], SpeciesId{0}, 5.0, 5.0, 20.0, 15.0, 50.0));
    std::vector<AbsorbedByMonth> absorbed(2);
    absorbed[0].fill(10.0);
    absorbed[1].fill(10.0);
    std::vector<YearOfLightUse> use(2 * table.size());
    use[0].npp_gpmj.fill(1.0);
    use[table.size()].npp_gpmj.fill(1.0);
    const std::vector<double> ones(2, 1.0);
    const std::vector<double> factors{1.5, 0.75};
    const std::vector<std::uint32_t> together{0, 0};
    const std::vector<std::uint32_t> apart{0, 1};
    const auto like = share_production(trees, table, absorbed, ones, ones, together, use);
    const auto unlike = share_production(trees, table, absorbed, ones, factors, together, use);
    EXPECT_NEAR(unlike[0].npp_kg / unlike[1].npp_kg, 2.0, 1e-12);
    EXPECT_NEAR(unlike[0].npp_kg + unlike[1].npp_kg, like[0].npp_kg + like[1].npp_kg, 1e-12);
    const auto alone = share_production(trees, table, absorbed, ones, factors, apart, use);
    EXPECT_DOUBLE_EQ(alone[0].npp_kg, like[0].npp_kg) << "nobody of its unit to take from";
}

TEST(ShareProduction, GivesLittleOfWhatOldTreesLoseToOthers) {
    std::vector<Tree> trees(2, new_tree(table[SpeciesId{0}], SpeciesId{0}, 5.0, 5.0, 20.0, 15.0, 50.0));
    std::vector<AbsorbedByMonth> absorbed(2);
    absorbed[0].fill(10.0);
    absorbed[1].fill(10.0);
    std::vector<YearOfLightUse> use(table.size());
    use[0].npp_gpmj.fill(1.0);
    const std::vector<std::uint32_t> unit(2, 0);
    const auto both_kg = [](const std::vector<TreeProduction>& of) { return of[0].npp_kg + of[1].npp_kg; };
    const auto prime = share_production(trees, table, absorbed, std::vector<double>{1.0, 1.0},
                                        std::vector<double>(2, 1.0), unit, use);
    const auto old = share_production(trees, table, absorbed, std::vector<double>{1.0, 0.5},
                                      std::vector<double>(2, 1.0), unit, use);
    EXPECT_NEAR(both_kg(old), 0.75 * both_kg(prime), 1e-12) << "the unit makes less";
    EXPECT_NEAR(old[1].npp_kg, std::pow(0.5, 0.2) * old[0].npp_kg, 1e-9) << "the old tree gets less of it";
    EXPECT_LT(old[0].npp_kg, prime[0].npp_kg) << "and the other gains nothing";
}

}  // namespace
}  // namespace forest::unit_production_test
