#include "validation/engine/case/over_seeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/validation/forest_cases/case_runs.hpp"

namespace coupling::validation::over_seeds_test {
namespace {

using forest_cases::result_of;
using forest_cases::shipped;

/// A comparison with the figures "a" and "b".
Comparison with(double a, double b) {
    Comparison comparison;
    comparison.extent = "1 site";
    comparison.pieces = 3;
    comparison.run = [a, b](const Work&) {
        Outcome outcome;
        outcome.values = {{"a", a}, {"b", b}};
        return outcome;
    };
    return comparison;
}

TEST(OverSeeds, GivesMeansAndTheDeviationBetweenSeeds) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const Comparison all =
        over_seeds(with(1.0, 5.0), {[] { return with(2.0, 5.0); }, [=] { return with(6.0, none); }});
    EXPECT_EQ(all.pieces, 9U);
    EXPECT_EQ(all.extent, "1 site, 3 seeds");
    const Outcome outcome = all.run({});
    EXPECT_DOUBLE_EQ(outcome.values.at("a"), 3.0);
    EXPECT_DOUBLE_EQ(outcome.seed_deviations.at("a"), std::sqrt(7.0));  // (4 + 1 + 9) / 2
    EXPECT_TRUE(std::isnan(outcome.values.at("b"))) << "a seed without a value leaves none";
    EXPECT_FALSE(outcome.seed_deviations.contains("b"));
}

TEST(OverSeeds, OfOneSeedIsThatSeed) {
    const Comparison one = over_seeds(with(1.0, 5.0), {});
    EXPECT_EQ(one.extent, "1 site");
    EXPECT_TRUE(one.run({}).seed_deviations.empty());
}

TEST(OverSeeds, OfACaseIsTheMeanOfItsRunsWithThoseSeeds) {
    // Two replicates of the thinned plot, so that trees die by chance.
    const CaseFiles files = shipped("forest_hauersteig");
    const auto values = [&](std::vector<std::string> more) {
        CaseChanges changes;
        changes.overrides = {"run.replicates=2"};
        changes.overrides.insert(changes.overrides.end(), more.begin(), more.end());
        return result_of(files, changes).variants.front().values;
    };
    const auto first = values({"years.seeds=1", "run.seed=4"});
    const auto second = values({"years.seeds=1", "run.seed=5"});
    const auto both = values({"years.seeds=2", "run.seed=4"});
    for (const char* figure : {"stems_ratio:all", "thickest_dbh_ratio:all"}) {
        const double a = first.at(figure).value;
        const double b = second.at(figure).value;
        EXPECT_NE(a, b);
        EXPECT_NEAR(both.at(figure).value, 0.5 * (a + b), 1e-12);
        EXPECT_NEAR(both.at(figure).deviation.value(), std::abs(a - b) / std::sqrt(2.0), 1e-12);
        EXPECT_FALSE(first.at(figure).deviation);
    }
}

}  // namespace
}  // namespace coupling::validation::over_seeds_test
