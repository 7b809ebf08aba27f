#include "forest/year.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstring>

#include "forest/inventory/tables.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::year_test {
namespace {

void expect_invariants(const Stand& before, const Stand& after, const SpeciesTable& species) {
    for (const Tree& tree : after.trees()) {
        const HeightGrowth& limits = species[tree.species].height_growth;
        RC_ASSERT(tree.above_ground_kg > 0.0);
        RC_ASSERT(tree.height_m <= limits.max_height_m);
        RC_ASSERT(tree.dbh_cm <= limits.max_dbh_cm);
        RC_ASSERT(tree.light_ratio >= 0.0 && tree.light_ratio <= 1.0);
        RC_ASSERT(tree.crown.base_m >= 0.0 && tree.crown.base_m < tree.height_m);
        RC_ASSERT(tree.crown.leaf_area_m2 > 0.0);
        const auto old = before.find(tree.id);
        if (old) {
            RC_ASSERT(tree.height_m >= before.trees()[*old].height_m);
            RC_ASSERT(tree.dbh_cm >= before.trees()[*old].dbh_cm);
            RC_ASSERT(tree.crown.base_m >= before.trees()[*old].crown.base_m);
        }
    }
}

void expect_balance(const Stand& stand) {
    const StandBalance balance = stand.total_balance();
    RC_ASSERT(stand.stems_at_start() + balance.all_stems_in() ==
              balance.all_stems_out() + stand.stems_standing());
    const double mass_in_kg =
        stand.mass_at_start_kg() + balance.mass_in_kg + balance.grown_kg - balance.shed_kg;
    const double mass_out_kg = balance.all_lost_kg() + stand.mass_standing_kg();
    RC_ASSERT(std::abs(mass_in_kg - mass_out_kg) <= 1e-9 * (mass_in_kg + 1.0));
    const double dead_kg = balance.dead_wood_in_kg - balance.all_dead_wood_out_kg();
    RC_ASSERT(std::abs(stand.dead_wood_kg() - dead_kg) <= 1e-9 * (mass_in_kg + 1.0));
}

TEST(GrowYear, KeepsItsInvariantsOnAnyStand) {
    const SmallForest forest{square_of_forest(6)};
    EXPECT_TRUE(rc::check("trees do not shrink, nothing is lost", [&forest] {
        const auto count = *rc::gen::inRange<std::size_t>(0, 400);
        const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
        Stand stand{forest.grid, forest.species.size(), any_trees(forest.grid, forest.species, count, seed),
                    2000};
        for (int year = 0; year < 3; ++year) {
            const Stand before = stand;
            const YearReport report = forest.grow(stand, seed);
            const StandBalance& balance = stand.balance();
            const double stems_kg = before.stem_mass_standing_kg() + balance.stem_in_kg +
                                    balance.stem_grown_kg - balance.all_stem_lost_kg();
            RC_ASSERT(std::abs(stand.stem_mass_standing_kg() - stems_kg) <= 1e-9 * (stems_kg + 1.0));
            expect_invariants(before, stand, forest.species);
            expect_balance(stand);
            const WaterYear& water = report.water;
            RC_ASSERT(std::abs(water.precipitation_mm - water.evapotranspiration_mm - water.runoff_mm -
                               water.storage_gain_mm) < 1e-6);
        }
    }));
}

TEST(GrowYear, GivesTheSameBytesForAnyOrderOfTrees) {
    const SmallForest forest{square_of_forest(5)};
    std::vector<Tree> trees = any_trees(forest.grid, forest.species, 300, 11);
    Stand straight{forest.grid, forest.species.size(), trees, 2000};
    std::reverse(trees.begin(), trees.end());
    std::rotate(trees.begin(), trees.begin() + 77, trees.end());
    Stand permuted{forest.grid, forest.species.size(), trees, 2000};
    for (int year = 0; year < 5; ++year) {
        static_cast<void>(forest.grow(straight));
        static_cast<void>(forest.grow(permuted));
    }
    ASSERT_EQ(straight.trees().size(), permuted.trees().size());
    for (std::size_t i = 0; i < straight.trees().size(); ++i) {
        EXPECT_EQ(straight.trees()[i].id, permuted.trees()[i].id);
        EXPECT_EQ(straight.trees()[i].dbh_cm, permuted.trees()[i].dbh_cm);
        EXPECT_EQ(straight.trees()[i].height_m, permuted.trees()[i].height_m);
        EXPECT_EQ(straight.trees()[i].x_m, permuted.trees()[i].x_m);
        EXPECT_EQ(straight.trees()[i].crown, permuted.trees()[i].crown);
    }
}

TEST(GrowYear, OfAMirroredStandIsTheMirrorOfTheYear) {
    // The slope faces south, so that its mirror image is itself; deaths aside, which one hair's breadth of
    // light can decide. Light within cells is interpolated between nodes that rounding can move by a leaf
    // (tests/forest/light/stand_light_test.cpp).
    constexpr double interpolation = 0.1;
    SmallForest forest{square_of_forest(6)};
    forest.parameters.processes.self_thinning = false;
    forest.parameters.mortality.stress = false;
    forest.parameters.mortality.background = false;  // falls on neighbours in a direction that has no mirror
    EXPECT_TRUE(rc::check("trees grow alike", [&] {
        const auto stems_pha = static_cast<double>(*rc::gen::inRange(100, 2000));
        const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
        const std::vector<Tree> trees = mixed_stand(forest, stems_pha, seed);
        std::vector<Tree> mirrored = trees;
        for (Tree& tree : mirrored) {
            tree.x_m = forest.grid.frame().x_east_m() - tree.x_m;
        }
        Stand one{forest.grid, forest.species.size(), trees, 2000};
        Stand other{forest.grid, forest.species.size(), mirrored, 2000};
        static_cast<void>(forest.grow(one));
        static_cast<void>(forest.grow(other));
        for (const Tree& tree : one.trees()) {
            const auto image = other.find(tree.id);
            if (number_of(tree.id) >= trees.size()) {
                continue;  // left a group this year, at a place drawn for it
            }
            RC_ASSERT(image.has_value());
            const Tree& there = other.trees()[*image];
            RC_ASSERT(std::abs(there.light_ratio - tree.light_ratio) < interpolation);
            RC_ASSERT(std::abs(there.dbh_cm - tree.dbh_cm) < interpolation * (1.0 + tree.increments_cm[0]));
        }
        for (std::size_t p = 0; p < forest.grid.size(); ++p) {
            const config::Cell cell = forest.grid.patches()[p].cell;
            const auto image = *forest.grid.at({forest.grid.frame().columns - 1 - cell.column, cell.row});
            RC_ASSERT(std::abs(one.patch_states()[p].ground_light -
                               other.patch_states()[index_of(image)].ground_light) < 4e-3);
        }
    }));
}

TEST(GrowYear, WorksWithoutTreesAndWithOneTreeOnOnePatch) {
    const SmallForest forest{square_of_forest(1)};
    Stand empty{forest.grid, forest.species.size(), {}, 2000};
    const YearReport report = forest.grow(empty);
    EXPECT_EQ(report.production_kg, 0.0);
    EXPECT_NEAR(empty.patch_states()[0].ground_light, 1.0, 0.01);

    std::vector<Tree> one = any_trees(forest.grid, forest.species, 1, 5);
    one[0] = new_tree(forest.species[SpeciesId{0}], SpeciesId{0}, 5.0, 5.0, 20.0, 15.0, 40.0);
    Stand alone{forest.grid, forest.species.size(), one, 2000};
    static_cast<void>(forest.grow(alone));
    ASSERT_EQ(alone.trees().size(), 1U);
    EXPECT_GT(alone.trees()[0].dbh_cm, 20.1);
    EXPECT_GT(alone.trees()[0].light_ratio, 0.5);
}

TEST(GrowYear, SharesOutExactlyWhatAUnitProduces) {
    // No tree at a limit and none failing: what grew above ground is production minus roots.
    const SmallForest forest{square_of_forest(4)};
    StandRecord record;
    for (std::uint32_t i = 0; i < 16; ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = *forest.species.find("piab"), .stems_pha = 600.0, .mean_dbh_cm = 25.0}};
    record.degree_days = 1300.0;
    Stand stand{forest.grid, forest.species.size(),
                trees_from_record(record, forest.grid, forest.species, 1, 0, 0), 2000};
    const YearReport report = forest.grow(stand);
    EXPECT_GT(report.production_kg, 0.0);
    EXPECT_LT(stand.balance().grown_kg, report.production_kg);
    EXPECT_GT(stand.balance().grown_kg, 0.5 * report.production_kg);
    EXPECT_NEAR(report.light_closure, 1.0, 0.05);
}

TEST(GrowYear, GrowsLikeTreesApartAndKeepsWhatTheyMakeTogether) {
    SmallForest forest{square_of_forest(5)};
    forest.parameters.mortality.background = forest.parameters.mortality.stress = false;
    forest.parameters.processes.self_thinning = forest.parameters.processes.regeneration = false;
    std::vector<Tree> trees;
    const SpeciesId spruce = *forest.species.find("piab");
    for (int i = 0; i < 100; ++i) {
        trees.push_back(new_tree(forest.species[spruce], spruce, 2.5 + 5.0 * (i % 10), 2.5 + 5.0 * (i / 10),
                                 15.0, 14.0, 40.0));
        trees.back().id = TreeId{static_cast<std::uint64_t>(i)};
    }
    struct After {
        double mean_growth_cm = 0.0;
        double relative_spread = 0.0;
    };
    const auto after = [&](double spread) {
        forest.parameters.differences.growth = spread;
        Stand stand{forest.grid, forest.species.size(), trees, 2000};
        for (int year = 0; year < 10; ++year) {
            static_cast<void>(forest.grow(stand));
        }
        double sum = 0.0;
        double squares = 0.0;
        for (const Tree& tree : stand.trees()) {
            sum += tree.dbh_cm - 15.0;
            squares += (tree.dbh_cm - 15.0) * (tree.dbh_cm - 15.0);
        }
        const double mean = sum / 100.0;
        return After{mean, std::sqrt(squares / 100.0 - mean * mean) / mean};
    };
    const After like = after(0.0);
    const After unlike = after(0.3);
    EXPECT_LT(like.relative_spread, 0.15);
    EXPECT_GT(unlike.relative_spread, 0.2);
    EXPECT_LT(unlike.relative_spread, 0.5);
    EXPECT_NEAR(unlike.mean_growth_cm, like.mean_growth_cm, 0.06 * like.mean_growth_cm);
}

TEST(GrowYear, NeverExceedsTheSelfThinningLineForLong) {
    const SmallForest forest{square_of_forest(5)};
    StandRecord record;
    for (std::uint32_t i = 0; i < 25; ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = *forest.species.find("piab"), .stems_pha = 2500.0, .mean_dbh_cm = 9.0},
                      {.species = *forest.species.find("fasy"), .stems_pha = 1000.0, .mean_dbh_cm = 8.0}};
    record.degree_days = 1300.0;
    Stand stand{forest.grid, forest.species.size(),
                trees_from_record(record, forest.grid, forest.species, 1, 0, 0), 2000};
    double densest = 0.0;
    int years_above = 0;
    for (int year = 0; year < 60; ++year) {
        static_cast<void>(forest.grow(stand));
        for (const double density : relative_densities(stand, forest.species, forest.site.windows())) {
            years_above = density > 1.1 ? years_above + 1 : 0;
            densest = std::max(densest, density);
        }
        EXPECT_LE(years_above, 5);
    }
    EXPECT_GT(densest, 0.8) << "an unmanaged stand comes near the line";
}

TEST(GrowYear, KillsASmallShareOfTreesWithoutCrowding) {
    // Background deaths stay within 0.05 and 1 % a year.
    const SmallForest forest{square_of_forest(10)};
    StandRecord record;
    for (std::uint32_t i = 0; i < 100; ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = *forest.species.find("piab"), .stems_pha = 300.0, .mean_dbh_cm = 25.0}};
    record.degree_days = 1300.0;
    Stand stand{forest.grid, forest.species.size(),
                trees_from_record(record, forest.grid, forest.species, 1, 0, 0), 2000};
    double tree_years = 0.0;
    for (int year = 0; year < 30; ++year) {
        tree_years += static_cast<double>(stand.stems_standing());
        static_cast<void>(forest.grow(stand));
    }
    const double rate =
        static_cast<double>(stand.total_balance().stems_out[index_of(Cause::background)]) / tree_years;
    EXPECT_GT(rate, 0.0005);
    EXPECT_LT(rate, 0.01);
}

TEST(GrowYear, HasNoDeathsAndNoSaplingsWhereTheirProcessesAreOff) {
    SmallForest forest{square_of_forest(5)};
    forest.parameters.mortality.background = false;
    forest.parameters.mortality.stress = false;
    forest.parameters.processes.self_thinning = false;
    forest.parameters.processes.regeneration = false;
    Stand stand{forest.grid, forest.species.size(), mixed_stand(forest, 3000.0, 1), 2000};
    const std::uint64_t stems = stand.stems_standing();
    for (int year = 0; year < 5; ++year) {
        static_cast<void>(forest.grow(stand));
    }
    EXPECT_EQ(stand.total_balance().all_stems_out(), 0U);
    EXPECT_EQ(stand.total_balance().saplings_in, 0U);
    EXPECT_EQ(stand.stems_standing(), stems);
}

TEST(GrowYear, GrowsMoreInADryClimateWithoutWaterLimits) {
    SmallForest forest{square_of_forest(5)};
    for (ClimateYear& unit : forest.weather) {
        for (ClimateMonth& month : unit.months) {
            month.prec_mm = 20.0;
        }
    }
    Stand limited{forest.grid, forest.species.size(), mixed_stand(forest, 1000.0, 1), 2000};
    Stand unlimited = limited;
    for (int year = 0; year < 3; ++year) {
        forest.parameters.processes.water = true;
        const double in_drought_kg = forest.grow(limited).production_kg;
        forest.parameters.processes.water = false;
        EXPECT_GT(forest.grow(unlimited).production_kg, in_drought_kg);
    }
}

TEST(GrowYear, GrowsAboutTheSameInLightByLayersOnLevelGround) {
    SmallForest forest{square_of_forest(5, 0.0)};
    Stand in_space{forest.grid, forest.species.size(), mixed_stand(forest, 2000.0, 1), 2000};
    Stand by_layers = in_space;
    const double in_space_m3 = forest.grow(in_space).volume_increment_m3;
    forest.parameters.processes.light = TreeLight::by_layers;
    const double by_layers_m3 = forest.grow(by_layers).volume_increment_m3;
    EXPECT_NE(by_layers_m3, in_space_m3);
    EXPECT_NEAR(by_layers_m3 / in_space_m3, 1.0, 0.2);
}

TEST(GrowYear, FindsNearlyTheSameWoodInLightByLayersAfterDecades) {
    const auto volume_m3pha = [](TreeLight light) {
        SmallForest forest{square_of_forest(5, 0.0)};
        forest.parameters.processes.light = light;
        Stand stand{forest.grid, forest.species.size(), mixed_stand(forest, 2000.0, 1), 2000};
        for (int year = 0; year < 40; ++year) {
            static_cast<void>(forest.grow(stand));
        }
        return figures_of(stand.trees(), forest.species, stand.grid().area_ha()).volume_m3pha;
    };
    EXPECT_NEAR(volume_m3pha(TreeLight::by_layers) / volume_m3pha(TreeLight::in_space), 1.0, 0.1);
}

}  // namespace
}  // namespace forest::year_test
