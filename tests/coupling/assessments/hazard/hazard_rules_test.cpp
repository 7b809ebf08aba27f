#include "coupling/assessments/hazard/hazard_rules.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace coupling::hazard::hazard_rules_test {
namespace {

/// Rocks with these energies hit a place, of so many that were released.
RocksAtPlace rocks_of(const std::vector<double>& energies_kj, double released, const Matrix& matrix) {
    RocksAtPlace rocks{.per_release = static_cast<double>(energies_kj.size()) / released,
                       .per_release_above = {}};
    for (const double from_kj : matrix.energy_from_kj()) {
        const auto above = std::count_if(energies_kj.begin(), energies_kj.end(),
                                         [&](double energy_kj) { return energy_kj >= from_kj; });
        rocks.per_release_above.push_back(static_cast<double>(above) / released);
    }
    if (!energies_kj.empty()) {
        rocks.energy = {*std::max_element(energies_kj.begin(), energies_kj.end()), energies_kj.size(), true};
    }
    return rocks;
}

/// Of one return period alone.
RuledLevel level_alone(HazardRule rule, const Matrix& matrix, double years, const RocksAtPlace& rocks) {
    const PeriodAtPlace period{years, rocks};
    return level_of(rule, matrix, std::span{&period, 1});
}

/// By hand: 20 of 100 rocks of 30 years arrive with 50 kJ, two of them with 400 kJ. That is 50 kJ once in 150
/// years (moderate), and 400 kJ once in 1500 years (residual).
TEST(HazardRules, SwitzerlandTakesTheHighestOfAllClasses) {
    const Matrix matrix = Matrix::shipped();
    std::vector<double> energies_kj(18, 50.0);
    energies_kj.insert(energies_kj.end(), 2, 400.0);
    const RocksAtPlace rocks = rocks_of(energies_kj, 100.0, matrix);
    const RuledLevel level = level_alone(HazardRule::cadanav, matrix, 30.0, rocks);
    EXPECT_EQ(level.level, Level::moderate);
    EXPECT_EQ(level.intensity, 1U);
    EXPECT_NEAR(level.years, 150.0, 1e-9);
    EXPECT_EQ(level_alone(HazardRule::arrival, matrix, 30.0, rocks).level,
              Level::high);  // 400 kJ once in 150
    EXPECT_EQ(level_alone(HazardRule::release, matrix, 30.0, rocks).level, Level::high);
}

TEST(HazardRules, GiveNoLevelWhereNoRockArrives) {
    const Matrix matrix = Matrix::shipped();
    for (const HazardRule rule : {HazardRule::cadanav, HazardRule::arrival, HazardRule::release}) {
        const RuledLevel level = level_alone(rule, matrix, 10.0, rocks_of({}, 100.0, matrix));
        EXPECT_EQ(level.level, Level::none) << rule_name(rule);
        EXPECT_TRUE(level.is_free()) << rule_name(rule);
    }
}

/// A forest that only stops rocks never raises the level of the rule cadanav, whichever rocks it stops.
TEST(HazardRules, SwitzerlandNeverRisesWhenRocksAreStopped) {
    EXPECT_TRUE(rc::check([] {
        const auto energies = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(0, 900));
        const auto stopped = *rc::gen::container<std::vector<bool>>(20, rc::gen::arbitrary<bool>());
        const int years = *rc::gen::inRange(1, 600);
        const Matrix matrix = Matrix::shipped();
        std::vector<double> bare;
        std::vector<double> forest;
        for (std::size_t i = 0; i < energies.size(); ++i) {
            bare.push_back(energies[i]);
            if (!stopped[i]) {
                forest.push_back(energies[i]);
            }
        }
        RC_ASSERT(level_alone(HazardRule::cadanav, matrix, years, rocks_of(forest, 50.0, matrix)).level <=
                  level_alone(HazardRule::cadanav, matrix, years, rocks_of(bare, 50.0, matrix)).level);
    }));
}

/// That of a percentile does: the reason for the default.
TEST(HazardRules, APercentileRisesWhenSmallRocksAreStopped) {
    const Matrix matrix = Matrix::shipped();
    RocksAtPlace bare = rocks_of(std::vector<double>(10, 20.0), 10.0, matrix);
    bare.energy.kj = 20.0;
    RocksAtPlace forest = rocks_of({400.0}, 10.0, matrix);
    EXPECT_GT(level_alone(HazardRule::release, matrix, 100.0, forest).level,
              level_alone(HazardRule::release, matrix, 100.0, bare).level);
}

/// By hand: 400 kJ once in 300 and once in 600 years is once in 200 years.
TEST(HazardRules, AddUpHowOftenRocksOfAllReturnPeriodsArrive) {
    const Matrix matrix = Matrix::shipped();
    const std::vector<PeriodAtPlace> periods{
        {30.0, rocks_of(std::vector<double>(10, 400.0), 100.0, matrix)},
        {300.0, rocks_of(std::vector<double>(50, 400.0), 100.0, matrix)}};
    for (const HazardRule rule : {HazardRule::cadanav, HazardRule::arrival}) {
        const RuledLevel level = level_of(rule, matrix, periods);
        EXPECT_EQ(level.level, Level::high) << rule_name(rule);
        EXPECT_NEAR(level.years, 200.0, 1e-9) << rule_name(rule);
        EXPECT_EQ(level.release_years, 30.0) << rule_name(rule);
    }
    EXPECT_EQ(level_alone(HazardRule::cadanav, matrix, 30.0, periods.front().rocks).years, 300.0);
    EXPECT_EQ(level_of(HazardRule::release, matrix, periods).release_years, 300.0);  // of more rocks
}

/// 50 kJ once in 100 years and 400 kJ once in 50 years: both give the class from 30 kJ on, the energy beside
/// that class is one of its own.
TEST(HazardRules, ArrivalShowsAnEnergyOfTheClassThatGivesTheLevel) {
    const Matrix matrix = Matrix::shipped();
    for (const double rare_years : {50.0, 5000.0}) {
        const std::vector<PeriodAtPlace> periods{{100.0, rocks_of({50.0}, 1.0, matrix)},
                                                 {rare_years, rocks_of({400.0}, 1.0, matrix)}};
        const RuledLevel level = level_of(HazardRule::arrival, matrix, periods);
        EXPECT_EQ(matrix.intensity_of(level.energy.kj), level.intensity) << rare_years;
    }
}

/// A scenario of frequency f, or several of the same rocks whose frequencies add up to f: no level, no class
/// and no frequency differs.
TEST(HazardRules, DoNotDependOnHowAScenarioIsSplit) {
    EXPECT_TRUE(rc::check([] {
        const Matrix matrix = Matrix::shipped();
        std::vector<PeriodAtPlace> whole;
        std::vector<PeriodAtPlace> split;
        const int scenarios = *rc::gen::inRange(1, 4);
        for (int k = 0; k < scenarios; ++k) {
            const auto energies = *rc::gen::container<std::vector<int>>(6, rc::gen::inRange(0, 900));
            const int years = *rc::gen::element(1, 10, 30, 90, 100, 300, 1000);
            const int pieces = *rc::gen::inRange(1, 6);
            const PeriodAtPlace scenario{
                static_cast<double>(years),
                rocks_of({energies.begin(), energies.end()}, *rc::gen::element(6.0, 10.0, 100.0), matrix)};
            whole.push_back(scenario);
            split.insert(split.end(), static_cast<std::size_t>(pieces),
                         {pieces * scenario.release_years, scenario.rocks});
        }
        for (const HazardRule rule : {HazardRule::cadanav, HazardRule::arrival}) {
            const RuledLevel of_whole = level_of(rule, matrix, whole);
            const RuledLevel of_split = level_of(rule, matrix, split);
            RC_ASSERT(of_whole.level == of_split.level);
            RC_ASSERT(of_whole.intensity == of_split.intensity);
            RC_ASSERT(std::abs(of_whole.years / of_split.years - 1.0) < 1e-9);
        }
    }));
}

/// One more return period, or more rocks of one, never lower a level.
TEST(HazardRules, OnlyRiseWithReturnPeriods) {
    EXPECT_TRUE(rc::check([] {
        const Matrix matrix = Matrix::shipped();
        std::vector<PeriodAtPlace> periods;
        Level before = Level::none;
        const HazardRule rule =
            *rc::gen::element(HazardRule::cadanav, HazardRule::arrival, HazardRule::release);
        for (int k = 0; k < 4; ++k) {
            const auto energies = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 900));
            periods.push_back({static_cast<double>(*rc::gen::inRange(1, 900)),
                               rocks_of({energies.begin(), energies.end()}, 50.0, matrix)});
            const Level now = level_of(rule, matrix, periods).level;
            RC_ASSERT(now >= before);
            before = now;
        }
    }));
}

TEST(Higher, TakesTheShorterPeriodOfEqualLevelsAndAnyRockOverNone) {
    RuledLevel often{Level::moderate, 1, 90.0, 30.0};
    RuledLevel seldom{Level::moderate, 1, 90.0, 100.0};
    RuledLevel nothing;
    EXPECT_EQ(higher(seldom, often).release_years, 30.0);
    EXPECT_EQ(higher(often, seldom).release_years, 30.0);
    RuledLevel no_level{Level::none, 0, 500.0, 300.0};
    EXPECT_EQ(higher(nothing, no_level).release_years, 300.0);
    EXPECT_EQ(higher(no_level, nothing).release_years, 300.0);
}

/// 8 rocks of 30 years and 18 of 300 years give the same level: the page shows the 18, and 20 before them.
TEST(Higher, TakesTheBetterSupportedOfEqualLevels) {
    const RuledLevel of_eight{Level::high, 1, 30.0, 30.0, {54.9, 8, true}};
    const RuledLevel of_eighteen{Level::high, 2, 300.0, 300.0, {625.0, 18, true}};
    const RuledLevel of_twenty{Level::high, 2, 1000.0, 1000.0, {400.0, 20, false}};
    EXPECT_EQ(higher(of_eight, of_eighteen).energy.rocks, 18U);
    EXPECT_EQ(higher(of_eighteen, of_eight).energy.rocks, 18U);
    EXPECT_EQ(higher(of_eighteen, of_twenty).energy.rocks, 20U);
    EXPECT_EQ(higher(of_twenty, of_eighteen).energy.rocks, 20U);
    RuledLevel of_thousand = of_twenty;
    of_thousand.release_years = 100.0;
    of_thousand.energy.rocks = 1000;
    EXPECT_EQ(higher(of_twenty, of_thousand).release_years, 100.0);
    const RuledLevel lower_of_many{Level::moderate, 1, 30.0, 30.0, {54.9, 800, false}};
    EXPECT_EQ(higher(lower_of_many, of_eight).level, Level::high);
    const RuledLevel of_one{Level::high, 1, 100.0, 100.0, {10.5, 1, true}};
    const RuledLevel of_a_greater_one{Level::high, 1, 300.0, 300.0, {168.0, 1, true}};
    EXPECT_EQ(higher(of_one, of_a_greater_one).energy.kj, 168.0);
}

TEST(RuleDifferences, StandFromTheLargestToTheSmallest) {
    const std::vector<Level> ruled{Level::high, Level::low, Level::none, Level::moderate, Level::high};
    const std::vector<Level> compared{Level::residual, Level::moderate, Level::none, Level::low,
                                      Level::residual};
    const std::vector<LevelSteps> found = level_differences(ruled, compared);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].steps, -3);
    EXPECT_EQ(found[0].places, (std::vector<std::size_t>{0, 4}));
    EXPECT_EQ(found[1].steps, -1);
    EXPECT_EQ(found[1].places, std::vector<std::size_t>{3});
    EXPECT_EQ(found[2].steps, 1);
    EXPECT_EQ(found[2].places, std::vector<std::size_t>{1});
}

TEST(RuleDifferences, AreNoneBetweenEqualLevels) {
    const std::vector<Level> levels_of_both{Level::high, Level::none};
    EXPECT_TRUE(level_differences(levels_of_both, levels_of_both).empty());
}

/// Over all pairs of levels: each place that differs stands once, and steps lead from one to the other.
TEST(RuleDifferences, HoldEachPlaceOnce) {
    std::vector<Level> ruled;
    std::vector<Level> compared;
    for (std::size_t a = 0; a < levels; ++a) {
        for (std::size_t b = 0; b < levels; ++b) {
            ruled.push_back(static_cast<Level>(a));
            compared.push_back(static_cast<Level>(b));
        }
    }
    std::size_t places = 0;
    for (const LevelSteps& of : level_differences(ruled, compared)) {
        places += of.places.size();
        for (const std::size_t place : of.places) {
            EXPECT_EQ(static_cast<int>(ruled[place]) + of.steps, static_cast<int>(compared[place]));
        }
    }
    EXPECT_EQ(places, levels * levels - levels);
}

}  // namespace
}  // namespace coupling::hazard::hazard_rules_test
