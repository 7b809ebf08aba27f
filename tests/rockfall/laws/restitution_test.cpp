#include "rockfall/laws/restitution.hpp"

#include <gtest/gtest.h>

namespace rockfall::restitution_test {
namespace {

TEST(WithNoise, NeverMakesAContactASourceOfEnergy) {
    EXPECT_EQ(with_noise({0.3, 0.97}, 0.05, 1.0).tangential, largest_restitution);
    EXPECT_EQ(with_noise({0.3, 0.02}, 0.05, -1.0).tangential, 0.0);
    EXPECT_EQ(with_noise({0.3, 0.75}, 0.05, 1.0).normal, 0.3);
}

}  // namespace
}  // namespace rockfall::restitution_test
