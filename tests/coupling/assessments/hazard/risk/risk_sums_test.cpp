#include "coupling/assessments/hazard/risk/risk_sums.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/assessments/consequences/presence.hpp"

namespace coupling::hazard::risk::risk_sums_test {
namespace {

using rockfall::Cover;

constexpr auto with_forest = static_cast<std::size_t>(Cover::forest);
constexpr auto bare_slope = static_cast<std::size_t>(Cover::bare);

const TargetExposure road{.vehicles_per_day = 1200.0, .speed_kmph = 60.0, .persons_per_vehicle = 1.6};
const TargetExposure house{.persons = 4.0, .hours_per_day = 16.0, .house_value = 1e6};
const RiskSettings settings{.prevented_death = 5e6, .closure_days = 0.25, .closure_cost_per_day = 20'000.0};

double value_at(const PlaceRisk& risk, std::size_t cover, Quantity quantity) {
    return risk.slopes[cover].at(quantity).value;
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-11 * std::max({1.0, std::abs(a), std::abs(b)});
}

/// One road and a known rate: 60 of 1000 blocks that are released once in 30 years.
TEST(RiskSums, OfOneRoadAreTheClosedFormula) {
    RiskSums sums{{road}, Curves::shipped(), settings};
    std::vector<Hit> found;
    for (std::uint64_t rock = 0; rock < 60; ++rock) {
        found.push_back({.rock = 7 * rock, .energy_class = static_cast<std::uint16_t>(rock < 45 ? 1 : 2)});
    }
    sums.add_period(30.0, {{.rocks = 1000, .diameter_m = 0.8}}, found);
    const PlaceRisk risk = sums.at(0);
    const auto& classes = Curves::shipped().classes();
    const double hits_per_year = 60.0 / 1000.0 / 30.0;
    const double presence = 1200.0 * (5.0 + 0.8) / (24.0 * 1000.0 * 60.0);
    const double lethality =
        (45.0 * classes[1].lethality_in_vehicle + 15.0 * classes[2].lethality_in_vehicle) / 60.0;
    const double deaths = hits_per_year * presence * 1.6 * lethality;
    EXPECT_TRUE(near(value_at(risk, bare_slope, Quantity::arrivals), hits_per_year));
    EXPECT_TRUE(near(value_at(risk, bare_slope, Quantity::vehicles_hit), hits_per_year * presence));
    EXPECT_TRUE(near(value_at(risk, bare_slope, Quantity::deaths), deaths));
    EXPECT_TRUE(near(value_at(risk, bare_slope, Quantity::individual_risk), deaths / 1.6 / 1200.0 * 2.0));
    EXPECT_TRUE(near(value_at(risk, bare_slope, Quantity::closure), hits_per_year * 5000.0));
    EXPECT_TRUE(near(value_at(risk, bare_slope, Quantity::money), deaths * 5e6 + hits_per_year * 5000.0));
    // The exact interval of 60 events is 45.79 to 77.23.
    EXPECT_NEAR(risk.slopes[bare_slope].at(Quantity::arrivals).low, 45.79 / 30'000.0, 1e-6);
    EXPECT_NEAR(risk.slopes[bare_slope].at(Quantity::arrivals).high, 77.23 / 30'000.0, 1e-6);
    EXPECT_EQ(value_at(risk, with_forest, Quantity::money), 0.0);
    EXPECT_GT(risk.slopes[with_forest].at(Quantity::money).high, 0.0);
}

/// Return periods and rows of hazard.blocks add up, each by its own number of rocks.
TEST(RiskSums, AddReturnPeriodsAndRows) {
    RiskSums sums{{house}, Curves::shipped(), settings};
    sums.add_period(10.0, {{100, 0.3}, {50, 0.6}}, {{.rock = 3}, {.rock = 120, .block_row = 1}});
    sums.add_period(100.0, {{200, 1.0}}, {{.rock = 3}});
    EXPECT_TRUE(near(value_at(sums.at(0), bare_slope, Quantity::arrivals),
                     1.0 / 1000.0 + 1.0 / 500.0 + 1.0 / 20'000.0));
}

/// A block of 0.3 m that never brought more than the lowest class does not widen an interval as if it broke
/// walls; a row that hits nothing here says nothing.
TEST(RiskSums, BoundWhatWasNotSeenByWhatTheRowsDo) {
    RiskSums sums{{house, house}, Curves::shipped(), settings};
    // Row 1 hits target 0 with the lowest class; row 0, with few rocks, hits nothing.
    std::vector<Hit> found;
    for (std::uint64_t rock = 10; rock < 60; ++rock) {
        found.push_back({.rock = rock, .block_row = 1});
    }
    sums.add_period(10.0, {{10, 2.0}, {1000, 0.3}}, found);
    const double of_one =
        consequence(house, Curves::shipped().classes()[0], 0.3, settings)[index_of(Quantity::money)] /
        10'000.0;
    const Estimate hit = sums.at(0).slopes[bare_slope].at(Quantity::money);
    EXPECT_NEAR(hit.high, 65.92 * of_one, 0.01 * of_one);  // exact: 50 events lie in 37.11 to 65.92
    EXPECT_NEAR(hit.low, 37.11 * of_one, 0.01 * of_one);
    // Target 1 is not hit: as target 0 is, 3.69 times.
    EXPECT_NEAR(sums.at(1).slopes[bare_slope].at(Quantity::money).high, 3.689 * of_one, 0.001 * of_one);
    EXPECT_NEAR(sums.of_all().slopes[bare_slope].at(Quantity::money).high, hit.high, 1e-9 * hit.high);
    RiskSums nothing{{house}, Curves::shipped(), settings};
    nothing.add_period(10.0, {{10, 2.0}}, {});
    EXPECT_GT(nothing.at(0).slopes[bare_slope].at(Quantity::money).high, 0.0);
}

struct RandomHits {
    std::vector<hits::BlockRow> rows;
    std::vector<Hit> hits;
};

/// Hits of one road, another one and a house; each rock at most once at a target on a slope.
RandomHits random_hits() {
    RandomHits made;
    for (const int rocks : {40, 25}) {
        made.rows.push_back({static_cast<std::uint64_t>(rocks), *rc::gen::inRange(2, 30) / 10.0});
    }
    for (std::uint64_t rock = 0; rock < 65; ++rock) {
        for (std::uint32_t target = 0; target < 3; ++target) {
            for (const Cover cover : {Cover::forest, Cover::bare}) {
                if (*rc::gen::weightedElement<bool>({{3, false}, {1, true}})) {
                    made.hits.push_back({rock, target, static_cast<std::uint16_t>(rock < 40 ? 0 : 1),
                                         static_cast<std::uint16_t>(*rc::gen::inRange(0, 3)), cover});
                }
            }
        }
    }
    return made;
}

const std::vector<TargetExposure>& three_targets() {
    static const std::vector<TargetExposure> targets{
        road, house, {.vehicles_per_day = 300.0, .speed_kmph = 30.0, .persons_per_vehicle = 2.0}};
    return targets;
}

RC_GTEST_PROP(RiskSums, OfAllTargetsAreTheSumOfEach, ()) {
    const RandomHits made = random_hits();
    RiskSums sums{three_targets(), Curves::shipped(), settings};
    sums.add_period(30.0, made.rows, made.hits);
    sums.add_period(300.0, made.rows, made.hits);
    const PlaceRisk all = sums.of_all();
    for (const std::size_t cover : {with_forest, bare_slope}) {
        for (const Quantity quantity :
             {Quantity::arrivals, Quantity::vehicles_hit, Quantity::deaths, Quantity::damage,
              Quantity::closure_days, Quantity::closure, Quantity::money}) {
            double sum = 0.0;
            for (std::size_t target = 0; target < 3; ++target) {
                sum += value_at(sums.at(target), cover, quantity);
            }
            RC_ASSERT(near(sum, value_at(all, cover, quantity)));
        }
        RC_ASSERT(value_at(all, cover, Quantity::individual_risk) == 0.0);
    }
    RC_ASSERT(near(all.spared_money.value,
                   value_at(all, bare_slope, Quantity::money) - value_at(all, with_forest, Quantity::money)));
    RC_ASSERT(near(all.spared_deaths.value, value_at(all, bare_slope, Quantity::deaths) -
                                                value_at(all, with_forest, Quantity::deaths)));
}

RC_GTEST_PROP(RiskSums, OfATargetAreTheSumOfItsClasses, ()) {
    const RandomHits made = random_hits();
    RiskSums sums{three_targets(), Curves::shipped(), settings};
    sums.add_period(30.0, made.rows, made.hits);
    for (std::size_t target = 0; target < 3; ++target) {
        const PlaceRisk risk = sums.at(target);
        for (const SlopeRisk& slope : risk.slopes) {
            RC_ASSERT(slope.by_class.size() == 3U);
            for (std::size_t q = 0; q < quantities; ++q) {
                double sum = 0.0;
                for (const Quantities& part : slope.by_class) {
                    sum += part[q];
                }
                RC_ASSERT(near(sum, slope.of[q].value));
                RC_ASSERT(slope.of[q].low <= slope.of[q].value * (1.0 + 1e-12));
                RC_ASSERT(slope.of[q].value <= slope.of[q].high * (1.0 + 1e-12));
            }
        }
    }
}

RC_GTEST_PROP(RiskSums, DoNotDependOnTheOrderOfHits, ()) {
    RandomHits made = random_hits();
    RiskSums sums{three_targets(), Curves::shipped(), settings};
    sums.add_period(30.0, made.rows, made.hits);
    std::reverse(made.hits.begin(), made.hits.end());
    std::rotate(made.hits.begin(), made.hits.begin() + static_cast<std::ptrdiff_t>(made.hits.size() / 3),
                made.hits.end());
    RiskSums again{three_targets(), Curves::shipped(), settings};
    again.add_period(30.0, made.rows, made.hits);
    for (std::size_t q = 0; q < quantities; ++q) {
        RC_ASSERT(sums.of_all().slopes[bare_slope].of[q].value ==
                  again.of_all().slopes[bare_slope].of[q].value);
        RC_ASSERT(sums.at(0).slopes[with_forest].of[q].high == again.at(0).slopes[with_forest].of[q].high);
    }
}

RC_GTEST_PROP(RiskSums, RiseWithTrafficWhileArrivalsStay, ()) {
    const RandomHits made = random_hits();
    std::vector<TargetExposure> busier = three_targets();
    busier[0].vehicles_per_day = 1200.0 + *rc::gen::inRange(1, 10'000);
    RiskSums sums{three_targets(), Curves::shipped(), settings};
    RiskSums more{busier, Curves::shipped(), settings};
    sums.add_period(30.0, made.rows, made.hits);
    more.add_period(30.0, made.rows, made.hits);
    for (const std::size_t cover : {with_forest, bare_slope}) {
        const double arrivals = value_at(sums.at(0), cover, Quantity::arrivals);
        RC_ASSERT(value_at(more.at(0), cover, Quantity::arrivals) == arrivals);
        RC_ASSERT(value_at(more.at(0), cover, Quantity::closure) ==
                  value_at(sums.at(0), cover, Quantity::closure));
        if (arrivals > 0.0) {
            RC_ASSERT(value_at(more.at(0), cover, Quantity::deaths) >
                      value_at(sums.at(0), cover, Quantity::deaths));
        }
        RC_ASSERT(value_at(more.at(1), cover, Quantity::money) ==
                  value_at(sums.at(1), cover, Quantity::money));
    }
}

/// The forest changes which blocks arrive and how fast, never who is there: the same hits on the other slope
/// give the same risk, and what it spares turns its sign.
RC_GTEST_PROP(RiskSums, AreTheSameForTheSameHitsOnBothSlopes, ()) {
    const RandomHits made = random_hits();
    RandomHits turned = made;
    for (Hit& hit : turned.hits) {
        hit.cover = hit.cover == Cover::bare ? Cover::forest : Cover::bare;
    }
    RiskSums sums{three_targets(), Curves::shipped(), settings};
    RiskSums other{three_targets(), Curves::shipped(), settings};
    sums.add_period(30.0, made.rows, made.hits);
    other.add_period(30.0, made.rows, turned.hits);
    for (std::size_t target = 0; target < 3; ++target) {
        for (std::size_t q = 0; q < quantities; ++q) {
            RC_ASSERT(sums.at(target).slopes[bare_slope].of[q].value ==
                      other.at(target).slopes[with_forest].of[q].value);
        }
        RC_ASSERT(sums.at(target).spared_money.value == -other.at(target).spared_money.value);
    }
}

/// A forest that only stops blocks never adds risk.
RC_GTEST_PROP(RiskSums, FallWhereBlocksAreStopped, ()) {
    RandomHits made = random_hits();
    std::vector<Hit> kept;
    for (const Hit& hit : made.hits) {
        if (hit.cover == Cover::bare) {
            kept.push_back(hit);
            if (*rc::gen::arbitrary<bool>()) {
                kept.push_back(hit);
                kept.back().cover = Cover::forest;
            }
        }
    }
    RiskSums sums{three_targets(), Curves::shipped(), settings};
    sums.add_period(30.0, made.rows, kept);
    RC_ASSERT(sums.of_all().spared_money.value >= 0.0);
    RC_ASSERT(sums.of_all().spared_deaths.value >= 0.0);
}

/// Rocks of a road in 64 strata, of which stratum k lets every `every(k)`-th rock hit; 0: none.
template <class Every>
RiskSums sums_of_strata(const Every& every, const rockfall::Strata& strata) {
    constexpr std::uint64_t rocks = 64 * 200;
    std::vector<Hit> found;
    std::vector<std::uint64_t> seen(strata.count);
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        const std::uint32_t stratum = strata.of(rock);
        const std::uint64_t of = every(stratum);
        if (of > 0 && ++seen[stratum] % of == 0) {
            found.push_back({.rock = rock});
        }
    }
    RiskSums sums{{road}, Curves::shipped(), settings};
    sums.add_period(30.0, {{rocks, 0.8}}, found, strata);
    return sums;
}

const Interval& all_money(const std::optional<Interval>& interval) {
    EXPECT_TRUE(interval.has_value());
    static const Interval none{};
    return interval ? *interval : none;
}

/// What differs between draws is in the second interval, and of equal draws it holds little more than chance.
TEST(RiskSums, ShowWhatIsNotKnownWhereItMovesTheRisk) {
    const rockfall::Strata strata{64, 3};
    const SlopeRisk equal =
        sums_of_strata([](std::uint32_t) { return 20; }, strata).of_all().slopes[bare_slope];
    const Estimate& money = equal.at(Quantity::money);
    EXPECT_LE(all_money(equal.all_money).low, money.low);
    EXPECT_GE(all_money(equal.all_money).high, money.high);

    const SlopeRisk halves = sums_of_strata([](std::uint32_t k) { return k % 2 == 0 ? 10 : 0; }, strata)
                                 .of_all()
                                 .slopes[bare_slope];
    const double value = halves.at(Quantity::money).value;
    EXPECT_NEAR(value, money.value, 1e-9 * value);
    EXPECT_LT(all_money(halves.all_money).low, 0.2 * value);
    EXPECT_GT(all_money(halves.all_money).high, 1.8 * value);
    EXPECT_LT(all_money(equal.all_money).width(), 0.7 * all_money(halves.all_money).width());
}

TEST(RiskSums, ShowNothingOfItWithoutDrawsOrWithFewRocks) {
    const auto of = [](const RiskSums& sums) { return sums.of_all().slopes[bare_slope].all_money; };
    EXPECT_FALSE(of(sums_of_strata([](std::uint32_t) { return 20; }, {})));
    // Two rocks of a stratum hide too much.
    EXPECT_FALSE(of(sums_of_strata([](std::uint32_t) { return 100; }, {64, 3})));
    // Strata of two periods that are not the same draws.
    RiskSums sums = sums_of_strata([](std::uint32_t) { return 20; }, {64, 3});
    EXPECT_TRUE(of(sums));
    sums.add_period(300.0, {{64, 0.8}}, {{.rock = 3}}, {32, 3});
    EXPECT_FALSE(of(sums));
}

}  // namespace
}  // namespace coupling::hazard::risk::risk_sums_test
