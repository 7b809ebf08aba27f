#include "rockfall/laws/stopping.hpp"

#include <gtest/gtest.h>

namespace rockfall::stopping_test {
namespace {

TEST(StopCurve, IsStraightInTheLogarithmOfDiameterAndConstantBeyond) {
    const StopCurve curve{{{0.5, 0.03}, {2.0, 0.01}}};
    EXPECT_NEAR(curve.at(1.0), 0.02, 1e-12);
    EXPECT_EQ(curve.at(0.1), 0.03);
    EXPECT_EQ(curve.at(5.0), 0.01);
    EXPECT_EQ(StopCurve{}.at(1.0), 0.0);
}

TEST(StopCurve, TimesAFactorIsCutOff) {
    const StopCurve curve{{{0.5, 0.6}, {2.0, 0.1}}};
    EXPECT_EQ(curve.times(2.0, 1.0).at(0.5), 1.0);
    EXPECT_NEAR(curve.times(2.0, 1.0).at(2.0), 0.2, 1e-12);
}

}  // namespace
}  // namespace rockfall::stopping_test
