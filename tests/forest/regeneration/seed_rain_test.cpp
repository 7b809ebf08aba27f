#include "forest/regeneration/seed_rain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/forest/small_forest.hpp"

namespace forest::seed_rain_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();

TEST(KernelOf, IsMadeOnceForTheSameSeeds) {
    const Seeds& spruce = table[*table.find("piab")].seeds;
    const Seeds& beech = table[*table.find("fasy")].seeds;
    const SeedKernel& first = kernel_of(spruce);
    EXPECT_NE(&first, &kernel_of(beech));
    EXPECT_EQ(&first, &kernel_of(spruce)) << "as every year asks for it";
    EXPECT_EQ(kernel_of(beech).at(1, 2), SeedKernel{beech}.at(1, 2));
}

TEST(SeedKernel, SharesOutEverySeedOnce) {
    for (const Species& kind : table.all()) {
        const SeedKernel kernel{kind.seeds};
        double sum = 0.0;
        for (int rows = -kernel.reach(); rows <= kernel.reach(); ++rows) {
            for (int columns = -kernel.reach(); columns <= kernel.reach(); ++columns) {
                EXPECT_GE(kernel.at(columns, rows), 0.0);
                EXPECT_FLOAT_EQ(static_cast<float>(kernel.at(columns, rows)),
                                static_cast<float>(kernel.at(rows, -columns)));
                sum += kernel.at(columns, rows);
            }
        }
        EXPECT_NEAR(sum, 1.0, 1e-5) << kind.code;
        EXPECT_EQ(kernel.at(kernel.reach() + 1, 0), 0.0);
    }
}

TEST(SeedKernel, LandsSeedsAtTheDistancesOfItsLaw) {
    // Without animals the share beyond a distance is exp(-r / a).
    const Seeds& seeds = table[*table.find("piab")].seeds;
    const SeedKernel kernel{seeds};
    double beyond = 0.0;
    for (int rows = -kernel.reach(); rows <= kernel.reach(); ++rows) {
        for (int columns = -kernel.reach(); columns <= kernel.reach(); ++columns) {
            beyond += std::hypot(rows, columns) > 10.0 ? kernel.at(columns, rows) : 0.0;
        }
    }
    const double law = std::exp(-100.0 / seeds.kernel_m) - std::exp(-4.0);
    EXPECT_NEAR(beyond, law, 0.01);
}

TEST(CropsOfYear, AreFullAsOftenAsTheIntervalSays) {
    constexpr int years = 20'000;
    std::vector<int> full(table.size(), 0);
    for (int year = 0; year < years; ++year) {
        const std::vector<double> crops = crops_of_year(table, 1, 0, year);
        for (std::size_t s = 0; s < crops.size(); ++s) {
            full[s] += crops[s] == 1.0 ? 1 : 0;
        }
    }
    for (std::size_t s = 0; s < table.size(); ++s) {
        const double p = 1.0 / table.all()[s].seeds.interval_years;
        EXPECT_NEAR(static_cast<double>(full[s]) / years, p, 4.0 * std::sqrt(p * (1.0 - p) / years) + 1e-12)
            << table.all()[s].code;
    }
}

TEST(Spread, LosesNothingWithinReachOfTheEdges) {
    const PatchGrid grid = square_of_forest(45);
    const SeedKernel kernel{table[*table.find("pice")].seeds};
    ASSERT_EQ(kernel.reach(), 80);
    const SeedKernel narrow{Seeds{.kernel_m = 50.0}};
    std::vector<float> sources(grid.size(), 0.0F);
    sources[22 * 45 + 22] = 0.5F;
    const std::vector<float> fallen = spread(grid, sources, narrow);
    EXPECT_NEAR(std::accumulate(fallen.begin(), fallen.end(), 0.0), 0.5, 1e-5);
    EXPECT_FLOAT_EQ(fallen[22 * 45 + 25], static_cast<float>(0.5 * narrow.at(3, 0)));
    EXPECT_FLOAT_EQ(fallen[20 * 45 + 22], static_cast<float>(0.5 * narrow.at(0, -2)));
}

TEST(SeedRain, ComesFromOldLitTreesAndFromOutside) {
    const PatchGrid grid = square_of_forest(3);
    const SpeciesId spruce = *table.find("piab");
    const SpeciesId larch = *table.find("lade");
    std::vector<Tree> trees(3, new_tree(table[spruce], spruce, 15.0, 15.0, 40.0, 30.0, 100.0));
    trees[1] = new_tree(table[spruce], spruce, 5.0, 5.0, 20.0, 15.0, 30.0);  // too young
    trees[2].light_ratio = 0.2;                                              // too dark
    for (std::size_t i = 0; i < trees.size(); ++i) {
        trees[i].id = TreeId{i};
    }
    const Stand stand{grid, table.size(), trees, 2000};
    const std::vector<float> sources = seed_sources(stand, table, spruce);
    EXPECT_NEAR(sources[4], trees[0].crown.leaf_area_m2 / 450.0, 1e-6);
    EXPECT_EQ(std::accumulate(sources.begin(), sources.end(), 0.0F), sources[4]);

    const SeedRain rain{stand, table, std::vector<double>(table.size(), 1.0), {0.02, {spruce}}};
    EXPECT_EQ(rain.seedlings_pm2(larch, PatchId{0}), 0.0);
    EXPECT_GT(rain.seedlings_pm2(spruce, PatchId{0}), 0.02 * table[spruce].seeds.seedlings_pm2);
    EXPECT_GT(rain.seedlings_pm2(spruce, PatchId{4}), rain.seedlings_pm2(spruce, PatchId{0}));
}

}  // namespace
}  // namespace forest::seed_rain_test
