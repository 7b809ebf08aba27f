#include "coupling/assessments/decades/decision/judged_years.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "config/random/quantiles.hpp"
#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/decision/verdict.hpp"

namespace coupling::decades::judged_years_test {
namespace {

const forest::SpeciesTable& species() {
    static const forest::SpeciesTable table = forest::SpeciesTable::shipped();
    return table;
}

/// A regime that leaves the forest alone, one that cuts; rocks every ten years and in the last one.
struct Study {
    std::vector<std::int32_t> rock_years{0, 10, 20, 30, 40, 45};
    std::int32_t cut_year = 12;
    std::string treatment = "clear_cut";
    double lowest_percent = 90.0;
    double value_of_cut_eur_pha = 5000.0;

    [[nodiscard]] Names names() const {
        return {{"none", "cutting"}, {{}, {{"strip", treatment}}}, species(), {"present"}};
    }
    [[nodiscard]] std::vector<MemberYears> members() const {
        std::vector<MemberYears> all;
        for (std::uint32_t replicate = 0; replicate < 30; ++replicate) {
            MemberYears member;
            member.member = {.regime = 1, .replicate = replicate, .climate = 0};
            member.harvest = {{.year = cut_year, .intervention = 0, .stems = 200.0, .taken_m3 = 100.0}};
            all.push_back(std::move(member));
        }
        return all;
    }
    [[nodiscard]] Decision decision() const {
        Series protection{.quantity = "protection_percent", .target = "road", .values = {}};
        Series margin{.quantity = "contribution_margin_eur_pha", .target = "", .values = {}};
        for (std::size_t course = 0; course < 2; ++course) {
            protection.values.emplace_back();
            margin.values.emplace_back();
            for (int replicate = 0; replicate < 30; ++replicate) {
                std::map<std::int32_t, double> years;
                for (const std::int32_t year : rock_years) {
                    years[year] = lowest_percent + 0.1 * (replicate % 5);
                }
                protection.values.back().push_back(years);
                margin.values.back().push_back({{0, 0.0}, {45, course == 1 ? value_of_cut_eur_pha : 0.0}});
            }
        }
        const DecisionSettings settings{.protection_at_least_percent = 75.0, .probability = 0.8};
        const std::vector<MemberYears> cut = members();
        return *decide(names(), std::vector{protection, margin}, cut, settings);
    }
};

TEST(JudgedYears, ARegimeThatCutsBetweenYearsWithRocksDoesNotWin) {
    const Study study;
    const Decision decision = study.decision();
    EXPECT_EQ(decision.unjudged_cuts[1], std::vector<std::int32_t>{12});
    EXPECT_EQ(decision.of_regime(study.names(), 1), Keeps::undecided);
    EXPECT_EQ(decision.keeping(study.names()), std::vector<std::size_t>{0}) << "dearer, but judged";
    std::string words;
    for (const std::string& sentence : verdict(study.names(), decision)) {
        words += sentence;
    }
    EXPECT_NE(words.find("Regime cutting cuts in years (12) in which no rocks fall"), std::string::npos)
        << words;
    EXPECT_EQ(words.find("replicates would decide"), std::string::npos) << words;
}

TEST(JudgedYears, ARegimeThatLiquidatesAtTheEndDoesNotWin) {
    Study study;
    study.cut_year = 42;
    EXPECT_EQ(study.decision().of_regime(study.names(), 1), Keeps::undecided);
}

TEST(JudgedYears, WithRocksAfterTheCutItMayWin) {
    Study study;
    study.cut_year = 9;
    EXPECT_EQ(study.decision().keeping(study.names()).front(), 1U);
    study.cut_year = 44;
    EXPECT_EQ(study.decision().keeping(study.names()).front(), 1U);
    study.cut_year = 12;
    study.treatment = "salvage";
    EXPECT_EQ(study.decision().keeping(study.names()).front(), 1U) << "follows from an event, is no plan";
}

TEST(JudgedYears, AreNamedInWords) {
    EXPECT_EQ(years_in_words({2}), "2");
    EXPECT_EQ(years_in_words({2, 12, 22}), "2, 12, 22");
    EXPECT_EQ(years_in_words({2, 12, 22, 32}), "2, 12, 22, …");
}

TEST(ToleranceFactor, IsThatOfTables) {
    // One-sided normal tolerance limits, 95 % confidence (Natrella 1963, NBS Handbook 91, Table A-7).
    EXPECT_NEAR(config::tolerance_factor(10.0, 0.90, 0.05), 2.355, 0.001);
    EXPECT_NEAR(config::tolerance_factor(20.0, 0.95, 0.05), 2.396, 0.001);
    EXPECT_NEAR(config::tolerance_factor(50.0, 0.90, 0.05), 1.646, 0.001);
}

TEST(Margins, OfFivePointsInTwentyReplicatesOfSixRegimesAreAYes) {
    const VerdictChances chances = verdict_chances(6, 2);
    CourseAtTarget at;
    at.kept = kept_share(20, 20, chances);
    const DecisionSettings settings{.protection_at_least_percent = 75.0, .probability = 0.8};
    at.lowest_of_replicates = {20, 80.0, 2.0};
    EXPECT_EQ(judge(at.kept, settings.probability), Keeps::undecided) << "counts alone take 22";
    EXPECT_EQ(judge(at, settings, chances), Keeps::yes);
    at.lowest_of_replicates = {20, 80.0, 4.0};
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided);
    at.lowest_of_replicates = {20, 83.5, 0.7};
    at.kept = kept_share(19, 20, chances);
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided) << "one of them does not keep it";
    at.kept = kept_share(5, 5, chances);
    at.lowest_of_replicates = {5, 99.0, 0.1};
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided) << "five show no spread";
}

/// In so many of so many replicates of each draw.
WorstYear kept_in_all_draws(std::size_t kept, std::size_t replicates) {
    return WorstYear{std::vector<double>(CourseLaw::groups, static_cast<double>(kept)), replicates};
}

/// A replicate that rocks alone take below the threshold is no "no", and five of six are no "yes".
TEST(Margins, DoNotCountNoiseThatWasTakenOut) {
    const VerdictChances chances = verdict_chances(6, 1);
    CourseAtTarget at;
    at.kept = kept_share(5, 6, chances);
    at.forest.worst = kept_in_all_draws(6, 6);
    at.lowest_of_replicates = {6, 79.0, 4.0};
    const DecisionSettings settings{.protection_at_least_percent = 75.0, .probability = 0.8};
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided);
    at.kept = kept_share(0, 20, chances);
    at.forest.worst = kept_in_all_draws(18, 20);
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided) << "low by the rocks alone";
    at.forest.worst = kept_in_all_draws(0, 20);
    EXPECT_EQ(judge(at, settings, chances), Keeps::no);
    // Five replicates show no spread, but their count may say "no" as well.
    at.kept = kept_share(0, 5, chances);
    at.forest.worst = kept_in_all_draws(0, 5);
    EXPECT_EQ(judge(at, settings, chances), Keeps::no);
    at.forest.worst = kept_in_all_draws(4, 5);
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided);
}

/// A lucky seed: of regimes that keep the goal with just the probability asked for, few are called "yes".
TEST(Margins, SeldomCallAYesAtTheThreshold) {
    std::mt19937 engine{5};
    std::normal_distribution<double> normal;
    constexpr int studies = 4000;
    constexpr double deviation = 2.0;
    // 80 % of a normal distribution lie above its mean less 0.8416 deviations.
    constexpr double mean = 75.0 + 0.8416 * deviation;
    int wrong = 0;
    for (int study = 0; study < studies; ++study) {
        Lowest lowest{20, 0.0, 0.0};
        std::vector<double> values(20);
        std::generate(values.begin(), values.end(), [&] { return mean + deviation * normal(engine); });
        lowest.mean_percent = std::accumulate(values.begin(), values.end(), 0.0) / 20.0;
        for (const double value : values) {
            lowest.deviation_percent += std::pow(value - lowest.mean_percent, 2.0) / 19.0;
        }
        lowest.deviation_percent = std::sqrt(lowest.deviation_percent);
        wrong += is_above(lowest, 75.0, 0.8, 0.05) ? 1 : 0;
    }
    EXPECT_NEAR(wrong / static_cast<double>(studies), 0.05, 4.0 * std::sqrt(0.05 * 0.95 / studies));
}

}  // namespace
}  // namespace coupling::decades::judged_years_test
