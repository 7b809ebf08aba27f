#include "coupling/assessments/decades/risk/risk_over_years.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::decades::risk_over_years_test {
namespace {

using consequences::Quantities;
using consequences::Quantity;
using Rocks = std::vector<exchange::RockAtTarget>;

const TargetExposure road{
    .vehicles_per_day = 2400.0, .speed_kmph = 50.0, .persons_per_vehicle = 1.5, .vehicle_length_m = 4.0};
const TargetExposure house{.persons = 3.0, .hours_per_day = 12.0, .house_value = 8e5};

constexpr std::uint64_t started = 200;

/// Classes from 0, 33.3 and 300 kJ: the second begins inside of any bin of energy.
consequences::Curves some_curves() {
    return consequences::Curves::read(
        config::Table::read("energy_from_kj,lethality_in_vehicle,lethality_in_house,damage_to_house\n"
                            "0,0.1,0.001,0.01\n33.3,0.5,0.04,0.2\n300,0.8,0.2,0.6\n",
                            "curves.csv"));
}

/// What arrives at a target in a year.
struct Arrivals {
    std::int32_t year;
    std::uint32_t target;
    Rocks forest;
    Rocks bare;
};

MemberYears member_of(std::uint32_t regime, std::uint32_t replicate,
                      const std::vector<Arrivals>& all_arrivals) {
    MemberYears years;
    years.member = {.regime = regime, .replicate = replicate};
    for (const Arrivals& here : all_arrivals) {
        TargetRow row;
        row.year = here.year;
        row.target = here.target;
        row.paired = {0, here.forest.size(), here.bare.size()};
        row.bare.share.whole = started;
        years.targets.push_back(row);
        years.rocks_at_targets.insert(years.rocks_at_targets.end(), here.forest.begin(), here.forest.end());
        years.rocks_at_targets.insert(years.rocks_at_targets.end(), here.bare.begin(), here.bare.end());
    }
    return years;
}

/// A brook, which nobody is at, a road and a house.
struct RiskOfAValley {
    RiskOfAValley() {
        for (const char* id : {"brook", "road", "house"}) {
            targets.emplace_back();
            targets.back().id = id;
        }
        plan.settings = {.prevented_death = 2e6, .closure_days = 0.5, .closure_cost_per_day = 1000.0};
        plan.targets = {{"road", road}, {"house", house}};
    }
    [[nodiscard]] RiskOverYears risk(const std::vector<MemberYears>& members, double rocks_per_year) const {
        return risk_over_years(names, targets, members, plan, rocks_per_year);
    }

    std::vector<rockfall::Target> targets;
    forest::SpeciesTable species{forest::SpeciesTable::shipped()};
    Names names{{"none", "strips"}, {}, species};
    consequences::RiskPlan plan{{}, some_curves(), {}};
};

double figure_of(const Quantities& figures, Quantity quantity) {
    return figures[consequences::index_of(quantity)];
}

TEST(RiskOverYears, OfConstantArrivalsOnOneRoadIsTheClosedFormula) {
    const RiskOfAValley valley;
    std::vector<Arrivals> all_arrivals;
    for (std::int32_t year = 0; year <= 3; ++year) {
        all_arrivals.push_back({year, 1, Rocks(20, {100e3F, 1.0F}), Rocks(50, {400e3F, 1.0F})});
    }
    const RiskOverYears risk = valley.risk({member_of(0, 0, all_arrivals)}, 4.0);
    const RiskByYear& forest = risk.targets[0].at(Cover::forest, 0)[0];
    ASSERT_EQ(forest.size(), 4U);
    // 20 of 200 rocks, of which 4 really start: 0.4 a year. 2400 (4 + 1) / (24 * 1000 * 50) = 0.01 vehicles.
    for (const auto& [year, figures] : forest) {
        EXPECT_NEAR(figure_of(figures, Quantity::arrivals), 0.4, 1e-15);
        EXPECT_NEAR(figure_of(figures, Quantity::vehicles_hit), 0.4 * 0.01, 1e-15);
        EXPECT_NEAR(figure_of(figures, Quantity::deaths), 0.4 * 0.01 * 1.5 * 0.5, 1e-15);
        EXPECT_NEAR(figure_of(figures, Quantity::closure), 0.4 * 500.0, 1e-12);
        EXPECT_NEAR(figure_of(figures, Quantity::money), 0.4 * (0.0075 * 2e6 + 500.0), 1e-9);
    }
    const RiskByYear& bare = risk.targets[0].at(Cover::bare, 0)[0];
    EXPECT_NEAR(figure_of(bare.at(2), Quantity::money), 1.0 * (0.01 * 1.5 * 0.8 * 2e6 + 500.0), 1e-9);
    EXPECT_NEAR(figure_of(*mean_after_start(forest), Quantity::money), 6200.0, 1e-9);
    EXPECT_NEAR(present_value_of_risk(forest, 2.0),
                6200.0 * (1.0 / 1.02 + 1.0 / (1.02 * 1.02) + 1.0 / (1.02 * 1.02 * 1.02)), 1e-8);
    EXPECT_NEAR(present_value_of_risk(forest, 0.0), 3.0 * 6200.0, 1e-9);
}

/// Bins of energy would put both rocks into one class.
TEST(RiskOverYears, KnowsTheClassOfEachRockExactly) {
    const RiskOfAValley valley;
    const RiskOverYears risk =
        valley.risk({member_of(0, 0, {{1, 2, {{33.2999e3F, 0.4F}, {33.3001e3F, 0.9F}}, {}}})},
                    static_cast<double>(started));
    // Persons 3 for half of the day.
    EXPECT_NEAR(figure_of(risk.targets[1].at(Cover::forest, 0)[0].at(1), Quantity::deaths),
                1.5 * (0.001 + 0.04), 1e-15);
    EXPECT_NEAR(figure_of(risk.targets[1].at(Cover::forest, 0)[0].at(1), Quantity::damage),
                8e5 * (0.01 + 0.2), 1e-9);
}

TEST(RiskOverYears, LetsYearsWithRocksStandForThoseSinceTheOneBefore) {
    RiskByYear years;
    for (const auto& [year, money] :
         {std::pair{0, 1000.0}, std::pair{10, 4.0}, std::pair{20, 8.0}, std::pair{25, 20.0}}) {
        years[year][consequences::index_of(Quantity::money)] = money;
    }
    EXPECT_NEAR(figure_of(*mean_after_start(years), Quantity::money), (40.0 + 80.0 + 100.0) / 25.0, 1e-12);
    EXPECT_NEAR(present_value_of_risk(years, 0.0), 220.0, 1e-12);
    double expected = 0.0;
    for (int year = 1; year <= 25; ++year) {
        expected += (year <= 10 ? 4.0 : year <= 20 ? 8.0 : 20.0) / std::pow(1.03, year);
    }
    EXPECT_NEAR(present_value_of_risk(years, 3.0), expected, 1e-10);
    years.erase(years.upper_bound(0), years.end());
    EXPECT_FALSE(mean_after_start(years));
}

TEST(RiskOverYears, HasNoIndividualRiskOfAllTargetsAndNoYearWithoutRocks) {
    const RiskOfAValley valley;
    MemberYears member = member_of(0, 0, {{1, 1, {{50e3F, 0.5F}}, {}}, {2, 1, {}, {}}});
    member.targets.back().bare.share.whole = 0;
    const RiskOverYears risk = valley.risk({member}, 1.0);
    EXPECT_EQ(years_of(risk.all), (std::vector<std::int32_t>{1}));
    const auto found = risk_in_year(risk.all, Cover::forest, 0, 1);
    ASSERT_TRUE(found);
    EXPECT_TRUE(std::isnan(found->at(Quantity::individual_risk).mean));
    EXPECT_GT(found->at(Quantity::deaths).mean, 0.0);
    EXPECT_GT(risk_in_year(risk.targets[0], Cover::forest, 0, 1)->at(Quantity::individual_risk).mean, 0.0);
    EXPECT_FALSE(risk_in_year(risk.all, Cover::forest, 0, 2));
}

Rocks some_rocks(std::size_t most) {
    Rocks rocks;
    const auto count = *rc::gen::inRange<std::size_t>(0, most + 1);
    for (std::size_t i = 0; i < count; ++i) {
        rocks.push_back({static_cast<float>(*rc::gen::inRange(1, 1'000'000)),
                         static_cast<float>(*rc::gen::inRange(1, 30)) / 10.0F});
    }
    return rocks;
}

bool near_to(double a, double b) {
    return std::abs(a - b) <= 1e-11 * std::max({1.0, std::abs(a), std::abs(b)});
}

RC_GTEST_PROP(RiskOverYears, SumsOverTargetsAndIsLinearInTheRocks, ()) {
    const RiskOfAValley valley;
    std::vector<MemberYears> members;
    for (std::uint32_t regime = 0; regime < 2; ++regime) {
        for (std::uint32_t replicate = 0; replicate < 2; ++replicate) {
            std::vector<Arrivals> all_arrivals;
            for (std::int32_t year = 0; year <= 2; ++year) {
                for (std::uint32_t target = 0; target < 3; ++target) {
                    all_arrivals.push_back({year, target, some_rocks(5), some_rocks(5)});
                }
            }
            members.push_back(member_of(regime, replicate, all_arrivals));
        }
    }
    const double rocks = *rc::gen::inRange(1, 100);
    const RiskOverYears once = valley.risk(members, rocks);
    const RiskOverYears thrice = valley.risk(members, 3.0 * rocks);
    for (const Cover cover : {Cover::forest, Cover::bare}) {
        for (std::size_t course = 0; course < 2; ++course) {
            for (std::size_t replicate = 0; replicate < 2; ++replicate) {
                const auto at = [&](const RiskAtPlace& place) { return place.at(cover, course)[replicate]; };
                for (const auto& [year, sums] : at(once.all)) {
                    for (std::size_t q = 0; q < consequences::quantities; ++q) {
                        if (q != consequences::index_of(Quantity::individual_risk)) {
                            // A target that has not what counts adds nothing.
                            const auto part = [&](std::size_t target) {
                                const double figure = at(once.targets[target]).at(year)[q];
                                return std::isnan(figure) ? 0.0 : figure;
                            };
                            const double sum = part(0) + part(1);
                            RC_ASSERT(near_to(sums[q], sum));
                            RC_ASSERT(near_to(at(thrice.all).at(year)[q], 3.0 * sums[q]));
                        }
                    }
                    RC_ASSERT(
                        near_to(figure_of(sums, Quantity::money), figure_of(sums, Quantity::deaths) * 2e6 +
                                                                      figure_of(sums, Quantity::damage) +
                                                                      figure_of(sums, Quantity::closure)));
                }
                RC_ASSERT(near_to(present_value_of_risk(at(thrice.all), 1.5),
                                  3.0 * present_value_of_risk(at(once.all), 1.5)));
            }
        }
    }
}

}  // namespace
}  // namespace coupling::decades::risk_over_years_test
