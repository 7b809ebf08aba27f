#include "coupling/assessments/profile/falls/profile_intervals.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "coupling/run/watched_falls.hpp"
#include "tests/coupling/assessments/profile/profile_project.hpp"

namespace coupling::profile::profile_intervals_test {
namespace {

/// A slope of 100 m whose rocks pass a station in the middle by chance, then stop at places of their own.
struct Ensemble {
    ProfileSite site{
        {{0.0, 100.0, 0}, {100.0, 0.0, 0}},
        rockfall::strip_slope(std::vector<rockfall::ProfilePoint>{{0.0, 100.0, 0}, {100.0, 0.0, 0}}, {{}}),
        0.0,
        {{"middle", 50.0}},
        nullptr,
        {}};
    ParameterDraws draws;
    ProfileTally tally;

    explicit Ensemble(std::size_t strata) : tally{site, 10.0, strata} {
        draws.components = {{"losses", "", 0.2}};
        for (std::size_t k = 0; k < strata; ++k) {
            const double unit = 2.0 * (static_cast<double>(k) + 0.5) / static_cast<double>(strata) - 1.0;
            draws.factors.push_back({std::exp(0.2 * unit)});
        }
        draws.falls.resize(strata);
    }

    /// The factor moves the middle of the stops by so many metres.
    void fall(std::size_t rocks_of_stratum, double metres_per_unit) {
        for (std::size_t k = 0; k < draws.factors.size(); ++k) {
            const double unit = std::log(draws.factors[k].front()) / 0.2;
            for (std::size_t i = 0; i < rocks_of_stratum; ++i) {
                config::RandomStream stream{{1, 0, 0, k * rocks_of_stratum + i}, config::Purpose::sampling};
                const double end_m = 50.0 + metres_per_unit * unit + 20.0 * (stream.uniform() - 0.5);
                WatchedFall fall;
                fall.started = true;
                fall.record.end_m = {end_m, 0.0, 100.0 - end_m};
                fall.record.reason = rockfall::StopReason::at_rest;
                fall.arrivals.resize(1);
                if (end_m >= 50.0) {
                    fall.arrivals[0].reached = true;
                    fall.arrivals[0].energy_j = static_cast<float>(1e3 * (end_m - 49.0));
                    fall.arrivals[0].speed_mps = 5.0F;
                    fall.arrivals[0].height_m = 1.0F;
                }
                tally.add(site, fall, false, k);
            }
        }
    }
};

TEST(ProfileIntervals, AreNoneWhereAllRocksFallByTheSameLaws) {
    Ensemble one{0};
    EXPECT_FALSE(intervals_of(one.tally, {}));
}

TEST(ProfileIntervals, AreWiderByWhatTheDrawsMoveAndByNothingElse) {
    Ensemble same{64};
    same.fall(200, 0.0);
    Ensemble moved{64};
    moved.fall(200, 6.0);
    const auto of_same = intervals_of(same.tally, same.draws);
    const auto of_moved = intervals_of(moved.tally, moved.draws);
    ASSERT_TRUE(of_same && of_same->run_out_mean_m && of_moved && of_moved->run_out_mean_m);
    // 12 800 stops of deviation 20 / sqrt(12): the mean is known to 1.96 x 0.051 m.
    const Interval& rocks = of_same->run_out_mean_m->of_rocks;
    EXPECT_NEAR(0.5 * (rocks.high - rocks.low), 1.96 * 20.0 / std::sqrt(12.0 * 12'800.0), 0.005);
    // Draws of no effect: their variance is estimated from 64 means, 0 or a part of the chance of a stratum.
    const Interval& of_none = of_same->run_out_mean_m->of_all;
    EXPECT_LT(of_none.high - of_none.low, 2.0 * 1.96 * 20.0 / std::sqrt(12.0 * 200.0));
    // Uniform over +-6 m: 95 % of the draws within +-5.7 m.
    const DrawnFigure& run_out = *of_moved->run_out_mean_m;
    EXPECT_NEAR(run_out.of_all.high - run_out.value, 5.7, 0.4);
    EXPECT_NEAR(run_out.value - run_out.of_all.low, 5.7, 0.4);
    EXPECT_GT(run_out.shares.front(), 0.9);
    // The share that passes moves by 6 m of 20 m.
    ASSERT_TRUE(of_moved->stations.front().share);
    EXPECT_NEAR(of_moved->stations.front().share->of_all.high, 0.5 + 5.7 / 20.0, 0.04);
    EXPECT_NEAR(of_moved->stations.front().share->of_all.low, 0.5 - 5.7 / 20.0, 0.04);
}

RC_GTEST_PROP(ProfileIntervals, HoldTheFigureAndTheIntervalOfTheRocks, ()) {
    Ensemble ensemble{static_cast<std::size_t>(*rc::gen::inRange(10, 65))};
    ensemble.fall(static_cast<std::size_t>(*rc::gen::inRange(2, 30)), *rc::gen::inRange(-30, 30));
    const auto intervals = intervals_of(ensemble.tally, ensemble.draws);
    RC_ASSERT(intervals.has_value());
    const ProfileIntervals::AtStation& at = intervals->stations.front();
    for (const std::optional<DrawnFigure>& figure :
         {intervals->run_out_mean_m, at.share, at.energy_mean_kj, at.energy_95_kj}) {
        if (figure) {
            // A lower end that would be 0 kJ is not known.
            const bool is_open = std::isnan(figure->of_all.low);
            RC_ASSERT(is_open || figure->of_all.low <= figure->of_rocks.low + 1e-9);
            RC_ASSERT(is_open || figure->of_rocks.low <= figure->value + 1e-9);
            RC_ASSERT(figure->value <= figure->of_rocks.high + 1e-9);
            RC_ASSERT(figure->of_rocks.high <= figure->of_all.high + 1e-9);
        }
    }
    std::uint64_t rocks = 0;
    std::uint64_t passing = 0;
    for (const StratumOnProfile& stratum : ensemble.tally.strata) {
        rocks += stratum.rocks;
        passing += stratum.stations.front().energy_j.count();
    }
    RC_ASSERT(rocks == ensemble.tally.rocks);
    RC_ASSERT(passing == ensemble.tally.stations.front().energy_j.moments.count());
}

TEST(ProfileDraws, ConcernTheGroundsOfTheProfileAndNoTree) {
    const SampleProject project;
    make_profile_project(project);
    const OpenedProfile opened = open_profile_of(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws draws = draws_on(*opened.scenario, *opened.site, 500);
    EXPECT_TRUE(draws.has_spread());
    std::size_t grounds = 0;
    for (const ParameterDraws::Component& component : draws.components) {
        EXPECT_FALSE(component.of_obstacles) << component.parameter;
        grounds += component.ground.empty() ? 0U : 1U;
    }
    EXPECT_EQ(grounds, 3U);  // 1, road, 3
    const OpenedProfile central = open_profile_of(project, {"run.parameter_draws=no"});
    ASSERT_TRUE(central.site) << central.errors;
    EXPECT_TRUE(draws_on(*central.scenario, *central.site, 500).empty());
}

TEST(ProfileDraws, TakeWidthsThatAUserGives) {
    const SampleProject project;
    make_profile_project(project);
    project.write("widths.csv", "parameter,width\nlosses,0\nfriction,0.1\nlosess,0.2\n");
    EXPECT_NE(open_profile_of(project, {"run.parameters=widths.csv"}).errors.find("losses"),
              std::string::npos);
    project.write("widths.csv", "parameter,width\nlosses,0\n");
    const OpenedProfile opened = open_profile_of(project, {"run.parameters=widths.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    for (const ParameterDraws::Component& component :
         draws_on(*opened.scenario, *opened.site, 500).components) {
        EXPECT_NE(component.parameter, "losses");
    }
}

}  // namespace
}  // namespace coupling::profile::profile_intervals_test
