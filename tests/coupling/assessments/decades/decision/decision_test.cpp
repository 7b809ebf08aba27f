#include "coupling/assessments/decades/decision/decision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "coupling/assessments/decades/decision/decision_page.hpp"
#include "coupling/assessments/decades/decision/decision_tables.hpp"
#include "coupling/assessments/decades/decision/verdict.hpp"
#include "coupling/inputs/scenario/decision_settings.hpp"
#include "coupling/results/text/markup.hpp"
#include "tests/coupling/parts_of_text.hpp"

namespace coupling::decades::decision_test {
namespace {

using text_checks::has;

const forest::SpeciesTable& species() {
    static const forest::SpeciesTable table = forest::SpeciesTable::shipped();
    return table;
}

/// Two regimes in two climates, rocks every five years. `lowest` is the protection in year 5 of each course,
/// that of year 10 is 99; margins are those of year 10, by course.
struct SomeDecision {
    std::vector<std::vector<double>> lowest_percent;  ///< [course][replicate]; NaN: no year is known
    std::vector<double> margin_eur_pha;               ///< [course]
    Names names{{"none", "pfm1"}, {}, species(), {"present", "warm"}};
    DecisionSettings settings{};

    [[nodiscard]] std::vector<Series> series() const {
        Series protection{.quantity = "protection_percent", .target = "road", .values = {}};
        Series margin{.quantity = "contribution_margin_eur_pha", .target = "", .values = {}};
        Series removed{.quantity = "removed_m3pha", .target = "", .values = {}};
        for (std::size_t course = 0; course < lowest_percent.size(); ++course) {
            protection.values.emplace_back();
            margin.values.emplace_back();
            removed.values.emplace_back();
            for (std::size_t r = 0; r < lowest_percent[course].size(); ++r) {
                // The start does not count: no regime can change it.
                protection.values[course].push_back({{0, 10.0}});
                if (!std::isnan(lowest_percent[course][r])) {
                    protection.values[course].back() = {
                        {0, 10.0}, {5, lowest_percent[course][r]}, {10, 99.0}};
                }
                margin.values[course].push_back(
                    {{0, 0.0}, {10, margin_eur_pha[course] + 0.1 * static_cast<double>(r % 3)}});
                removed.values[course].push_back({{0, 20.0}, {10, 10.0}});
            }
        }
        return {protection, margin, removed};
    }
    [[nodiscard]] Decision decision() const { return *decide(names, series(), {}, settings); }
    [[nodiscard]] std::string words() const {
        std::string all;
        for (const std::string& sentence : verdict(names, decision())) {
            all += sentence + '\n';
        }
        return all;
    }
};

/// Values without noise are drawn with a deviation of 0.01; sums over years and means over 1000 draws.
constexpr double drawn_points = 0.05;

std::vector<double> equal(std::size_t count, double value) {
    return std::vector<double>(count, value);
}

TEST(KeptShare, HasTheExactInterval) {
    // All of n: the lower end is 0.05^(1/n).
    EXPECT_NEAR(kept_share(20, 20).low, std::pow(0.05, 1.0 / 20.0), 1e-9);
    EXPECT_EQ(kept_share(20, 20).high, 1.0);
    EXPECT_NEAR(kept_share(0, 5).high, 1.0 - std::pow(0.05, 1.0 / 5.0), 1e-9);
    EXPECT_EQ(kept_share(0, 5).low, 0.0);
}

TEST(Judge, SaysYesOrNoOnlyWhereTheIntervalDoes) {
    EXPECT_EQ(judge(kept_share(20, 20), 0.8), Keeps::yes);
    EXPECT_EQ(judge(kept_share(13, 13), 0.8), Keeps::undecided) << "0.05^(1/13) = 0.794";
    EXPECT_EQ(judge(kept_share(14, 14), 0.8), Keeps::yes) << "0.05^(1/14) = 0.807";
    EXPECT_EQ(judge(kept_share(3, 3), 0.8), Keeps::undecided) << "three replicates prove nothing";
    EXPECT_EQ(judge(kept_share(5, 20), 0.8), Keeps::no);
    EXPECT_EQ(replicates_to_judge(kept_share(3, 3), 0.8), 14U);
    EXPECT_FALSE(replicates_to_judge(kept_share(4, 5), 0.8));
    EXPECT_EQ(both(Keeps::yes, Keeps::no), Keeps::no);
    EXPECT_EQ(both(Keeps::yes, Keeps::undecided), Keeps::undecided);
}

TEST(Judge, HoldsTheVerdictsOnAllRegimesTogether) {
    const VerdictChances chances = verdict_chances(4, 2);
    EXPECT_DOUBLE_EQ(chances.yes, 0.05 / 4.0);
    EXPECT_DOUBLE_EQ(chances.no, 0.05 / 8.0);
    EXPECT_NEAR(kept_share(20, 20, chances).verdict_low, std::pow(0.0125, 1.0 / 20.0), 1e-9);
    EXPECT_NEAR(kept_share(0, 5, chances).verdict_high, 1.0 - std::pow(0.00625, 1.0 / 5.0), 1e-9);
    EXPECT_EQ(judge(kept_share(14, 14, chances), 0.8), Keeps::undecided);
    EXPECT_EQ(judge(kept_share(19, 19, chances), 0.8), Keeps::undecided) << "0.0125^(1/19) = 0.794";
    EXPECT_EQ(judge(kept_share(20, 20, chances), 0.8), Keeps::yes) << "0.0125^(1/20) = 0.803";
    EXPECT_EQ(least_for_yes(0.8, chances), 20U);
    EXPECT_EQ(least_for_yes(0.8, {}), 14U);
    EXPECT_EQ(replicates_to_judge(kept_share(3, 3, chances), 0.8, chances), 20U);
}

/// The chance that 30 replicates, each with the probability p, give a verdict. The counts are binomial.
double chance_of(Keeps verdict, double p, const VerdictChances& chances) {
    constexpr std::size_t replicates = 30;
    double sum = 0.0;
    double ways = 1.0;
    for (std::size_t kept = 0; kept <= replicates; ++kept) {
        const auto k = static_cast<double>(kept);
        if (judge(kept_share(kept, replicates, chances), 0.8) == verdict) {
            sum += ways * std::pow(p, k) * std::pow(1.0 - p, replicates - k);
        }
        ways *= (replicates - k) / (k + 1.0);
    }
    return sum;
}

TEST(Judge, IsSeldomWrongOfAnyOfFourRegimesNearTheThreshold) {
    const VerdictChances chances = verdict_chances(4, 1);
    const auto of_any = [](double chance) { return 1.0 - std::pow(1.0 - chance, 4.0); };
    for (const double p : {0.5, 0.6, 0.7, 0.79, 0.7999}) {
        EXPECT_LE(of_any(chance_of(Keeps::yes, p, chances)), 0.05) << p;
    }
    for (const double p : {0.8, 0.81, 0.9}) {
        EXPECT_LE(of_any(chance_of(Keeps::no, p, chances)), 0.05) << p;
    }
    EXPECT_GT(chance_of(Keeps::yes, 0.99, chances), 0.9);
    EXPECT_GT(chance_of(Keeps::no, 0.4, chances), 0.9);
}

TEST(Decide, CountsYearsAndPercentYearsBelow) {
    const SomeDecision some{{equal(20, 95.0), equal(20, 84.0), equal(20, 91.0), equal(20, 90.0)},
                            {0, 0, -10, -10}};
    const Decision decision = some.decision();
    ASSERT_EQ(decision.at_targets.size(), 4U);
    EXPECT_EQ(decision.at_targets[0].kept.kept, 20U) << "the start with 10 % does not count";
    EXPECT_EQ(decision.at_targets[3].kept.kept, 20U) << "exactly what is asked for is enough";
    const CourseAtTarget& warm = decision.at_targets[1];
    EXPECT_EQ(warm.kept.kept, 0U);
    EXPECT_NEAR(warm.forest.years_below.mean, 5.0, 1e-9) << "one year with rocks stands for five";
    EXPECT_NEAR(warm.forest.percent_years_lost.mean, 5.0 * 6.0, drawn_points);
    EXPECT_EQ(warm.forest.lowest->year, 5);
    EXPECT_EQ(decision.first_year, 5);
    EXPECT_EQ(decision.of_course(0), Keeps::yes);
    EXPECT_EQ(decision.of_regime(some.names, 0), Keeps::no) << "not in the warm climate";
    EXPECT_EQ(decision.of_regime(some.names, 1), Keeps::yes);
    // 20 and 10 m3/ha in ten years; margins of year 10 count 1.015^-10.
    EXPECT_DOUBLE_EQ(decision.money[0].removed_m3pha_a_year.mean, 3.0);
    EXPECT_NEAR(decision.money[2].present_values_eur_pha[0], -10.0 * std::pow(1.015, -10.0), 1e-9);
}

TEST(Decide, CountsWhatStandsSoThatFellingItGainsNothing) {
    const SomeDecision some{{equal(20, 95.0), equal(20, 95.0), equal(20, 95.0), equal(20, 95.0)},
                            {0, 0, 4000, 4000}};  // the second regime fells the stock in the last year
    std::vector<Series> series = some.series();
    Series standing{.quantity = "standing_value_eur_pha", .target = "", .values = {}};
    for (std::size_t course = 0; course < 4; ++course) {
        const double at_end = course < 2 ? 4000.0 : 0.0;
        standing.values.emplace_back(20, std::map<std::int32_t, double>{{0, 3500.0}, {10, at_end}});
    }
    series.push_back(standing);
    const Decision decision = *decide(some.names, series, {}, some.settings);
    EXPECT_NEAR(decision.money[0].present_values_eur_pha[0], decision.money[2].present_values_eur_pha[0],
                1e-9);
    EXPECT_NEAR(decision.money[0].stock_value_eur_pha.mean, 4000.0 * std::pow(1.015, -10.0) - 3500.0, 1e-9);
    EXPECT_NEAR(decision.money[2].stock_value_eur_pha.mean, -3500.0, 1e-9);
    EXPECT_GT(decision.money[2].work_value_eur_pha.mean, 3000.0);
}

TEST(Verdict, NamesTheCheapestRegimeThatKeepsProtectionInAllClimates) {
    const SomeDecision some{{equal(20, 95.0), equal(20, 84.0), equal(20, 91.0), equal(20, 93.0)},
                            {0, 0, -100, -100}};
    const std::string words = some.words();
    EXPECT_TRUE(
        has(words,
            "Regime pfm1 is the cheapest regime that keeps protection of at least 90 % in all years with "
            "rocks (5 to 10) with a probability of 80 %, in each of 2 climates"))
        << words;
    EXPECT_FALSE(has(words, "regime none")) << "it fails in the warm climate: " << words;
}

TEST(Verdict, TakesTheCheaperOfTwoAndSaysHowMuchTheOtherCosts) {
    const SomeDecision some{{equal(20, 95.0), equal(20, 95.0), equal(20, 95.0), equal(20, 95.0)},
                            {0, 0, -100, -100}};
    const std::string words = some.words();
    EXPECT_TRUE(has(words, "Regime none is the cheapest regime")) << words;
    EXPECT_TRUE(has(words, "Regime pfm1 keeps it too")) << words;
}

TEST(Verdict, SaysThatNoneKeepsIt) {
    const SomeDecision some{{equal(20, 80.0), equal(20, 70.0), equal(20, 85.0), equal(20, 75.0)},
                            {0, 0, 0, 0}};
    const std::string words = some.words();
    EXPECT_TRUE(has(words, "No regime keeps protection of at least 90 %")) << words;
    EXPECT_TRUE(has(words, "Regime pfm1 loses least: where it is worst (climate warm), 0 of 20 replicates"))
        << words;
}

TEST(Verdict, OfThreeReplicatesSaysHowManyWouldDecide) {
    const SomeDecision some{{equal(3, 80.0), equal(3, 80.0), equal(3, 95.0), equal(3, 95.0)}, {0, 0, 0, 0}};
    const std::string words = some.words();
    EXPECT_TRUE(has(words, "No regime is known to keep")) << words;
    EXPECT_TRUE(has(words, "Regime pfm1 is undecided")) << words;
    EXPECT_TRUE(has(words,
                    "3 of 3 replicates keep it (29 to 100 %, for all regimes together with 95 %); about 17 "
                    "replicates would decide"))
        << words;
}

TEST(Verdict, SaysOfManyUndecidedRegimesInOneSentenceHowSureTheyAre) {
    std::vector<double> some_fail = equal(20, 95.0);
    some_fail[3] = some_fail[9] = some_fail[15] = 80.0;
    const SomeDecision some{
        {some_fail, some_fail, some_fail}, {0, 0, 0}, {{"none", "pfm1", "own"}, {}, species(), {"present"}}};
    const std::string words = some.words();
    EXPECT_TRUE(has(words, "3 regimes are undecided; the probability that the worst year keeps it")) << words;
    EXPECT_FALSE(has(words, "Regime own is undecided")) << words;
    const Decision decision = some.decision();
    ASSERT_TRUE(decision.at_targets[0].worst());
    // 17 of 20 without noise: Jeffreys, Beta(17.5, 3.5); 1000 draws scatter its median.
    EXPECT_NEAR(decision.at_targets[0].worst()->median(), 0.841, 0.02);
    EXPECT_EQ(decision.at_target(some.names, decision.at_targets[0]), Keeps::undecided);
}

TEST(Verdict, SaysWhyFewerReplicatesCountThanWereSimulated) {
    const std::string not_counted =
        "Replicates without a protection figure in any year after the start are not";
    std::vector<double> one_unknown = equal(3, 80.0);
    one_unknown.back() = std::nan("");
    const SomeDecision some{{one_unknown, one_unknown, one_unknown, one_unknown}, {0, 0, 0, 0}};
    EXPECT_TRUE(has(some.words(), "0 of 2 replicates keep it")) << some.words();
    EXPECT_TRUE(has(some.words(), not_counted)) << some.words();
    const SomeDecision all{{equal(3, 80.0), equal(3, 80.0), equal(3, 80.0), equal(3, 80.0)}, {0, 0, 0, 0}};
    EXPECT_FALSE(has(all.words(), not_counted)) << all.words();
}

TEST(Verdict, SaysOnceWhatHoldsForAllUndecidedRegimes) {
    SomeDecision some{
        {equal(3, 95.0), equal(3, 95.0), equal(3, 95.0), equal(3, 95.0), equal(3, 96.0), equal(3, 96.0)},
        {0, 0, 0, 0, 0, 0}};
    some.names.regimes = {"none", "thin", "cut"};
    const std::string words = some.words();
    EXPECT_TRUE(has(words, "none 3 of 3; thin 3 of 3; cut 3 of 3")) << words;
    EXPECT_FALSE(has(words, "Regime none is undecided")) << words;
}

TEST(DecisionHtml, ShowsNoIntervalThatSaysNothing) {
    // Two replicates that disagree wholly: intervals reach far beyond 100 %.
    const SomeDecision some{{{100.0, 0.0}, {100.0, 0.0}, {0.0, 100.0}, {0.0, 100.0}}, {0, 0, 0, 0}};
    const std::string html = decision_html(some.names, some.decision(), "");
    const Decision decision = some.decision();
    ASSERT_TRUE(decision.at_targets[0].forest.lowest);
    ASSERT_LT(decision.at_targets[0].forest.lowest->value.band.low, -100.0);
    EXPECT_EQ(html.find(report::fixed(decision.at_targets[0].forest.lowest->value.band.low, 1)),
              std::string::npos)
        << html;
    EXPECT_TRUE(has(html, "A dash: too few rocks for a protection figure.")) << html;
}

TEST(PercentYearsLost, GoOnAfterTheLastYearAsItWas) {
    // Below 90 % in year 5, which stands for five years; the last year keeps it, or lacks as much.
    SomeDecision some{{{80.0, 84.0}, {80.0, 84.0}, {80.0, 84.0}, {80.0, 84.0}}, {0, 0, 0, 0}};
    const auto lost = [&](double last_percent, double years_beyond) {
        std::vector<Series> series = some.series();
        for (auto& course : series.front().values) {
            for (auto& replicate : course) {
                replicate[10] = last_percent;
            }
        }
        DecisionSettings settings;
        settings.years_beyond = years_beyond;
        return decide(some.names, series, {}, settings)->at_targets.front().forest.percent_years_lost.mean;
    };
    EXPECT_NEAR(lost(99.0, 0.0), 5.0 * 8.0, drawn_points);
    EXPECT_NEAR(lost(99.0, 20.0), 5.0 * 8.0, drawn_points) << "nothing is missing in the last year";
    EXPECT_NEAR(lost(80.0, 0.0), 5.0 * 8.0 + 5.0 * 10.0, drawn_points);
    EXPECT_NEAR(lost(80.0, 20.0), 5.0 * 8.0 + 25.0 * 10.0, 5.0 * drawn_points);
}

TEST(CostOfAPercentYear, IsKnownWhereTheGainIs) {
    std::vector<double> low{80.0, 81.0, 82.0, 80.5};
    std::vector<double> high{86.0, 86.5, 88.5, 86.0};
    const SomeDecision some{{low, low, high, high}, {0, 0, -120, -120}};
    const Decision decision = some.decision();
    const auto cost = cost_of_a_percent_year(decision.at_targets[2], decision.at_targets[0],
                                             decision.money[2], decision.money[0]);
    ASSERT_TRUE(cost);
    const double gained = 5.0 * (6.0 + 5.5 + 6.5 + 5.5) / 4.0;
    EXPECT_NEAR(*cost, 120.0 * std::pow(1.015, -10.0) / gained, 0.01);
    EXPECT_FALSE(cost_of_a_percent_year(decision.at_targets[0], decision.at_targets[2], decision.money[0],
                                        decision.money[2]));
}

TEST(DecisionHtml, HasAllClimatesAndEscapesNames) {
    SomeDecision some{{equal(20, 95.0), equal(20, 84.0), equal(20, 91.0), equal(20, 93.0)},
                      {0, 0, -100, -100}};
    some.names.regimes[1] = "a <b>";
    const std::string html = decision_html(some.names, some.decision(), "");
    EXPECT_TRUE(has(html, "a &lt;b&gt; is the cheapest"));
    EXPECT_FALSE(has(html, "a <b>"));
    EXPECT_LT(html.find("present"), html.find(">warm<"));
    EXPECT_TRUE(has(html, "in year 5"));
}

}  // namespace
}  // namespace coupling::decades::decision_test
