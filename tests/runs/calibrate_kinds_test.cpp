#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/runs/calibrations.hpp"

namespace coupling::calibrate_kinds_test {
namespace {

/// A stand in which rocks that go far hit other stems than rocks that do not: the thick ones stand below.
void plant(const SampleProject& project) {
    std::string trees = "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    int id = 0;
    for (int x_m = 1045; x_m < 1112; x_m += 6) {
        for (int y_m = 2022; y_m < 2086; y_m += 5) {
            trees += std::to_string(++id) + "," + std::to_string(x_m) + "," + std::to_string(y_m) + ",ABAL," +
                     (x_m < 1080 ? "12" : "30") + ",15\n";
        }
    }
    project.write("trees.csv", trees);
}

/// What a posterior says of the losses on soil, fitted to one kind of observation alone, where the true
/// losses were these.
Logarithm fitted_losses(const std::string& truth, const std::string& observed) {
    const SampleProject project;
    plant(project);
    simulate_truth(project, "", "set,weight,losses\n1,1," + truth + "\n",
                   "--set output.impact_table=yes --set output.sample_paths=60");
    write_tracks(project);
    write_outline(project);
    write_searched_stems(project);
    const Outcome outcome = call(
        project, "calibrate scenario.ini --quiet " + many_sets + "--set calibrate.rocks=120 " + observed);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return logarithm_of(written_table(project, "calibration/tables/posterior.csv"),
                        {"losses", "losses_on.3"});
}

/// Two truths, one at each side of what is known before. Whoever left the kind out would give both the same
/// sets; a kind that is read the wrong way round would exchange them.
class KindsOfObservations : public testing::TestWithParam<const char*> {};

TEST_P(KindsOfObservations, MoveThePosteriorTowardsTheTruth) {
    const Logarithm few = fitted_losses("0.67", GetParam());
    const Logarithm many = fitted_losses("1.5", GetParam());
    // Both truths are as far from 0 (ln 1.5 = 0.41), but rocks that lose little leave the terrain, and nobody
    // sees them. Sets of a kind that is not read are the same for both, to the last bit. Four standard errors
    // of the searches.
    EXPECT_GT(many.mean, 4.0 * many.error);
    EXPECT_GT(many.mean - few.mean, 4.0 * std::hypot(many.error, few.error));
}

INSTANTIATE_TEST_SUITE_P(
    LongAlone, KindsOfObservations,
    testing::Values("--set observed.trees=searched.csv --set observed.rocks=120",
                    "--set observed.outline=outline.csv --set calibrate.outline_blocks=100",
                    "--set observed.impacts=impacts.csv"),
    [](const testing::TestParamInfo<const char*>& kind) {
        return std::string{kind.index == 0 ? "SearchedStems" : kind.index == 1 ? "Outline" : "Jumps"};
    });

}  // namespace
}  // namespace coupling::calibrate_kinds_test
