#include "forest/deadwood/decay_class.hpp"

#include <gtest/gtest.h>

namespace forest::decay_class_test {
namespace {

TEST(DecayClassOf, IsThatOfItsOwnDensity) {
    for (std::size_t i = 0; i < decay_class_count; ++i) {
        EXPECT_EQ(decay_class_of(density_of_decay_class[i]), static_cast<int>(i) + 1);
    }
    EXPECT_EQ(decay_class_of(0.1), 5);
}

TEST(DecayClassOf, NeverFallsAsDensityDoes) {
    int before = 1;
    for (double density = 1.0; density > 0.1; density -= 0.01) {
        const int now = decay_class_of(density);
        EXPECT_GE(now, before) << density;
        before = now;
    }
    EXPECT_EQ(before, 5);
}

}  // namespace
}  // namespace forest::decay_class_test
