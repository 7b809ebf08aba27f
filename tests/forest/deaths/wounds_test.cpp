#include "forest/deaths/wounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/forest/small_forest.hpp"

namespace forest::wounds_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

/// Equal trees of 30 cm and 25 m.
Stand trees_of(SpeciesId species, std::size_t count) {
    std::vector<Tree> trees(count, new_tree(table[species], species, 5.0, 5.0, 30.0, 25.0, 80.0));
    for (std::size_t i = 0; i < count; ++i) {
        trees[i].id = TreeId{i};
    }
    return {square_of_forest(1), table.size(), trees, 2000};
}

Impact hit(std::uint64_t tree, double energy_share, bool frontal = true, double height_m = 0.8) {
    return {.tree = TreeId{tree},
            .height_m = height_m,
            .energy_share = energy_share,
            .frontal = frontal,
            .rock_diameter_m = 0.5,
            .direction_rad = -1.0};
}

WoundReport hit_all(Stand& stand, const std::vector<Impact>& impacts,
                    const UprootingLaw& law = {.deep_soil = 0.0}) {
    return wound(stand, table, impacts, law, 1, 0);
}

TEST(Wound, BreaksWhatCannotTakeTheEnergyAndLeavesStumpAndLog) {
    Stand stand = trees_of(spruce, 3);
    const WoundReport report = hit_all(stand, {hit(0, 1.2), hit(1, 1.2, true, 6.0), hit(2, 1.2, false)});
    EXPECT_EQ(report.broken, 2U);
    EXPECT_EQ(report.wounded, 1U) << "a glancing hit breaks nothing";
    EXPECT_EQ(stand.trees().size(), 1U);
    EXPECT_EQ(stand.balance().stems_out[index_of(Cause::rock)], 2U);
    ASSERT_EQ(stand.dead_wood().snags.size(), 2U);
    EXPECT_DOUBLE_EQ(stand.dead_wood().snags[0].height_m, 0.8);
    EXPECT_DOUBLE_EQ(stand.dead_wood().snags[1].height_m, 3.0);
    ASSERT_EQ(stand.dead_wood().logs.size(), 2U);
    EXPECT_DOUBLE_EQ(stand.dead_wood().logs[0].length_m, 24.2);
    EXPECT_EQ(stand.dead_wood().logs[0].origin, LogOrigin::broken_by_rock);
    EXPECT_EQ(stand.dead_wood().logs[0].direction_rad, -1.0);
}

TEST(Wound, UprootsAsOftenAsItsChanceSays) {
    constexpr std::size_t count = 4000;
    Stand stand = trees_of(spruce, count);
    std::vector<Impact> impacts;
    for (std::size_t i = 0; i < count; ++i) {
        impacts.push_back(hit(i, 2.0));
    }
    const WoundReport report = hit_all(stand, impacts, {.deep_soil = 0.4});
    EXPECT_EQ(report.broken + report.uprooted, count);
    EXPECT_NEAR(static_cast<double>(report.uprooted) / count, 0.4, 4.0 * std::sqrt(0.24 / count));
    EXPECT_EQ(stand.dead_wood().logs.size(), count);
    EXPECT_EQ(stand.dead_wood().snags.size(), report.broken);
}

TEST(Wound, UprootsOnShallowSoilRather) {
    std::vector<Patch> patches = square_of_forest(1).patches();
    patches[0].soil.water_capacity_mm = 50.0;
    std::vector<Tree> trees{new_tree(table[spruce], spruce, 5.0, 5.0, 30.0, 25.0, 80.0)};
    Stand stand{{square_of_forest(1).frame(), patches}, table.size(), trees, 2000};
    const WoundReport report = hit_all(stand, {hit(0, 2.0)}, {.deep_soil = 0.0, .shallow_soil = 1.0});
    EXPECT_EQ(report.uprooted, 1U);
}

TEST(Wound, LeavesAScarBySizeAndEnergyAndTakesVitality) {
    Stand stand = trees_of(spruce, 1);
    hit_all(stand, {hit(0, 0.5)});
    ASSERT_EQ(stand.wounds().size(), 1U);
    const double width_cm = 30.0 * 0.55;
    EXPECT_NEAR(stand.wounds()[0].width_cm, width_cm, 1e-4);
    EXPECT_NEAR(stand.wounds()[0].area_cm2, 0.375 * std::numbers::pi * width_cm * width_cm, 1e-3);
    EXPECT_NEAR(stand.trees()[0].vitality, 1.0 - 0.6 * width_cm / (std::numbers::pi * 30.0), 1e-6);
    EXPECT_EQ(stand.trees().size(), 1U);
}

TEST(Wound, JoinsNeighboursAndKeepsDistantOnesApart) {
    Stand stand = trees_of(spruce, 1);
    hit_all(stand, {hit(0, 0.1, true, 1.0), hit(0, 0.3, true, 1.2), hit(0, 0.1, true, 2.0)});
    ASSERT_EQ(stand.wounds().size(), 2U);
    EXPECT_FLOAT_EQ(stand.wounds()[0].energy_use, 0.3F);
    EXPECT_GT(stand.wounds()[0].area_cm2, stand.wounds()[1].area_cm2);
}

TEST(Wound, CountsHitsOfTreesThatAreGone) {
    Stand stand = trees_of(spruce, 1);
    const WoundReport report = hit_all(stand, {hit(0, 1.5), hit(0, 0.5), hit(99, 0.5)});
    EXPECT_EQ(report.broken, 1U);
    EXPECT_EQ(report.missed, 2U);
    EXPECT_TRUE(stand.wounds().empty());
}

TEST(Wound, LetsRotIntoSpruceMoreThanIntoLarch) {
    constexpr std::size_t count = 2000;
    for (const char* code : {"piab", "lade"}) {
        const SpeciesId species = *table.find(code);
        Stand stand = trees_of(species, count);
        std::vector<Impact> impacts;
        for (std::size_t i = 0; i < count; ++i) {
            impacts.push_back(hit(i, 0.5));
        }
        hit_all(stand, impacts);
        double rotten = 0.0;
        for (const Tree& tree : stand.trees()) {
            rotten += tree.rot.depth_cm > 0.0F ? 1.0 : 0.0;
        }
        const double p = table[species].wounds.rot_probability;
        EXPECT_NEAR(rotten / count, p, 4.0 * std::sqrt(p * (1.0 - p) / count)) << code;
    }
}

TEST(StemStrength, FallsWithTheCubeOfTheRottenCore) {
    Tree tree = new_tree(table[spruce], spruce, 5.0, 5.0, 30.0, 25.0, 80.0);
    EXPECT_EQ(stem_strength(tree, 1.0), 1.0);
    tree.rot = {.since_year = 1990, .from_m = 0.5F, .to_m = 2.0F, .depth_cm = 7.5F};
    EXPECT_NEAR(stem_strength(tree, 1.0), 1.0 - 0.125, 1e-9);
    EXPECT_EQ(stem_strength(tree, 3.0), 1.0);
    tree.rot.depth_cm = 15.0F;
    EXPECT_EQ(stem_strength(tree, 1.0), 0.2);
}

TEST(StemStrength, LetsARottenTreeBreakAtLessEnergy) {
    Stand stand = trees_of(spruce, 2);
    std::vector<Rot> rots(2);
    rots[1] = {.since_year = 1970, .from_m = 0.0F, .to_m = 3.0F, .depth_cm = 12.0F};
    stand.set_rots(rots);
    const WoundReport report = hit_all(stand, {hit(0, 0.7), hit(1, 0.7)});
    EXPECT_EQ(report.broken, 1U);
    EXPECT_TRUE(stand.find(TreeId{0}));
    EXPECT_FALSE(stand.find(TreeId{1}));
}

TEST(WoundDeath, RisesWithGirthAndEnergyAndIsHalfForBroadleaves) {
    const Wound scar{.width_cm = static_cast<float>(0.5 * std::numbers::pi * 30.0), .energy_use = 0.4F};
    const std::vector<Wound> wounds{scar};
    EXPECT_NEAR(wound_death(table[spruce], 30.0, wounds), 0.015 + 0.008, 1e-7);
    EXPECT_NEAR(wound_death(table[*table.find("fasy")], 30.0, wounds), 0.5 * 0.023, 1e-7);
    EXPECT_EQ(wound_death(table[spruce], 30.0, {}), 0.0);
}

TEST(WoundDeaths, ComeAsOftenAsTheirChanceSays) {
    constexpr std::size_t count = 20'000;
    Stand stand = trees_of(spruce, count);
    std::vector<Wound> wounds;
    for (std::size_t i = 0; i < count; ++i) {
        wounds.push_back(
            {.tree = TreeId{i}, .year = 2000, .height_m = 1.0F, .width_cm = 30.0F, .energy_use = 0.9F});
    }
    stand.set_wounds(wounds);
    const double p = wound_death(table[spruce], 30.0, stand.wounds_of(TreeId{0}));
    EXPECT_NEAR(static_cast<double>(wound_deaths(stand, table, 1, 0).size()) / count, p,
                4.0 * std::sqrt(p * (1.0 - p) / count));
}

TEST(Heal, ClosesWoundsInTheLightAndLetsRotSpread) {
    Stand stand = trees_of(spruce, 2);
    stand.set_light_ratios(std::vector<double>{0.8, 0.1});
    stand.set_vitalities(std::vector<double>{0.9, 0.995});
    std::vector<Rot> rots(2);
    rots[0] = {.since_year = 1999, .from_m = 1.0F, .to_m = 1.5F, .depth_cm = 1.0F};
    stand.set_rots(rots);
    stand.set_wounds({{.tree = TreeId{0}, .height_m = 1.0F, .width_cm = 10.0F, .area_cm2 = 100.0F},
                      {.tree = TreeId{1}, .height_m = 1.0F, .width_cm = 10.0F, .area_cm2 = 100.0F}});
    heal(stand, table);
    EXPECT_FLOAT_EQ(stand.wounds()[0].width_cm, 8.0F);
    EXPECT_FLOAT_EQ(stand.wounds()[0].area_cm2, 64.0F);
    EXPECT_FLOAT_EQ(stand.wounds()[1].width_cm, 10.0F) << "no closure in the dark";
    EXPECT_DOUBLE_EQ(stand.trees()[0].vitality, 0.92);
    EXPECT_EQ(stand.trees()[1].vitality, 1.0);
    EXPECT_NEAR(stand.trees()[0].rot.to_m - stand.trees()[0].rot.from_m, 0.5 + 0.174, 1e-5);
    EXPECT_FLOAT_EQ(stand.trees()[0].rot.depth_cm, 1.3F);
    for (int year = 0; year < 5; ++year) {
        heal(stand, table);
    }
    EXPECT_EQ(stand.wounds().size(), 1U) << "the one in the light has closed";
}

}  // namespace
}  // namespace forest::wounds_test
