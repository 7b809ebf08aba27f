#include "coupling/exchange/regimes/stem_numbers.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::stem_numbers_test {
namespace {

config::Table stems_of(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "stems.csv");
}

/// A regime whose file of stems holds a text.
Regime thinned(const std::string& stems,
               const std::string& rows = "treatment,stems,every_years\nthin_to_stems,stems.csv,1\n") {
    return Regime::read(table_of(rows), "thinned", species_table(), two_stands(6), one_polygon, {},
                        [&](const std::string&, const std::string&) { return stems_of(stems); });
}

Area stand(std::uint32_t number) {
    Area area;
    area.place.management_units = {number};
    return area;
}

TEST(StemNumbers, LieStraightBetweenTheAgesOfAStand) {
    const std::vector<StemsAtAge> stems = read_stem_numbers(
        stems_of("stand,age_years,stems_pha,volume_m3pha\n2,40,1500,300\n1,30,3000,\n1,40,2000,\n"));
    EXPECT_EQ(stems, (std::vector<StemsAtAge>{{1, 30.0, 3000.0}, {1, 40.0, 2000.0}, {2, 40.0, 1500.0}}));
    EXPECT_EQ(stems_at(stems, stand(1), 30.0), 3000.0);
    EXPECT_EQ(stems_at(stems, stand(1), 35.0), 2500.0);
    EXPECT_EQ(stems_at(stems, stand(1), 40.0), 2000.0);
    EXPECT_EQ(stems_at(stems, stand(2), 40.0), 1500.0);
    EXPECT_EQ(stems_at(stems, stand(1), 29.0), std::nullopt) << "the table says nothing";
    EXPECT_EQ(stems_at(stems, stand(1), 41.0), std::nullopt);
    EXPECT_EQ(stems_at(stems, stand(3), 35.0), std::nullopt);
    const std::vector<StemsAtAge> of_all = read_stem_numbers(stems_of("age_years,stems_pha\n20,9\n10,8\n"));
    EXPECT_EQ(stems_at(of_all, Area{}, 10.0), 8.0) << "the whole forest as one area";
    EXPECT_EQ(stems_at(of_all, stand(7), 15.0), 8.5);
}

TEST(ThinToStems, TakesTheThinnestAtTheAgeOfEachStand) {
    // The spruces are 80 years old.
    const Regime regime = thinned("stand,age_years,stems_pha\n1,70,500\n1,90,300\n2,81,200\n",
                                  "treatment,stems,every_years,where\nthin_to_stems,stems.csv,1,stands\n");
    forest::Stand forest = spruce_stand(6);
    RegimeState state;
    const RegimeReport report = apply(regime, 0, forest, species_table(), state, {1, 0});
    ASSERT_EQ(report.entries.size(), 1U);
    const forest::Stand before = spruce_stand(6);
    std::size_t west = 0;
    std::size_t east = 0;
    double thinnest_left_cm = 1000.0;
    for (const forest::Tree& tree : forest.trees()) {
        const bool is_west = forest.grid()[tree.patch].management_unit == 1;
        west += is_west ? 1 : 0;
        east += is_west ? 0 : 1;
        thinnest_left_cm = is_west ? std::min(thinnest_left_cm, tree.dbh_cm) : thinnest_left_cm;
    }
    EXPECT_EQ(west, 72U) << "400 a hectare of 0.18";
    EXPECT_EQ(report.entries[0].stems, static_cast<double>(before.trees().size() - forest.trees().size()));
    for (const forest::Tree& tree : before.trees()) {
        if (before.grid()[tree.patch].management_unit == 1 && tree.dbh_cm > thinnest_left_cm) {
            EXPECT_TRUE(forest.find(tree.id)) << "thicker than one that stays";
        }
        if (before.grid()[tree.patch].management_unit == 2) {
            EXPECT_TRUE(forest.find(tree.id)) << "not yet 81 years old";
        }
    }
    EXPECT_GT(east, 36U);
}

TEST(ThinToStems, CountsAllTreesWhereSomeMayNotGo) {
    const Regime regime = thinned("age_years,stems_pha\n80,300\n",
                                  "treatment,stems,only_species\nthin_to_stems,stems.csv,abal\n");
    forest::Stand forest = spruce_stand(6);
    RegimeState state;
    EXPECT_EQ(apply(regime, 0, forest, species_table(), state, {1, 0}).entries[0].stems, 0.0);
}

TEST(ThinToStems, AgesWithTheClearCutOfItsArea) {
    const Regime regime = thinned("age_years,stems_pha\n75,100\n85,100\n",
                                  "treatment,stems,order,every_years\nclear_cut,,1,500\n"
                                  "thin_to_stems,stems.csv,2,1\n");
    forest::Stand forest = spruce_stand(6);
    RegimeState state;
    static_cast<void>(apply(regime, 0, forest, species_table(), state, {1, 0}));
    forest::Stand other = spruce_stand(6);
    const RegimeReport report = apply(regime, 1, other, species_table(), state, {1, 0});
    ASSERT_EQ(report.entries.size(), 1U);
    EXPECT_TRUE(report.entries[0].found_nothing()) << "the area is one year old";
}

}  // namespace
}  // namespace coupling::stem_numbers_test
