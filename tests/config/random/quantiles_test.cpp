#include "config/random/quantiles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

namespace config {
namespace {

/// Chance of at most so many hits, by adding up the terms of the binomial distribution.
double added_up(int most, int trials, double probability) {
    double sum = 0.0;
    for (int hits = 0; hits <= most; ++hits) {
        const double ways =
            std::lgamma(trials + 1.0) - std::lgamma(hits + 1.0) - std::lgamma(trials - hits + 1.0);
        sum += std::exp(ways + hits * std::log(probability) + (trials - hits) * std::log1p(-probability));
    }
    return sum;
}

TEST(StudentsT, IsThatOfCauchyWithOneDegreeAndNormalWithMany) {
    for (const double share : {0.05, 0.3, 0.5, 0.9, 0.975, 0.999}) {
        const double cauchy = std::tan(std::numbers::pi * (share - 0.5));
        EXPECT_NEAR(students_t_quantile(1.0, share), cauchy, 1e-12 * (1.0 + std::abs(cauchy))) << share;
    }
    // Two degrees: t = (2 p - 1) / sqrt(2 p (1 - p)).
    EXPECT_NEAR(students_t_quantile(2.0, 0.95), 0.9 / std::sqrt(2.0 * 0.95 * 0.05), 1e-12);
    EXPECT_NEAR(students_t_quantile(1e9, 0.975), 1.959963984540054, 1e-6);
}

TEST(BinomialChance, IsTheSumOfItsTerms) {
    rc::check([] {
        const int trials = *rc::gen::inRange(1, 60);
        const int most = *rc::gen::inRange(0, trials + 1);
        const double probability = *rc::gen::inRange(1, 1000) / 1000.0;
        const double at_most = added_up(most, trials, probability);
        RC_ASSERT(std::abs(chance_of_at_most(most, trials, probability) - at_most) < 1e-11);
        RC_ASSERT(std::abs(chance_of_more_than(most, trials, probability) - (1.0 - at_most)) < 1e-11);
    });
    EXPECT_EQ(chance_of_at_most(-1.0, 5.0, 0.5), 0.0);
    EXPECT_EQ(chance_of_more_than(-1.0, 5.0, 0.5), 1.0);
    EXPECT_EQ(chance_of_at_most(5.0, 5.0, 0.5), 1.0);
}

TEST(BinomialCount, HasNoMoreThanTheShareBelow) {
    rc::check([] {
        const int trials = *rc::gen::inRange(1, 500);
        const double probability = *rc::gen::inRange(1, 1000) / 1000.0;
        const double share = *rc::gen::inRange(1, 1000) / 1000.0;
        const double count = binomial_count(trials, probability, share);
        RC_ASSERT(count >= 0.0 && count <= trials && count == std::floor(count));
        RC_ASSERT(chance_of_at_most(count - 1.0, trials, probability) <= share + 1e-12);
    });
}

TEST(ProbabilityBounds, AreWhereTheHitsSeenHaveTheChanceThatIsAsked) {
    rc::check([] {
        const int trials = *rc::gen::inRange(1, 200);
        const int hits = *rc::gen::inRange(0, trials + 1);
        const double chance = *rc::gen::inRange(1, 500) / 1000.0;
        const double least = least_probability(trials, hits, chance);
        const double greatest = greatest_probability(trials, hits, chance);
        if (hits == 0) {
            RC_ASSERT(least == 0.0);
        } else {
            RC_ASSERT(std::abs(chance_of_more_than(hits - 1.0, trials, least) - chance) < 1e-9);
        }
        if (hits == trials) {
            RC_ASSERT(greatest == 1.0);
        } else {
            RC_ASSERT(std::abs(chance_of_at_most(hits, trials, greatest) - chance) < 1e-9);
        }
    });
}

TEST(GammaQuantile, IsThatOfWaitingForTheFirstEvent) {
    for (const double share : {0.001, 0.1, 0.5, 0.9, 0.999}) {
        EXPECT_NEAR(gamma_quantile(1.0, share), -std::log1p(-share), 1e-12 * (1.0 - std::log1p(-share)));
    }
}

}  // namespace
}  // namespace config
