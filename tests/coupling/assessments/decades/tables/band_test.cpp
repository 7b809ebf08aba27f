#include "coupling/assessments/decades/tables/band.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "config/random/stream.hpp"

namespace coupling::decades::band_test {
namespace {

TEST(BandOf, HasTheIntervalOfStudentsT) {
    // Standard error 20, t = 6.313752 with one degree of freedom.
    const Band band = band_of({200.0, 240.0});
    EXPECT_DOUBLE_EQ(band.mean, 220.0);
    EXPECT_NEAR(band.low, 220.0 - 6.313752 * 20.0, 1e-4);
    EXPECT_NEAR(band.high, 220.0 + 6.313752 * 20.0, 1e-4);
    EXPECT_EQ(band.least, 200.0);
    EXPECT_EQ(band.most, 240.0);
}

TEST(BandOf, KnowsNoIntervalOfOneReplicateOrOfEqualOnes) {
    EXPECT_FALSE(band_of({3.0}).has_interval());
    EXPECT_FALSE(band_of({100.0, 100.0, 100.0}).has_interval()) << "three equal values are not certainty";
}

TEST(BandOf, LeavesOutWhatTheFigureCannotBe) {
    const Band band = band_of({90.0, 99.0}, {0.0, 100.0});
    EXPECT_EQ(band.high, 100.0);
    EXPECT_GE(band.low, 0.0);
}

TEST(BandOf, HasPercentilesFromTenReplicatesOn) {
    std::vector<double> values;
    for (int i = 20; i >= 0; --i) {
        values.push_back(i);
    }
    EXPECT_DOUBLE_EQ(band_of(values).p05, 1.0);
    EXPECT_DOUBLE_EQ(band_of(values).p95, 19.0);
    values.resize(9);
    EXPECT_TRUE(std::isnan(band_of(values).p05)) << "of nine they are close to the extremes";
}

TEST(BandOf, HoldsTheTruthInNineOfTenRunsOfThreeReplicates) {
    constexpr int runs = 4000;
    for (const int replicates : {3, 5, 20}) {
        int holds = 0;
        for (int run = 0; run < runs; ++run) {
            std::vector<double> values;
            for (int i = 0; i < replicates; ++i) {
                config::RandomStream stream{
                    {1, static_cast<std::uint32_t>(run), 0, static_cast<std::uint64_t>(i)},
                    config::Purpose::test};
                // Irwin and Hall: a sum of twelve uniform numbers is close to normal, its mean is 6.
                double sum = 0.0;
                for (int k = 0; k < 12; ++k) {
                    sum += stream.uniform();
                }
                values.push_back(sum);
            }
            const Band band = band_of(values);
            holds += band.low <= 6.0 && 6.0 <= band.high ? 1 : 0;
        }
        const double four_sigma = 4.0 * std::sqrt(interval_share * (1.0 - interval_share) / runs);
        EXPECT_NEAR(static_cast<double>(holds) / runs, interval_share, four_sigma) << replicates;
    }
}

TEST(BandOf, HoldsTheMeanOfSkewedFiguresToo) {
    constexpr int runs = 4000;
    for (const double chance_of_any : {1.0, 0.3}) {  // exponential; 0 in seven of ten replicates
        for (const int replicates : {5, 10, 20}) {
            int holds = 0;
            int with_interval = 0;
            for (int run = 0; run < runs; ++run) {
                std::vector<double> values;
                for (int i = 0; i < replicates; ++i) {
                    config::RandomStream stream{
                        {2, static_cast<std::uint32_t>(run), 0, static_cast<std::uint64_t>(i)},
                        config::Purpose::test};
                    const bool any = stream.uniform() < chance_of_any;
                    values.push_back(any ? -std::log(1.0 - stream.uniform()) : 0.0);
                }
                const Band band = band_of(values, not_negative);
                with_interval += band.has_interval() ? 1 : 0;
                holds += band.low <= chance_of_any && chance_of_any <= band.high ? 1 : 0;
            }
            const double share = static_cast<double>(holds) / with_interval;
            EXPECT_GT(share, 0.86) << replicates << " of " << chance_of_any;
            EXPECT_LT(share, 0.97) << replicates << " of " << chance_of_any;
        }
    }
}

TEST(ReplicatesNeeded, LeaveZeroOutOfTheInterval) {
    // 2 of deviation 2: t(4, 0.975) 2 / sqrt(5) = 2.48 > 2 and t(6, 0.975) 2 / sqrt(7) = 1.85 < 2; with six
    // pairs 2.5706 * 2 / sqrt(6) = 2.10.
    EXPECT_EQ(replicates_needed(2.0, 2.0), 7U);
    EXPECT_EQ(replicates_needed(-2.0, 2.0), 7U);
    EXPECT_FALSE(replicates_needed(0.0, 1.0));
    EXPECT_FALSE(replicates_needed(1e-6, 1.0));
    EXPECT_FALSE(replicates_needed(1.0, std::nan("")));
}

}  // namespace
}  // namespace coupling::decades::band_test
