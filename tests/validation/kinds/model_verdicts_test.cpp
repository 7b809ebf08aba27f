#include "validation/engine/kinds/model_verdicts.hpp"

#include <gtest/gtest.h>

namespace coupling::validation::model_verdicts_test {
namespace {

VerdictRow row(std::string quantity, std::string model, std::string rests_on, Verdict verdict) {
    VerdictRow made;
    made.quantity = std::move(quantity);
    made.model = std::move(model);
    made.rests_on = std::move(rests_on);
    made.low = 10.0;
    made.high = 20.0;
    made.default_verdict = verdict;
    return made;
}

CaseResult field_case() {
    CaseResult result;
    result.rows = {row("run_out_mean_m", "picus", "fitted", Verdict::inside),
                   row("ks:block 1", "picus", "independent", Verdict::missed),
                   row("rigid.run_out_mean_m", "rigid", "fitted", Verdict::missed),
                   row("first_angle_in_deg:a", "", "independent", Verdict::inside),
                   row("reduction.mean_speed_mps", "picus", "independent", Verdict::inside),
                   row("run_out_longest_m", "picus", "independent", Verdict::no_criterion)};
    VariantOutcome ours;
    ours.variant = "default";
    ours.values = {{"pir3d.run_out_mean_m", {15.0, {}, {}}},
                   {"rigid.run_out_mean_m", {15.0, {}, {}}},
                   {"classical.ks:block 1", {0.4, {}, {}}}};
    result.variants = {ours};
    return result;
}

TEST(QuantityOf, ReadsWhatAFigureIsAboutFromItsName) {
    EXPECT_EQ(quantity_of("run_out_mean_m:block 1"), "stops");
    EXPECT_EQ(quantity_of("rigid.run_out_deviation_m"), "spread");
    EXPECT_EQ(quantity_of("energy_distance_m"), "stops");
    EXPECT_EQ(quantity_of("energy_p90_kj"), "energy");
    EXPECT_EQ(quantity_of("max_speed_p90_mps"), "speed");
    EXPECT_EQ(quantity_of("max_height_max_centre_m"), "height");
    EXPECT_EQ(quantity_of("sideways_deviation_m"), "sideways");
    EXPECT_EQ(quantity_of("first_normal_ratio_p90:rock_shallow"), "rebounds");
    EXPECT_EQ(quantity_of("passage.speed_mps:road.mean"), "speed");
    EXPECT_EQ(quantity_of("shadow_below_27.5_percent:speed"), "stops") << "a state may have any name";
    EXPECT_EQ(quantity_of("reduction.mean_speed_mps"), "") << "the effect of a forest";
    EXPECT_EQ(quantity_of("tree_hits_mean"), "");
}

TEST(ModelVerdicts, CountTheCriteriaOfEachModel) {
    const std::vector<ModelVerdict> verdicts = model_verdicts(field_case());
    ASSERT_EQ(verdicts.size(), 4U);
    EXPECT_EQ(verdicts[0].model, "picus");
    EXPECT_EQ(verdicts[0].verdict.quantity, "stops");
    EXPECT_EQ(verdicts[0].verdict.met, 1U);
    EXPECT_EQ(verdicts[0].verdict.missed, 1U);
    EXPECT_EQ(verdicts[0].verdict.independent_met, 0U);
    EXPECT_EQ(verdicts[0].verdict.independent_missed, 1U);
}

TEST(ModelVerdicts, HoldOtherModelsAgainstTheSameCriteria) {
    const std::vector<ModelVerdict> verdicts = model_verdicts(field_case());
    ASSERT_EQ(verdicts.size(), 4U);
    EXPECT_EQ(verdicts[1].model, "pir3d");
    EXPECT_EQ(verdicts[1].verdict.independent_met, 1U) << "what picus was fitted to, pir3d was not";
    EXPECT_EQ(verdicts[2].model, "classical");
    EXPECT_EQ(verdicts[2].verdict.missed, 1U);
    EXPECT_EQ(verdicts[3].model, "rigid");
    EXPECT_EQ(verdicts[3].verdict.criteria(), 1U) << "its own criterion stands instead";
    EXPECT_EQ(verdicts[3].verdict.independent(), 0U);
}

}  // namespace
}  // namespace coupling::validation::model_verdicts_test
