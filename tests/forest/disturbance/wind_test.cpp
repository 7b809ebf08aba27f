#include "forest/disturbance/wind.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <numbers>

#include "forest/deadwood/deadwood.hpp"
#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::wind_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");
const SpeciesId fir = *table.find("abal");
const SpeciesId beech = *table.find("fasy");

double death(SpeciesId species, double dbh_cm, double intensity) {
    return storm_death(storm_response_of(table[species]), dbh_cm, dbh_cm, intensity);
}

TEST(StormIntensity, IsTheQuantileOfABetaDistribution) {
    const boost::math::beta_distribution<double> published{1.2, 4.0};
    for (const double u : {0.0, 1e-6, 0.01, 0.3, 0.5, 0.9, 0.999, 1.0 - 1e-9}) {
        EXPECT_NEAR(storm_intensity(u), boost::math::quantile(published, u), 1e-9) << u;
    }
}

TEST(StormDeath, GivesThePublishedShares) {
    EXPECT_NEAR(death(spruce, 30.0, 0.3), 0.048, 0.0005);
    EXPECT_NEAR(death(spruce, 30.0, 0.6), 0.20, 0.005);
    EXPECT_NEAR(death(spruce, 30.0, 1.0), 0.69, 0.005);
    EXPECT_NEAR(death(fir, 30.0, 0.6), 0.098, 0.0005);
    EXPECT_NEAR(death(beech, 30.0, 0.6), 0.047, 0.0005);
}

TEST(StormDeath, RisesWithIntensityAndWithTheSizeOfTheStand) {
    for (const SpeciesId species : {spruce, fir, beech}) {
        for (double intensity = 0.1; intensity < 1.0; intensity += 0.1) {
            EXPECT_GT(death(species, 30.0, intensity + 0.05), death(species, 30.0, intensity));
            EXPECT_GT(death(species, 50.0, intensity), death(species, 25.0, intensity));
        }
    }
    // Scots pine is the one species that the published law makes safer with size.
    const SpeciesId pine = *table.find("pisy");
    EXPECT_LT(death(pine, 50.0, 0.6), death(pine, 25.0, 0.6));
}

TEST(StormOfYear, ComesAsOftenAndAsStrongAsItsLawSays) {
    constexpr int years = 100'000;
    const DisturbanceLaw law{.wind = true, .storm_interval_years = 25.0};
    int storms = 0;
    double sum = 0.0;
    for (int i = 0; i < years; ++i) {
        if (const auto storm = storm_of_year(law, 3, static_cast<std::uint32_t>(i / 1000), i % 1000)) {
            ++storms;
            sum += storm->intensity;
        }
    }
    constexpr double p = 1.0 / 25.0;
    EXPECT_NEAR(storms / static_cast<double>(years), p, 4.0 * std::sqrt(p * (1.0 - p) / years));
    constexpr double mean = 1.2 / 5.2;
    const double variance = 1.2 * 4.0 / (5.2 * 5.2 * 6.2);
    EXPECT_NEAR(sum / storms, mean, 4.0 * std::sqrt(variance / storms));
}

TEST(StormOfYear, ComesWhereItIsAskedForAndChangesNoOtherYear) {
    const DisturbanceLaw by_chance{.wind = true};
    const DisturbanceLaw asked{.wind = true, .storm_years = {2040.0}, .intensity_asked_for = 0.8};
    const DisturbanceLaw alone{.storm_years = {2040.0}, .intensity_asked_for = 0.8};
    for (int year = 2000; year < 2100; ++year) {
        const auto chance = storm_of_year(by_chance, 3, 0, year);
        const auto with = storm_of_year(asked, 3, 0, year);
        const auto without = storm_of_year(alone, 3, 0, year);
        if (year == 2040) {
            ASSERT_TRUE(with && without);
            EXPECT_EQ(with->intensity, 0.8);
            EXPECT_EQ(without->intensity, 0.8);
            EXPECT_EQ(with->towards_rad, without->towards_rad);
            continue;
        }
        EXPECT_FALSE(without);
        ASSERT_EQ(with.has_value(), chance.has_value());
        if (chance) {
            EXPECT_EQ(with->intensity, chance->intensity);
        }
    }
}

TEST(UprootedShare, IsLargerForStoutTreesAndSmallerForRottenOnes) {
    const Tree stout = new_tree(table[spruce], spruce, 5.0, 5.0, 50.0, 30.0, 120.0);
    const Tree slender = new_tree(table[spruce], spruce, 5.0, 5.0, 20.0, 22.0, 60.0);
    Tree rotten = stout;
    rotten.rot = {.since_year = 1990, .from_m = 0.0F, .to_m = 3.0F, .depth_cm = 20.0F};
    // Anchorage times green mass against MOR * pi D^3 / 32.
    const double roots_nm = table[spruce].wind.anchorage_nmpkg * 1.85 * 430.0 *
                            stem_volume_m3(table[spruce].allometry, stout.dbh_cm, stout.height_m);
    const double stem_nm = 1e6 * table[spruce].wind.rupture_mpa * std::numbers::pi * 0.125 / 32.0;
    EXPECT_NEAR(uprooted_share(table[spruce], stout), 1.0 / (1.0 + std::pow(roots_nm / stem_nm, 5.0)), 1e-9);
    EXPECT_GT(uprooted_share(table[spruce], stout), uprooted_share(table[spruce], slender));
    EXPECT_LT(uprooted_share(table[spruce], rotten), uprooted_share(table[spruce], stout));
}

/// Equal trees on one patch.
Stand equal_trees(const PatchGrid& grid, SpeciesId species, double dbh_cm, double height_m,
                  std::size_t count) {
    std::vector<Tree> trees(count, new_tree(table[species], species, 5.0, 5.0, dbh_cm, height_m, 80.0));
    for (std::size_t i = 0; i < count; ++i) {
        trees[i].id = TreeId{i};
    }
    Stand stand{grid, table.size(), trees, 2000};
    stand.begin_year();
    return stand;
}

TEST(ThrowByWind, TakesTheShareThatItsChanceSaysAndLeavesItAsWood) {
    constexpr std::size_t count = 20'000;
    const PatchGrid grid = square_of_forest(1);
    const ThinningWindows windows{grid};
    Stand stand = equal_trees(grid, spruce, 30.0, 25.0, count);
    const Tree one = stand.trees()[0];
    const Storm storm{0.6, 1.0};
    throw_by_wind(stand, table, windows, storm, 1, 0);

    const auto thrown = static_cast<double>(count - stand.trees().size());
    const double p = death(spruce, 30.0, 0.6);
    EXPECT_NEAR(thrown / count, p, 4.0 * std::sqrt(p * (1.0 - p) / count));
    EXPECT_EQ(stand.balance().stems_out[index_of(Cause::wind)], thrown);
    EXPECT_NEAR(stand.balance().lost_kg[index_of(Cause::wind)], thrown * one.above_ground_kg, 1e-6);

    const SnagsAndLogs& wood = stand.dead_wood();
    ASSERT_EQ(static_cast<double>(wood.logs.size()), thrown);
    const double broken = static_cast<double>(wood.snags.size()) / thrown;
    const double break_share = 1.0 - uprooted_share(table[spruce], one);
    EXPECT_NEAR(broken, break_share, 4.0 * std::sqrt(break_share * (1.0 - break_share) / thrown));
    for (const Log& log : wood.logs) {
        EXPECT_EQ(log.origin, LogOrigin::windthrow);
        EXPECT_NEAR(log.direction_rad, storm.towards_rad, std::numbers::pi / 6.0 + 1e-9);
    }
    for (const Snag& stump : wood.snags) {
        EXPECT_GE(stump.height_m, 1.0);
        EXPECT_LE(stump.height_m, 5.0);
    }
    // However a stem breaks, its wood stays.
    EXPECT_GT(one.stem_kg, 0.0);
    EXPECT_NEAR(stand.dead_wood_kg(), thrown * one.stem_kg, 1e-9 * stand.dead_wood_kg());
}

TEST(ThrowByWind, SparesThinTreesAndBroadleavesMore) {
    const PatchGrid grid = square_of_forest(1);
    const ThinningWindows windows{grid};
    Stand thin = equal_trees(grid, spruce, 9.9, 10.0, 500);
    throw_by_wind(thin, table, windows, {1.0, 0.0}, 1, 0);
    EXPECT_EQ(thin.trees().size(), 500U);

    Stand spruces = equal_trees(grid, spruce, 30.0, 25.0, 2000);
    Stand beeches = equal_trees(grid, beech, 30.0, 25.0, 2000);
    throw_by_wind(spruces, table, windows, {0.8, 0.0}, 1, 0);
    throw_by_wind(beeches, table, windows, {0.8, 0.0}, 1, 0);
    EXPECT_LT(spruces.trees().size(), beeches.trees().size());
}

}  // namespace
}  // namespace forest::wind_test
