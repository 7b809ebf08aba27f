#include "forest/deaths/canopy_deaths.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/forest/small_forest.hpp"

namespace forest::canopy_deaths_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");
const SpeciesId beech = *table.find("fasy");
constexpr bool storms = true;
constexpr CanopyPlace usual_place{};

/// That of a tree of no size and age: of its rank alone.
double of_rank(const Species& kind, const CanopyPlace& place = usual_place) {
    return canopy_death(kind, 0.0, 0.0, place, {}, !storms);
}

TEST(CanopyDeath, RisesWithTheSixthPowerOfTheDiameter) {
    const CanopyDeaths law;
    const auto of_size = [&](SpeciesId kind, double dbh_cm) {
        return canopy_death(table[kind], dbh_cm, 0.0, usual_place, law, !storms) - of_rank(table[kind]);
    };
    EXPECT_NEAR(of_size(spruce, 100.0), law.by_size, 1e-12);
    EXPECT_NEAR(of_size(spruce, 50.0), law.by_size / 64.0, 1e-12);
    EXPECT_NEAR(of_size(beech, 100.0), law.broadleaves * law.by_size, 1e-12);
}

TEST(CanopyDeath, OfYoungTreesIsAShareOfALifeAndMoreOftenUnderThickerOnes) {
    const CanopyDeaths law;
    for (const Species& kind : table.all()) {
        EXPECT_NEAR(of_rank(kind) * kind.mortality.max_age_years, law.at_any_age, 1e-12);
        EXPECT_NEAR(of_rank(kind, {.larger_m2pha = law.larger_m2pha}) / of_rank(kind), std::exp(1.0), 1e-9);
    }
}

TEST(CanopyDeath, OfOrdinaryStandsIsThatOfInventories) {
    // 0.2 to 0.4 % of the stems a year in inventories, half of it by suppression; 0.45 and 0.32 % of spruces
    // and firs from 70 cm on (Vieilledent et al. 2010).
    for (const SpeciesId kind : {spruce, beech}) {
        const CanopyPlace dense{.crowding = canopy_crowding(45.0, {}), .larger_m2pha = 20.0};
        EXPECT_LT(canopy_death(table[kind], 30.0, 80.0, dense, {}, !storms), 0.004);
        EXPECT_GT(canopy_death(table[kind], 30.0, 80.0, dense, {}, !storms), 0.0008);
    }
    EXPECT_NEAR(canopy_death(table[spruce], 75.0, 150.0, usual_place, {}, !storms), 0.0045, 0.0015);
}

TEST(CanopyDeath, OfOldTreesIsHalfReachedAtAThirdOfTheGreatestAge) {
    const CanopyDeaths law;
    const auto of_years = [&](double share, double crowding) {
        // No tree dies of its greatest age yet: below 1e-4 at 0.35 of it.
        return canopy_death(table[spruce], 0.0, share * table[spruce].mortality.max_age_years,
                            {.crowding = crowding}, law, !storms) -
               of_rank(table[spruce]);
    };
    EXPECT_NEAR(of_years(law.half_old, 1.0), 0.5 * law.when_old, 1e-4);
    EXPECT_NEAR(of_years(law.half_old, 2.0), law.when_old, 1e-4);
    EXPECT_NEAR(of_years(0.5 * law.half_old, 1.0), law.when_old / 17.0, 1e-6);
}

TEST(CanopyDeath, NeverFallsWithAgeSizeWarmthOrCrowding) {
    const CanopyPlace dense{.crowding = 2.0, .warmth = 1.2, .larger_m2pha = 30.0};
    for (const Species& kind : table.all()) {
        for (double age = 0.0; age < 1.2 * kind.mortality.max_age_years; age += 7.0) {
            const double here = canopy_death(kind, 40.0, age, dense, {}, !storms);
            EXPECT_GE(here, 0.0);
            EXPECT_LE(here, 1.0);
            EXPECT_GE(canopy_death(kind, 40.0, age + 7.0, dense, {}, !storms), here);
            EXPECT_GE(canopy_death(kind, 50.0, age, dense, {}, !storms), here);
            for (const CanopyPlace& worse :
                 {CanopyPlace{2.5, 1.2, 30.0}, CanopyPlace{2.0, 1.3, 30.0}, CanopyPlace{2.0, 1.2, 40.0}}) {
                EXPECT_GE(canopy_death(kind, 40.0, age, worse, {}, !storms), here);
            }
        }
    }
}

TEST(CanopyDeath, LeavesRoomForStormsWhereTheyAreSimulated) {
    const double alone = canopy_death(table[spruce], 60.0, 0.0, usual_place, {}, !storms);
    EXPECT_NEAR(canopy_death(table[spruce], 60.0, 0.0, usual_place, {}, storms), 0.9 * alone, 1e-12);
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

TEST(CanopyDeath, OfWarmPlacesIsMoreOftenButNotAtTheGreatestAge) {
    const auto of = [](double dbh_cm, double age_years, double warmth) {
        return canopy_death(table[spruce], dbh_cm, age_years, {.warmth = warmth}, {}, !storms);
    };
    EXPECT_NEAR(of(0.0, 0.0, 1.3) / of(0.0, 0.0, 1.0), 1.3, 1e-12);
    EXPECT_NEAR(of(100.0, 0.0, 1.3) / of(100.0, 0.0, 1.0), 1.3, 1e-12);
    EXPECT_LT(of(0.0, 500.0, 1.3) / of(0.0, 500.0, 1.0), 1.15);
}

TEST(CanopyDeath, OfAgeTakesOldTreesAndSparesThoseOfHalfTheGreatestAge) {
    const auto of_age = [](double share_of_greatest) {
        CanopyDeaths none;
        none.at_any_age = none.when_old = 0.0;
        const double greatest = table[beech].mortality.max_age_years;
        return canopy_death(table[beech], 0.0, share_of_greatest * greatest, usual_place, none, !storms);
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

/// Stems that are gone after a year in which trees of the canopy alone die, at a factor of warmth.
double deaths_in_a_year(double factor) {
    SmallForest forest{square_of_forest(10)};
    CanopyDeaths& law = forest.parameters.mortality.canopy;
    law.at_any_age = 60.0;
    law.larger_m2pha = 1e9;
    law.when_old = 0.0;
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
