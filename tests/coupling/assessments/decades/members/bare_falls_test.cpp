#include "coupling/assessments/decades/members/bare_falls.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "coupling/inputs/forest/forest_site.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::decades::bare_falls_test {
namespace {

/// A slope with rocks in each second of 44 years.
struct BareSlope {
    ForestProject project;
    Opened opened{open(project, {"release.rocks=200", "run.years=44", "run.rockfall_every=2",
                                 "climate.sequence=repeat", "output.map_years=0, 18"})};
    exchange::YearlyRockfall season{*opened.scenario, *opened.site, {}, {}};
    YearBlocks blocks{*opened.scenario};
    Parts parts{project.folder(), "0123456789abcdef"};
};

TEST(YearBlocks, HoldEachYearWithRocksOnce) {
    const BareSlope slope;
    ASSERT_EQ(slope.blocks.count(), 3U);
    std::int32_t expected = 0;
    for (std::size_t block = 0; block < slope.blocks.count(); ++block) {
        for (const std::int32_t year : slope.blocks.years(block)) {
            EXPECT_EQ(year, expected);
            EXPECT_EQ(slope.blocks.block_of(year), block) << year;
            expected += 2;
        }
    }
    EXPECT_EQ(expected, 46);
    EXPECT_TRUE(slope.blocks.with_cells(18));
    EXPECT_FALSE(slope.blocks.with_cells(20));
}

TEST(BareFalls, ComeBackFromTheirPartsAsTheyWere) {
    const BareSlope slope;
    RankGroup alone{RankGroup::Alone{}};
    const std::vector<YearsToCome> replicates{{1, 0}};
    make_bare_falls(slope.season, slope.blocks, replicates, slope.parts, {}, {alone, 2, true});
    EXPECT_FALSE(slope.parts.has_bare(0, 0));
    BareFalls falls{slope.blocks, slope.parts, 1};
    for (const std::int32_t year : {0, 18, 20, 44}) {
        const exchange::BareYear expected =
            slope.season.simulate_bare(1, year, slope.blocks.with_cells(year), 1);
        const exchange::BareYear& found = falls.at(year);
        EXPECT_EQ(found.year, year);
        EXPECT_GT(expected.run.rocks, 190U);
        EXPECT_EQ(found.run.rocks, expected.run.rocks);
        EXPECT_EQ(found.run.run_out, expected.run.run_out);
        EXPECT_EQ(found.run.max_energy, expected.run.max_energy);
        EXPECT_EQ(found.run.max_height_m, expected.run.max_height_m);
        ASSERT_EQ(found.targets.size(), 2U);
        EXPECT_EQ(found.targets[0].height, expected.targets[0].height);
        EXPECT_EQ(found.at_targets, expected.at_targets);
        EXPECT_EQ(found.arrived, expected.arrived);
        ASSERT_EQ(found.cells.size(), expected.cells.size());
        EXPECT_EQ(found.cells.empty(), !slope.blocks.with_cells(year));
        EXPECT_TRUE(found.cells.empty() || std::memcmp(found.cells.begin(), expected.cells.begin(),
                                                       found.cells.size() * sizeof(found.cells[0])) == 0);
    }
}

TEST(BareFalls, AreMadeOfTheYearsToComeInWholeBlocks) {
    const BareSlope slope;
    RankGroup alone{RankGroup::Alone{}};
    const std::vector<YearsToCome> replicates{{0, 41}, {1, 18}};
    make_bare_falls(slope.season, slope.blocks, replicates, slope.parts, {}, {alone, 2, true});
    for (std::size_t block = 0; block < 3; ++block) {
        EXPECT_EQ(slope.parts.has_bare(0, block), block == 2) << "years 40, 42 and 44";
        EXPECT_TRUE(slope.parts.has_bare(1, block)) << "years 0 to 18 are one block";
    }
}

TEST(BareFalls, MarkEachArrivalOfARock) {
    const BareSlope slope;
    const exchange::BareYear bare = slope.season.simulate_bare(0, 1, false, 1);
    for (std::size_t target = 0; target < bare.targets.size(); ++target) {
        std::uint64_t marked = 0;
        for (std::uint64_t rock = 0; rock < slope.season.rocks(); ++rock) {
            marked += bare.has_arrived(rock, target) ? 1 : 0;
        }
        EXPECT_EQ(marked, bare.targets[target].reached);
    }
    EXPECT_GT(bare.targets[0].reached, 0U);
}

TEST(BareFalls, OfOtherSettingsOrCutOffAreRefused) {
    const BareSlope slope;
    const std::vector<exchange::BareYear> bare{slope.season.simulate_bare(0, 0, false, 1)};
    slope.parts.keep_bare(0, 0, bare);
    const Parts others{slope.project.folder(), "fedcba9876543210"};
    EXPECT_THROW(static_cast<void>(others.read_bare(0, 0)), config::InputError);
    const std::string part = slope.project.read("bare_1_1.part");
    slope.project.write("bare_1_1.part", part.substr(0, part.size() - 9));
    EXPECT_THROW(static_cast<void>(slope.parts.read_bare(0, 0)), config::InputError);
}

}  // namespace
}  // namespace coupling::decades::bare_falls_test
