#include "config/random/distributions.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <limits>

#include "config/random/stream.hpp"

namespace config::distributions_test {
namespace {

constexpr double tolerance = 1e-13;  // that of config::log2_of

void expect_relatively_near(double value, double expected, double relative, double u) {
    EXPECT_NEAR(value, expected, relative * std::abs(expected)) << "at u = " << u;
}

TEST(NormalQuantile, MatchesBoostOverTheWholeRange) {
    const boost::math::normal standard;
    for (int i = 1; i < 10'000; ++i) {
        const double u = i / 10'000.0;
        expect_relatively_near(normal_quantile(u), boost::math::quantile(standard, u), tolerance, u);
    }
    for (double u = 1e-3; u > 1e-300; u *= 0.1) {
        expect_relatively_near(normal_quantile(u), boost::math::quantile(standard, u), tolerance, u);
    }
}

TEST(NormalQuantile, IsOddAboutTheMiddle) {
    EXPECT_EQ(normal_quantile(0.5), 0.0);
    for (const double u : {0x1p-32, 0x1p-10, 0.0625, 0.25}) {
        EXPECT_EQ(normal_quantile(u), -normal_quantile(1.0 - u)) << u;
    }
}

TEST(NormalQuantile, IsInfiniteAtTheEnds) {
    EXPECT_EQ(normal_quantile(0.0), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(normal_quantile(1.0), std::numeric_limits<double>::infinity());
}

TEST(Normal, IsFiniteForEveryUniform) {
    EXPECT_NEAR(normal(0.0, 0.0, 1.0), -6.34, 0.01);
    EXPECT_NEAR(normal(1.0 - 0x1p-32, 0.0, 1.0), 6.23, 0.01);
}

TEST(Normal, HasItsMeanAndVariance) {
    constexpr int draws = 200'000;
    RandomStream stream{{.seed = 5}, Purpose::test};
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (int i = 0; i < draws; ++i) {
        const double value = normal(stream.uniform(), 0.0, 1.0);
        sum += value;
        sum_of_squares += value * value;
    }
    EXPECT_NEAR(sum / draws, 0.0, 4.0 / std::sqrt(draws));
    EXPECT_NEAR(sum_of_squares / draws, 1.0, 4.0 * std::sqrt(2.0 / draws));  // variance of a chi-square is 2
}

TEST(Quantiles, MatchThoseOfBoost) {
    const boost::math::lognormal lognormal_law{std::log(0.8), 0.4};
    const boost::math::weibull weibull_law{1.7, 12.0};
    const boost::math::gamma_distribution<> gamma_law{2.5, 3.0};
    for (int i = 1; i < 1000; ++i) {
        const double u = i / 1000.0;
        expect_relatively_near(lognormal(u, 0.8, 0.4), boost::math::quantile(lognormal_law, u), 1e-14, u);
        expect_relatively_near(weibull(u, 1.7, 12.0), boost::math::quantile(weibull_law, u), 1e-13, u);
        expect_relatively_near(gamma(u, 2.5, 3.0), boost::math::quantile(gamma_law, u), 1e-13, u);
        expect_relatively_near(exponential(u, 4.0), weibull(u, 1.0, 4.0), tolerance, u);
    }
}

TEST(Quantiles, BeginAtZero) {
    EXPECT_EQ(exponential(0.0, 4.0), 0.0);
    EXPECT_EQ(weibull(0.0, 1.7, 12.0), 0.0);
    EXPECT_EQ(gamma(0.0, 2.5, 3.0), 0.0);
    EXPECT_GT(lognormal(0.0, 0.8, 0.4), 0.0);
}

TEST(TruncatedNormal, StaysWithinItsCut) {
    for (const double cut : {0.01, 1.0, 2.0, 5.0, 40.0}) {
        const TruncatedNormal law{cut};
        EXPECT_NEAR(law(0.0), -cut, 1e-12 * cut);
        EXPECT_GE(law(0.0), -cut);
        EXPECT_LE(law(1.0 - 0x1p-53), cut);
        EXPECT_NEAR(law(0.5), 0.0, 1e-15);
    }
}

TEST(TruncatedNormal, FollowsTheNormalLawBetweenItsCuts) {
    const boost::math::normal standard;
    const TruncatedNormal law{2.0};
    const double inside = boost::math::cdf(standard, 2.0) - boost::math::cdf(standard, -2.0);
    for (int i = 1; i < 1000; ++i) {
        const double u = i / 1000.0;
        const double share = (boost::math::cdf(standard, law(u)) - boost::math::cdf(standard, -2.0)) / inside;
        EXPECT_NEAR(share, u, 1e-14);
    }
}

TEST(DiscreteDistribution, DrawsEachIndexByItsWeight) {
    const std::vector<double> weights{1.0, 0.0, 3.0, 6.0};
    const DiscreteDistribution law{weights};
    constexpr int draws = 100'000;
    std::vector<int> hits(weights.size());
    RandomStream stream{{.seed = 6}, Purpose::test};
    for (int i = 0; i < draws; ++i) {
        ++hits[law(stream.uniform())];
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double p = weights[i] / 10.0;
        EXPECT_NEAR(static_cast<double>(hits[i]) / draws, p, 4.0 * std::sqrt(p * (1.0 - p) / draws)) << i;
    }
}

TEST(DiscreteDistribution, NeverDrawsAWeightOfZero) {
    const DiscreteDistribution law{std::vector<double>{0.0, 0.1, 0.2, 0.0}};
    EXPECT_EQ(law(0.0), 1U);
    EXPECT_EQ(law(1.0 - 0x1p-53), 2U);
    EXPECT_EQ(law(1.0), 2U);
    EXPECT_EQ(law.size(), 4U);
}

}  // namespace
}  // namespace config::distributions_test
