#include "coupling/inputs/plausible/odd_targets.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/coupling/inputs/opened.hpp"
#include "tests/coupling/inputs/plausible/turned.hpp"

namespace coupling::plausible::odd_targets_test {
namespace {

TEST(CrossesItself, IsTrueOfABowTieHoweverItIsTurned) {
    const std::vector<Eigen::Vector2d> bow{{0, 0}, {10, 10}, {10, 0}, {0, 10}, {0, 0}};
    const std::vector<Eigen::Vector2d> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}};
    const std::vector<Eigen::Vector2d> bay{{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 2},
                                           {4, 2}, {4, 10}, {0, 10},  {0, 0}};
    for (const Turn& turn : all_turns()) {
        const auto turned = [&](std::vector<Eigen::Vector2d> ring) {
            for (Eigen::Vector2d& corner : ring) {
                corner = turn.of(corner);
            }
            return ring;
        };
        EXPECT_TRUE(crosses_itself(turned(bow)));
        EXPECT_FALSE(crosses_itself(turned(square)));
        EXPECT_FALSE(crosses_itself(turned(bay)));
    }
}

}  // namespace
}  // namespace coupling::plausible::odd_targets_test
