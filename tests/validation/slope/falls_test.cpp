#include "validation/engine/slope/falls.hpp"

#include <gtest/gtest.h>

#include "tests/validation/case_texts.hpp"
#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation::falls_test {
namespace {

Ensembles fall(const CaseFiles& files, const std::vector<std::string>& overrides, int threads = 1,
               bool open_too = false) {
    const ValidationCase of = read_case(files);
    const auto recipe = of.recipe("default", overrides);
    const RebuiltSlope slope = rebuild(*recipe, of.profile(*recipe));
    return simulate_falls(*recipe, slope, {.open_too = open_too, .threads = threads, .fallen = {}});
}

std::vector<double> ends_m(const Falls& falls) {
    std::vector<double> ends;
    for (const RockFacts& rock : falls.rocks) {
        ends.push_back(rock.end_m);
    }
    return ends;
}

std::uint32_t hits_of(const Ensembles& ensembles) {
    std::uint32_t hits = 0;
    for (const Falls& series : ensembles.series) {
        for (const RockFacts& rock : series.rocks) {
            hits += rock.tree_hits;
        }
    }
    return hits;
}

TEST(LetFall, HasAsManyRocksAndSeriesAsAskedFor) {
    std::uint64_t told = 0;
    const ValidationCase of = read_case(testing::even_slope("slope", testing::stand_of_site_2));
    const auto recipe = of.recipe("default", {"stand.stands=7"});
    const RebuiltSlope slope = rebuild(*recipe, of.profile(*recipe));
    const Ensembles all = simulate_falls(
        *recipe, slope, {.open_too = true, .threads = 2, .fallen = [&](std::uint64_t n) { told += n; }});
    EXPECT_EQ(all.large.rocks.size(), 40U);
    EXPECT_EQ(all.open_large.rocks.size(), 40U);
    ASSERT_EQ(all.series.size(), 2U);
    EXPECT_EQ(all.series[1].rocks.size(), 10U);
    EXPECT_EQ(told, rocks_of(*recipe));
    EXPECT_GT(all.large.hit_heights_m.size(), 0U);
    EXPECT_EQ(all.open_large.hit_heights_m.size(), 0U);
}

TEST(LetFall, IsTheSameOnAnyNumberOfThreads) {
    const CaseFiles files = testing::even_slope("slope", testing::stand_of_site_2);
    const Ensembles one = fall(files, {}, 1);
    const Ensembles three = fall(files, {}, 3);
    EXPECT_EQ(ends_m(one.large), ends_m(three.large));
    EXPECT_EQ(ends_m(one.series[1]), ends_m(three.series[1]));
    EXPECT_NE(ends_m(one.series[0]), ends_m(one.series[1]));
}

TEST(LetFall, FallsTheSameRocksOverTheBareSlope) {
    // The bare slope of a case with a stand is the case without one.
    const Ensembles with = fall(testing::even_slope("slope", testing::stand_of_site_2), {}, 1, true);
    const Ensembles without = fall(testing::even_slope(), {});
    EXPECT_EQ(ends_m(with.open_series[1]), ends_m(without.series[1]));
}

TEST(LetFall, FindsFewerTreesWhereBrokenOnesFall) {
    const CaseFiles files = testing::even_slope("slope", testing::stand_of_site_2);
    const std::vector<std::string> many{"series.rocks_per_series=300", "stand.dbh_mean_cm=10",
                                        "stand.dbh_deviation_cm=2"};
    std::vector<std::string> removed = many;
    removed.emplace_back("tree_impact.remove_broken=yes");
    EXPECT_LT(hits_of(fall(files, removed)), hits_of(fall(files, many)));
}

TEST(JumpSums, KeepShortestAndLongest) {
    JumpSums sums;
    sums.add(4.0, 0.5);
    sums.add(2.0, 1.5);
    JumpSums others;
    others.add(9.0, 1.0);
    sums.add(others);
    sums.add(JumpSums{});
    EXPECT_EQ(sums.jumps, 3U);
    EXPECT_DOUBLE_EQ(sums.shortest_m, 2.0);
    EXPECT_DOUBLE_EQ(sums.longest_m, 9.0);
    EXPECT_DOUBLE_EQ(sums.sum_m, 15.0);
    EXPECT_DOUBLE_EQ(sums.squares_m2, 101.0);
    EXPECT_DOUBLE_EQ(sums.height_sum_m, 3.0);
    EXPECT_DOUBLE_EQ(sums.highest_m, 1.5);
}

}  // namespace
}  // namespace coupling::validation::falls_test
