#include "coupling/inputs/model_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rockfall/motion/models.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::model_limits_test {
namespace {

TEST(ModelLimits, AreTheFirstWarningWhereResultsOfTheModelAreNotConfirmed) {
    const SampleProject project;
    int cautious = 0;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const rockfall::ModelDescription& description = rockfall::description_of(model);
        // A limit of the model is no fault of the input: no error under strict_inputs.
        const Opened opened =
            open(project, {"rockfall.motion=" + std::string{description.name}, "run.strict_inputs=yes"});
        ASSERT_TRUE(opened.site) << description.name << ": " << opened.errors;
        if (description.caution.empty()) {
            continue;
        }
        ++cautious;
        ASSERT_FALSE(opened.warnings.empty()) << description.name;
        EXPECT_EQ(opened.warnings.front(), description.caution);
        // It names its setting and says what to do.
        EXPECT_TRUE(
            description.caution.starts_with("rockfall.motion = " + std::string{description.name} + ":"));
    }
    EXPECT_EQ(cautious, 1) << "rigid blocks, until their stops are confirmed";
}

TEST(ModelLimits, OfOneModelAreNotWarnedOfUnderAnother) {
    const SampleProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const std::string_view caution = rockfall::description_of(model).caution;
        EXPECT_EQ(std::count(opened.warnings.begin(), opened.warnings.end(), caution), 0);
    }
}

}  // namespace
}  // namespace coupling::model_limits_test
