#include "coupling/program/actions/pilot.hpp"

#include <gtest/gtest.h>

#include "coupling/program/actions/estimate.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::pilot_test {
namespace {

Opened open_rigid(const SampleProject& project, const std::string& rocks) {
    return open(project, {"rockfall.motion=rigid", "release.shape=cube", "release.rocks=" + rocks});
}

TEST(Pilot, TakesLongerForAModelInStepsThanForOneOfJumps) {
    const SampleProject project;
    const Opened rigid = open_rigid(project, "20");
    const Opened picus = open(project, {"release.rocks=20"});
    ASSERT_TRUE(rigid.site && picus.site) << rigid.errors << picus.errors;
    const double picus_s = pilot_seconds_per_rock(*picus.scenario, *picus.site);
    const double rigid_s = pilot_seconds_per_rock(*rigid.scenario, *rigid.site);
    EXPECT_GE(picus_s, 0.0);
    EXPECT_GT(rigid_s, 3.0 * picus_s);
}

TEST(Pilot, GivesAnEstimateThatGrowsWithTheRocksAndFallsWithTheThreads) {
    const SampleProject project;
    const Opened few = open_rigid(project, "40");
    const Opened many = open_rigid(project, "400");
    ASSERT_TRUE(few.site && many.site) << few.errors << many.errors;
    const double few_s = estimate_of(*few.scenario, *few.site, 1).seconds;
    const double many_s = estimate_of(*many.scenario, *many.site, 1).seconds;
    // Ten times the rocks; each pilot is good to a factor of two.
    EXPECT_GT(many_s, 2.5 * few_s);
    EXPECT_LT(many_s, 40.0 * few_s);
    EXPECT_LT(estimate_of(*many.scenario, *many.site, 8).seconds, many_s);
}

}  // namespace
}  // namespace coupling::pilot_test
