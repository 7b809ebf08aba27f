#include "validation/engine/factors/factors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/results/markup_checks.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation::factors_test {
namespace {

/// A steep even slope on which 40 rocks fall through each of five stands, for two settings.
CaseFiles small_case() {
    CaseFiles files{.name = "small", .folder = "validation/small", .texts = {}};
    files.texts["case.ini"] =
        "[case]\ntitle = small\nkind = factors\n[rock]\ndiameter_m = 0.95\n"
        "[series]\nrocks = 50\nseries = 20\nrocks_per_series = 40\n"
        "[terrain]\nwidth_m = 100\ncell_m = 5\n"
        "[stand]\nstems_per_ha = 300\ndbh_mean_cm = 30\ndbh_deviation_cm = 15\nspecies = ABAL:100\n"
        "from_m = 0\nto_m = 100\nstands = 20\n";
    files.texts["profile.csv"] = "length_m,slope_deg,surface\n100,38,forest_soil\n";
    files.texts["factors.csv"] =
        "setting,values,how\nstand.stems_per_ha,100 300 900,crossed\nstand.dbh_mean_cm,20 40,crossed\n"
        "stand.to_m,40 100,alone\n";
    files.texts["directions.csv"] =
        "figure,setting,expected,source\nprotection_effect,stand.stems_per_ha,rises,a paper\n"
        "free_path_m,stand.stems_per_ha,falls,geometry\n";
    return files;
}

FactorPlan plan_of(const CaseFiles& files) {
    return read_factor_plan(files, *read_recipe(files, {}));
}

std::string problem_with(const std::string& file, const std::string& text) {
    CaseFiles files = small_case();
    files.texts[file] = text;
    try {
        plan_of(files);
    } catch (const config::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(FactorPlan, CrossesSettingsAndMovesTheOthersAlone) {
    const FactorPlan plan = plan_of(small_case());
    const std::vector<Combination> combinations = plan.combinations();
    ASSERT_EQ(combinations.size(), 3U * 2U + 2U);
    EXPECT_EQ(combinations[0], (Combination{100.0, 20.0, 100.0}));
    EXPECT_EQ(combinations[5], (Combination{900.0, 40.0, 100.0}));
    EXPECT_EQ(combinations[6], (Combination{300.0, 30.0, 40.0})) << "all others as in the recipe";
    EXPECT_TRUE(plan.is_crossed(combinations[5]));
    EXPECT_FALSE(plan.is_crossed(combinations[6]));
    EXPECT_EQ(plan.alone_at(5), "");
    EXPECT_EQ(plan.alone_at(6), "stand.to_m");
}

TEST(FactorPlan, KeepsTheVariationOfDiameters) {
    const CaseFiles files = small_case();
    const auto recipe = read_recipe(files, {});
    const std::vector<std::string> overrides = plan_of(files).overrides({100.0, 20.0, 100.0}, *recipe);
    EXPECT_NE(std::find(overrides.begin(), overrides.end(), "stand.dbh_deviation_cm=10"), overrides.end());
}

TEST(ReadFactorPlan, NamesWhatIsWrong) {
    EXPECT_EQ(problem_with("factors.csv", small_case().texts["factors.csv"]), "");
    EXPECT_NE(problem_with("factors.csv", "setting,values,how\nstand.trees,1 2,crossed\n")
                  .find("validation/small/factors.csv:2:1: found 'stand.trees'"),
              std::string::npos);
    EXPECT_NE(problem_with("factors.csv", "setting,values,how\nstand.stems_per_ha,400 200,crossed\n")
                  .find("two or more rising numbers"),
              std::string::npos);
    EXPECT_NE(problem_with("directions.csv", "figure,setting,expected,source\nhits,stand.to_m,grows,x\n")
                  .find("rises or falls"),
              std::string::npos);
}

TEST(BasalArea, CountsTheScatterOfDiameters) {
    // 100 stems of 40 cm are 12.57 m2; the variance of the diameter adds to the mean square.
    EXPECT_NEAR(basal_area_m2pha(100.0, 40.0, 0.0), 12.566, 0.001);
    EXPECT_NEAR(basal_area_m2pha(100.0, 40.0, 20.0), 1.25 * 12.566, 0.001);
}

/// Figures that are sure to be `slope` times the number of stems.
std::vector<CombinationOutcome> straight_outcomes(const FactorPlan& plan, double slope, double scatter) {
    std::vector<CombinationOutcome> outcomes;
    for (const Combination& combination : plan.combinations()) {
        CombinationOutcome outcome;
        outcome.settings = combination;
        outcome.basal_area_m2pha = basal_area_m2pha(combination[0], combination[1], 0.0);
        outcome.figures["protection_effect"] = {slope * combination[0], {scatter, -scatter, 0.0}};
        // Another stand in each combination: pulls do not cancel in differences.
        if (combination[0] > 300.0) {
            std::reverse(outcome.figures["protection_effect"].pulls.begin(),
                         outcome.figures["protection_effect"].pulls.end());
        }
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

TEST(JudgeDirection, HoldsWhereEveryStepGoesThatWay) {
    const FactorPlan plan = plan_of(small_case());
    const Direction rises{"protection_effect", "stand.stems_per_ha", true, ""};
    const DirectionRow row = judge_direction(rises, plan, straight_outcomes(plan, 0.001, 0.0));
    EXPECT_EQ(row.verdict, Verdict::inside);
    EXPECT_EQ(row.steps, (std::vector<double>{100.0, 300.0, 900.0}));
    EXPECT_DOUBLE_EQ(row.change.value, 0.8);
    EXPECT_EQ(row.steps_against, 0U);
}

TEST(JudgeDirection, CountsStepsThatGoTheOtherWay) {
    const FactorPlan plan = plan_of(small_case());
    const Direction falls{"protection_effect", "stand.stems_per_ha", false, ""};
    const DirectionRow row = judge_direction(falls, plan, straight_outcomes(plan, 0.001, 0.0));
    EXPECT_EQ(row.verdict, Verdict::missed);
    EXPECT_EQ(row.steps_against, 2U);
}

TEST(JudgeDirection, IsMissedWhereTheEndsDifferByLessThanTheirInterval) {
    const FactorPlan plan = plan_of(small_case());
    const Direction rises{"protection_effect", "stand.stems_per_ha", true, ""};
    const DirectionRow row = judge_direction(rises, plan, straight_outcomes(plan, 0.001, 1.0));
    EXPECT_EQ(row.steps_against, 0U);
    EXPECT_EQ(row.verdict, Verdict::missed);
}

TEST(JudgeDirection, RanksStandsByBasalArea) {
    const FactorPlan plan = plan_of(small_case());
    const Direction rises{"protection_effect", basal_area, true, ""};
    const DirectionRow row = judge_direction(rises, plan, straight_outcomes(plan, 0.001, 0.0));
    ASSERT_EQ(row.steps.size(), 3U);
    // 100 x 20, 300 x 20 | 100 x 40, 900 x 20 | 300 x 40, 900 x 40: pi / 4 times stems times diameter
    // squared.
    EXPECT_NEAR(row.steps[0], 0.5 * (3.1416 + 9.4248), 0.001);
    EXPECT_NEAR(row.at_steps[2].value, 0.001 * 600.0, 1e-12);
}

TEST(JudgeDirection, LeavesOutWhatMovesAlone) {
    const FactorPlan plan = plan_of(small_case());
    std::vector<CombinationOutcome> outcomes = straight_outcomes(plan, 0.001, 0.0);
    outcomes.back().figures["protection_effect"].value = 1000.0;
    const Direction rises{"protection_effect", "stand.stems_per_ha", true, ""};
    EXPECT_DOUBLE_EQ(judge_direction(rises, plan, outcomes).at_steps[1].value, 0.3);
}

CaseResult small_result(int threads) {
    return validate_factors(read_case(small_case()), threads);
}

TEST(ValidateFactors, FindsProtectionRisingAndTheFreePathFalling) {
    const CaseResult result = small_result(2);
    ASSERT_EQ(result.directions.size(), 4U) << "two directions in strict and in default";
    for (const DirectionRow& row : result.directions) {
        EXPECT_EQ(row.verdict, Verdict::inside) << row.variant << ' ' << row.figure;
    }
    EXPECT_EQ(result.factors.size(), 2U * 8U);
    EXPECT_EQ(result.variants.size(), 2U);
}

TEST(ValidateFactors, MeetsTheAnalyticFreePath) {
    // Rocks also go sideways, which makes their way down the slope a little shorter than their path; the rest
    // is chance: some 1600 hits in twenty stands in which places near the start count again and again.
    for (const FactorRow& row : small_result(2).factors) {
        const double ratio =
            row.figures.at("free_path_m").value / row.figures.at("analytic_free_path_m").value;
        EXPECT_GT(ratio, 0.6) << row.variant;
        EXPECT_LT(ratio, 1.5) << row.variant;
    }
}

TEST(ValidateFactors, GivesTheSameForAnyNumberOfThreads) {
    const CaseResult one = small_result(1);
    const CaseResult three = small_result(3);
    ASSERT_EQ(one.factors.size(), three.factors.size());
    for (std::size_t i = 0; i < one.factors.size(); ++i) {
        for (const auto& [name, estimate] : one.factors[i].figures) {
            const double other = three.factors[i].figures.at(name).value;
            EXPECT_TRUE(estimate.value == other || (std::isnan(estimate.value) && std::isnan(other))) << name;
        }
    }
}

TEST(FactorsPart, ShowsEachDirectionOnceWithBothVerdicts) {
    const std::string part = factors_part(small_result(2));
    EXPECT_EQ(coupling::text_checks::markup_fault(part), "");
    const std::size_t first = part.find("protection effect rises with stems/ha");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(part.find("protection effect rises with stems/ha", first + 1), std::string::npos);
    for (const char* text :
         {"Way between tree hits", "1 / (n (D + DBH)), m", "Protection effect over lower end"}) {
        EXPECT_NE(part.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(factors_part({}), "");
}

}  // namespace
}  // namespace coupling::validation::factors_test
