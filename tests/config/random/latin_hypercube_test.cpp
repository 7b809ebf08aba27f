#include "config/random/latin_hypercube.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace config::latin_hypercube_test {
namespace {

constexpr std::array<std::uint64_t, 10> dimensions{3, 1, 4, 15, 9, 2, 6, 53, 58, 97};

TEST(LatinHypercube, HasOnePointInEachStretchOfEachDimension) {
    const auto cube = latin_hypercube({.seed = 7}, Purpose::test, dimensions, 64);
    ASSERT_EQ(cube.size(), 64U);
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
        std::set<int> stretches;
        for (const auto& point : cube) {
            ASSERT_GE(point[d], 0.0);
            ASSERT_LT(point[d], 1.0);
            stretches.insert(static_cast<int>(64.0 * point[d]));
        }
        EXPECT_EQ(stretches.size(), 64U);
    }
}

TEST(LatinHypercube, KeepsADimensionWhateverComesAfterIt) {
    const auto all = latin_hypercube({.seed = 7}, Purpose::test, dimensions, 32);
    const auto first = latin_hypercube({.seed = 7}, Purpose::test, std::span{dimensions}.first(4), 32);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t d = 0; d < 4; ++d) {
            EXPECT_EQ(all[i][d], first[i][d]);
        }
    }
    EXPECT_NE(all, latin_hypercube({.seed = 8}, Purpose::test, dimensions, 32));
}

TEST(LatinHypercube, HasDimensionsThatHardlyCorrelate) {
    // Ranks of random orders of 64 correlate by 1 / sqrt(63) = 0.126 (root mean square); the best of 32 by
    // less.
    double squares = 0.0;
    int pairs = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto cube = latin_hypercube({.seed = seed}, Purpose::test, dimensions, 64);
        for (std::size_t a = 0; a < dimensions.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                double sum = 0.0;
                for (const auto& point : cube) {
                    sum += (point[a] - 0.5) * (point[b] - 0.5);
                }
                const double correlation = 12.0 * sum / 64.0;
                squares += correlation * correlation;
                ++pairs;
            }
        }
    }
    EXPECT_LT(std::sqrt(squares / pairs), 0.10);
}

}  // namespace
}  // namespace config::latin_hypercube_test
