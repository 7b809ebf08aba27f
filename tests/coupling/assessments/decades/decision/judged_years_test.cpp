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
#include "coupling/assessments/decades/decision/rock_noise.hpp"
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

/// Of few replicates whose spread the rocks explain nothing is left without noise: no yes comes of that.
TEST(Margins, DoNotCountNoiseThatWasTakenOut) {
    const VerdictChances chances = verdict_chances(6, 1);
    CourseAtTarget at;
    at.kept = kept_share(5, 6, chances);
    at.kept_without_noise = kept_share(6, 6, chances);
    at.lowest_of_replicates = {6, 79.0, 4.0};
    const DecisionSettings settings{.protection_at_least_percent = 75.0, .probability = 0.8};
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided);
    at.kept = kept_share(0, 20, chances);
    at.kept_without_noise = kept_share(20, 20, chances);
    EXPECT_EQ(judge(at, settings, chances), Keeps::undecided) << "low by the rocks alone";
    at.kept_without_noise = kept_share(0, 20, chances);
    EXPECT_EQ(judge(at, settings, chances), Keeps::no);
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

RC_GTEST_PROP(RockNoise, LeavesTheMeanAndNoMoreVarianceThanThereWas, ()) {
    std::vector<double> values(*rc::gen::inRange<std::size_t>(1, 30));
    for (double& value : values) {
        value = 0.1 * *rc::gen::inRange(0, 1000);
    }
    const auto variance_of = [](const std::vector<double>& of) {
        const double mean = std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
        double sum = 0.0;
        for (const double value : of) {
            sum += (value - mean) * (value - mean);
        }
        return of.size() > 1 ? sum / static_cast<double>(of.size() - 1) : 0.0;
    };
    std::vector<double> less = values;
    const double noise = 0.5 * *rc::gen::inRange(0, 200);
    take_noise_out(less, noise);
    RC_ASSERT(std::abs(std::accumulate(less.begin(), less.end(), 0.0) -
                       std::accumulate(values.begin(), values.end(), 0.0)) < 1e-6);
    if (values.size() > 1) {
        RC_ASSERT(std::abs(variance_of(less) - std::max(0.0, variance_of(values) - noise)) < 1e-6);
    }
}

/// The lowest of forty years with few rocks is that of the forest, not of the rocks.
TEST(RockNoise, DoesNotMakeTheLowestYearLower) {
    std::mt19937 engine{11};
    std::normal_distribution<double> normal;
    constexpr int replicates = 20;
    constexpr double noise = 4.0;
    double true_lowest = 0.0;
    double seen_lowest = 0.0;
    double lowest_without = 0.0;
    constexpr int studies = 50;
    for (int study = 0; study < studies; ++study) {
        std::vector<std::map<std::int32_t, double>> truth(replicates);
        std::vector<std::map<std::int32_t, double>> seen(replicates);
        std::map<std::int32_t, double> variances;
        for (std::size_t r = 0; r < truth.size(); ++r) {
            for (std::int32_t year = 1; year <= 40; ++year) {
                const double dip = year > 12 && year < 16 ? 10.0 : 0.0;
                truth[r][year] = 85.0 - dip + 1.5 * normal(engine);
                seen[r][year] = truth[r][year] + noise * normal(engine);
                variances[year] = noise * noise;
            }
        }
        const auto without = without_rock_noise(seen, variances);
        const auto lowest = [&](const std::vector<std::map<std::int32_t, double>>& all) {
            double sum = 0.0;
            for (const auto& years : all) {
                sum += std::min_element(years.begin(), years.end(), [](const auto& a, const auto& b) {
                           return a.second < b.second;
                       })->second;
            }
            return sum / replicates;
        };
        true_lowest += lowest(truth) / studies;
        seen_lowest += lowest(seen) / studies;
        lowest_without += lowest(without) / studies;
    }
    EXPECT_LT(seen_lowest, true_lowest - 2.0);
    EXPECT_NEAR(lowest_without, true_lowest, 0.5);
}

}  // namespace
}  // namespace coupling::decades::judged_years_test
