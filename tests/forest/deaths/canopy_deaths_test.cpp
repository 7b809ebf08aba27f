#include "forest/deaths/canopy_deaths.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/forest/small_forest.hpp"

namespace forest::canopy_deaths_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");
const SpeciesId beech = *table.find("fasy");
constexpr CanopyPlace usual_place{};

TEST(CanopyDeath, RisesWithTheSixthPowerOfTheDiameter) {
    const CanopyDeaths law;
    const double thin = canopy_death(table[spruce], 0.0, 0.0, usual_place, law);
    EXPECT_NEAR(thin, law.at_any_size, 1e-12);
    EXPECT_NEAR(canopy_death(table[spruce], 100.0, 0.0, usual_place, law) - thin, law.by_size,
                1e-12);
    EXPECT_NEAR(canopy_death(table[spruce], 50.0, 0.0, usual_place, law) - thin, law.by_size / 64.0,
                1e-12);
    EXPECT_NEAR(canopy_death(table[beech], 100.0, 0.0, usual_place, law) - thin,
                law.broadleaves * law.by_size, 1e-12);
}

TEST(CanopyDeath, OfATreeInTheCanopyIsBelowTheMiddleOfGapModels) {
    // Gap models have 0.5 to 1 % a year at any size, the deaths of suppressed trees included: less than their
    // middle where forests are as dense as old ones.
    for (const SpeciesId kind : {spruce, beech}) {
        const double p = canopy_death(table[kind], 50.0, 150.0, usual_place, {});
        EXPECT_GT(p, 0.002);
        EXPECT_LT(p, 0.0075);
    }
}

TEST(CanopyDeath, OfYoungTreesIsThatOfInventoriesWithoutDisturbance) {
    // Guyennon et al. 2023, optimum, 50 cm: 0.10 and 0.20 % a year among 20 m2/ha of larger firs and spruces.
    const double p = canopy_death(table[spruce], 40.0, 80.0, usual_place, {});
    EXPECT_GT(p, 0.0010);
    EXPECT_LT(p, 0.0020);
}

TEST(CanopyDeath, RisesFromTheMiddleOfLifeAtWhichATreeCountsAsOld) {
    const CanopyDeaths law;
    const double greatest = table[spruce].mortality.max_age_years;
    const auto old_part = [&](double share) {
        CanopyDeaths none = law;
        none.of_old = 0.0;
        return canopy_death(table[spruce], 40.0, share * greatest, usual_place, law) -
               canopy_death(table[spruce], 40.0, share * greatest, usual_place, none);
    };
    EXPECT_EQ(old_part(law.old_from), 0.0);
    EXPECT_NEAR(old_part(0.5 * (law.old_from + law.old_at)), 0.5 * law.of_old, 1e-12);
    EXPECT_NEAR(old_part(law.old_at), law.of_old, 1e-12);
    EXPECT_NEAR(old_part(0.6), law.of_old, 1e-12);
}

TEST(CanopyRank, FollowsTheBasalAreaOfLargerTrees) {
    const CanopyDeaths law;
    EXPECT_DOUBLE_EQ(canopy_rank(law.usual_larger_m2pha, law), 1.0);
    // Spruce has 2.6 times as many deaths among 40 as among 5 m2/ha, beech 1.3 times (Guyennon et al. 2023).
    const double rise = canopy_rank(40.0, law) / canopy_rank(5.0, law);
    EXPECT_GT(rise, 1.3);
    EXPECT_LT(rise, 2.6);
    const auto deaths_among = [&](double m2pha) {
        return canopy_death(table[spruce], 40.0, 80.0, {.larger_m2pha = m2pha}, law);
    };
    EXPECT_NEAR(deaths_among(40.0) - deaths_among(20.0), law.at_any_size * (std::exp(20.0 * law.by_rank) - 1.0),
                1e-9);
}

TEST(CanopyCrowding, FollowsThePowerOfBasalAreaUpToItsMost) {
    const CanopyDeaths law;
    const auto power_of = [&](double m2pha) { return canopy_crowding(m2pha, law) - law.alone; };
    EXPECT_NEAR(power_of(law.usual_m2pha), 1.0, 1e-9);
    EXPECT_NEAR(power_of(0.5 * law.usual_m2pha), std::pow(0.5, law.by_density), 1e-9);
    EXPECT_NEAR(power_of(1.2 * law.usual_m2pha), std::pow(1.2, law.by_density), 1e-9);
    EXPECT_NEAR(power_of(3.0 * law.usual_m2pha), law.most_crowding, 1e-9);
    EXPECT_GE(power_of(0.0), 0.0);
    EXPECT_LT(power_of(0.0), 1e-9);
    CanopyDeaths same_everywhere;
    same_everywhere.by_density = 0.0;
    EXPECT_DOUBLE_EQ(canopy_crowding(70.0, same_everywhere), canopy_crowding(5.0, same_everywhere));
}

TEST(CanopyWarmth, FollowsTheTurnoverOfForestsOnTheirGradient) {
    // Stephenson & van Mantgem 2005: 2.76 - 0.66 z / km % a year; 5.1 K a kilometre, 208 degree-days a
    // kelvin.
    const CanopyDeaths law;
    const auto published = [](double z_km) { return 2.76 - 0.66 * z_km; };
    constexpr double middle_km = 2.25;
    for (const double z_km : {1.7, 2.25, 2.9}) {
        const double degree_days = 1300.0 + (middle_km - z_km) * 5.1 * 208.0;
        EXPECT_NEAR(canopy_warmth(degree_days, law), published(z_km) / published(middle_km), 0.02) << z_km;
    }
    EXPECT_DOUBLE_EQ(canopy_warmth(1300.0, law), 1.0);
}

TEST(CanopyWarmth, EndsWithTheRangeThatWasMeasured) {
    const CanopyDeaths law;
    EXPECT_DOUBLE_EQ(canopy_warmth(0.0, law), 0.6);
    EXPECT_DOUBLE_EQ(canopy_warmth(3000.0, law), 1.4);
    CanopyDeaths same_everywhere;
    same_everywhere.by_warmth = 0.0;
    EXPECT_DOUBLE_EQ(canopy_warmth(300.0, same_everywhere), canopy_warmth(2000.0, same_everywhere));
}

TEST(CanopyDeath, OfWarmPlacesTakesMoreOldTreesAndGiantsAlone) {
    const auto warm_over_usual = [](double dbh_cm, double age_years) {
        return canopy_death(table[spruce], dbh_cm, age_years, {.warmth = 1.3}, {}) -
               canopy_death(table[spruce], dbh_cm, age_years, usual_place, {});
    };
    const CanopyDeaths law;
    EXPECT_NEAR(warm_over_usual(0.0, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(warm_over_usual(100.0, 0.0), 0.3 * law.by_size, 1e-12);
    EXPECT_NEAR(warm_over_usual(0.0, 300.0), 0.3 * law.of_old, 1e-12);
}

TEST(CanopyDeath, OfAgeTakesOldTreesAndSparesThoseOfHalfTheGreatestAge) {
    const auto of_age = [](double share_of_greatest) {
        CanopyDeaths none;
        none.at_any_size = 0.0;
        none.of_old = 0.0;
        const double greatest = table[beech].mortality.max_age_years;
        return canopy_death(table[beech], 0.0, share_of_greatest * greatest, usual_place, none);
    };
    double alive = 1.0;
    double alive_at_half = 0.0;
    const auto greatest = static_cast<int>(table[beech].mortality.max_age_years);
    for (int age = 0; age < greatest; ++age) {
        alive *= 1.0 - of_age(static_cast<double>(age) / greatest);
        alive_at_half = 2 * age < greatest ? alive : alive_at_half;
    }
    EXPECT_GT(alive_at_half, 0.95);
    EXPECT_NEAR(alive, 0.01, 0.005);
    EXPECT_LT(of_age(0.5), 0.1 * of_age(0.75));
}

TEST(CanopyDeath, RisesWithCrowdingOnlyInItsPartOfOldTrees) {
    const CanopyDeaths law;
    for (const auto& [age_years, part] : {std::pair{80.0, 0.0}, {300.0, law.of_old}}) {
        const double usual = canopy_death(table[spruce], 60.0, age_years, usual_place, law);
        const double crowded = canopy_death(table[spruce], 60.0, age_years, {.crowding = 3.0}, law);
        EXPECT_NEAR(crowded - usual, 2.0 * part, 1e-12) << age_years;
    }
}

/// Stems that are gone after a year in which trees of the canopy alone die, at a factor of warmth.
double deaths_in_a_year(double factor) {
    SmallForest forest{square_of_forest(10)};
    CanopyDeaths& law = forest.parameters.mortality.canopy;
    law.at_any_size = 0.0;
    law.of_old = 0.1;
    law.old_from = 0.0;
    law.old_at = 0.001;
    law.by_density = 0.0;
    law.coldest = law.warmest = factor;
    forest.parameters.mortality.stress = false;
    forest.parameters.processes.self_thinning = false;
    forest.parameters.processes.regeneration = false;
    Stand stand{forest.grid, forest.species.size(), mixed_stand(forest, 600.0, 1), 2000};
    const auto stems = [&stand] {
        double sum = 0.0;
        for (const Tree& tree : stand.trees()) {
            sum += tree.stems;
        }
        return sum;
    };
    const double before = stems();
    static_cast<void>(forest.grow(stand));
    return before - stems();
}

TEST(CanopyWarmth, OfThePlaceDecidesInAGrownYear) {
    const double usual = deaths_in_a_year(1.0);
    EXPECT_GT(usual, 40.0);
    EXPECT_NEAR(deaths_in_a_year(2.0), 2.0 * usual, 4.0 * std::sqrt(3.0 * usual)) << "binomial";
    EXPECT_LT(deaths_in_a_year(0.0), 0.05 * usual) << "of age alone";
}

/// A thick tree with thinner ones at rising distances to the east, and one that is thicker still. Its crown
/// is 3 m wide to each side.
Stand around_a_giant() {
    const PatchGrid grid = square_of_forest(3);
    std::vector<Tree> trees;
    const auto add = [&](double x_m, double dbh_cm) {
        Tree tree = new_tree(table[spruce], spruce, x_m, 15.0, dbh_cm, 20.0, 100.0);
        tree.id = TreeId{trees.size()};
        trees.push_back(tree);
    };
    add(10.0, 80.0);
    for (const double x_m : {12.0, 14.0, 16.0, 18.0, 21.0}) {
        add(x_m, 20.0);
    }
    add(11.0, 90.0);
    add(11.5, 8.0);
    trees.front().crown.radius_m = 3.0;
    return {grid, table.size(), trees, 2000};
}

TEST(TakenAlong, AreTheNearestThreeThinnerTreesWhereItFalls) {
    const Stand stand = around_a_giant();
    const std::vector<std::size_t> giant{0};
    constexpr int deaths = 4000;
    std::array<int, 4> numbers{};
    for (std::uint32_t replicate = 0; replicate < deaths; ++replicate) {
        const std::vector<Removal> taken = taken_along(stand, giant, 1, replicate);
        ASSERT_LE(taken.size(), 3U);
        ++numbers[taken.size()];
        for (std::size_t i = 0; i < taken.size(); ++i) {
            EXPECT_EQ(number_of(taken[i].tree), i + 1) << "nearest first, none thicker, none below 10 cm";
        }
    }
    // Half of the dying fall. The neighbours stand in a row at 2, 4, 6 and 8 m. A strip of 3 m to each side
    // holds the first in half of all directions, and one at a distance d above 3 m where its angle is below
    // asin(3 / d).
    const auto share_of = [](double distance_m) {
        return distance_m <= 3.0 ? 0.5 : std::asin(3.0 / distance_m) / std::numbers::pi;
    };
    const std::array<double, 4> shares = {1.0 - share_of(2.0), share_of(2.0) - share_of(4.0),
                                          share_of(4.0) - share_of(6.0), share_of(6.0)};
    for (std::size_t number = 0; number < 4; ++number) {
        const double standing = number == 0 ? (1.0 - falls_alive_share) * deaths : 0.0;
        const double expected = standing + falls_alive_share * deaths * shares[number];
        EXPECT_NEAR(numbers[number], expected, 4.0 * std::sqrt(expected)) << number;
    }
}

TEST(TakenAlong, NobodyStandsBeyondTenMetres) {
    const Stand stand = around_a_giant();
    const std::vector<std::size_t> last{5};
    for (std::uint32_t replicate = 0; replicate < 100; ++replicate) {
        for (const Removal& removal : taken_along(stand, last, 1, replicate)) {
            EXPECT_LT(number_of(removal.tree), 5U);
        }
    }
    EXPECT_TRUE(taken_along(stand, {}, 1, 0).empty());
}

}  // namespace
}  // namespace forest::canopy_deaths_test
