#include "coupling/inputs/observed/distribution.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

namespace coupling::observed {
namespace {

double mean_distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (const double x : a) {
        for (const double y : b) {
            sum += std::abs(x - y);
        }
    }
    return sum / static_cast<double>(a.size() * b.size());
}

std::vector<double> whole_numbers(const std::vector<int>& from) {
    std::vector<double> values;
    for (const int value : from) {
        values.push_back(value % 50);  // so that equal values occur
    }
    return values;
}

TEST(Distribution, MeanDeviationAndQuantilesOfKnownValues) {
    const Distribution values{{4.0, 1.0, 3.0, 2.0}};
    EXPECT_DOUBLE_EQ(values.mean(), 2.5);
    EXPECT_DOUBLE_EQ(values.deviation(), std::sqrt(5.0 / 3.0));
    EXPECT_DOUBLE_EQ(values.quantile(0.0), 1.0);
    EXPECT_DOUBLE_EQ(values.quantile(0.5), 2.5);
    EXPECT_DOUBLE_EQ(values.quantile(0.9), 3.7);  // numpy.quantile
    EXPECT_DOUBLE_EQ(values.quantile(1.0), 4.0);
}

TEST(LargestDistance, OfKnownSamples) {
    EXPECT_DOUBLE_EQ(largest_distance(Distribution{{1.0, 2.0}}, Distribution{{1.0, 2.0}}), 0.0);
    EXPECT_DOUBLE_EQ(largest_distance(Distribution{{1.0, 2.0}}, Distribution{{3.0, 4.0}}), 1.0);
    // F steps at 1, 2, 3, 4, G at 2.5 and 10: at 4 F is 1 and G 0.5, before 2.5 F is 0.5 and G 0.
    EXPECT_DOUBLE_EQ(largest_distance(Distribution{{1.0, 2.0, 3.0, 4.0}}, Distribution{{2.5, 10.0}}), 0.5);
}

TEST(EnergyDistance, OfTwoPointsIsTwiceTheirDistance) {
    EXPECT_DOUBLE_EQ(energy_distance(Distribution{{1.0}}, Distribution{{4.0}}), 6.0);
}

RC_GTEST_PROP(EnergyDistance, IsThatOfItsDefinition, (const std::vector<int>& a, const std::vector<int>& b)) {
    RC_PRE(!a.empty() && !b.empty());
    const std::vector<double> x = whole_numbers(a);
    const std::vector<double> y = whole_numbers(b);
    const double expected = 2.0 * mean_distance(x, y) - mean_distance(x, x) - mean_distance(y, y);
    RC_ASSERT(std::abs(energy_distance(Distribution{x}, Distribution{y}) - expected) < 1e-9);
}

RC_GTEST_PROP(LargestDistance, IsThatOfItsDefinition,
              (const std::vector<int>& a, const std::vector<int>& b)) {
    RC_PRE(!a.empty() && !b.empty());
    const std::vector<double> x = whole_numbers(a);
    const std::vector<double> y = whole_numbers(b);
    const auto share_up_to = [](const std::vector<double>& values, double limit) {
        double count = 0.0;
        for (const double value : values) {
            count += value <= limit ? 1.0 : 0.0;
        }
        return count / static_cast<double>(values.size());
    };
    double largest = 0.0;
    for (int limit = -50; limit <= 50; ++limit) {
        largest = std::max(largest, std::abs(share_up_to(x, limit) - share_up_to(y, limit)));
    }
    RC_ASSERT(std::abs(largest_distance(Distribution{x}, Distribution{y}) - largest) < 1e-12);
}

}  // namespace
}  // namespace coupling::observed
