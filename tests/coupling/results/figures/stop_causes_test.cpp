#include "coupling/results/figures/stop_causes.hpp"

#include <gtest/gtest.h>

namespace coupling::stop_causes_test {
namespace {

TEST(SharesByCause, AddUpToAllRocksAndTakeTheReasonsOfTheGroundTogether) {
    SlopeFigures slope;
    slope.rocks = 1000;
    const auto stopped = [&](rockfall::StopReason reason, std::uint64_t rocks) {
        slope.by_reason[static_cast<std::size_t>(reason)] = share_of(rocks, slope.rocks);
    };
    stopped(rockfall::StopReason::at_rest, 100);
    stopped(rockfall::StopReason::caught, 150);
    stopped(rockfall::StopReason::tree, 370);
    stopped(rockfall::StopReason::net, 30);
    stopped(rockfall::StopReason::log, 50);
    stopped(rockfall::StopReason::left_terrain, 299);
    stopped(rockfall::StopReason::gave_up, 1);
    const auto shares = shares_by_cause(slope);
    const auto part = [&](StopCause cause) { return shares[static_cast<std::size_t>(cause)].part; };
    EXPECT_EQ(part(StopCause::tree), 370U);
    EXPECT_EQ(part(StopCause::net), 30U);
    EXPECT_EQ(part(StopCause::log), 50U);
    EXPECT_EQ(part(StopCause::ground), 250U);
    EXPECT_EQ(part(StopCause::left_terrain), 299U);
    EXPECT_EQ(part(StopCause::gave_up), 1U);
    double sum = 0.0;
    for (const Share& share : shares) {
        sum += share.value;
        EXPECT_LE(share.interval.low, share.value);
        EXPECT_GE(share.interval.high, share.value);
        EXPECT_EQ(share.whole, 1000U);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(StopCause, OfEveryReasonHasAName) {
    for (std::size_t reason = 0; reason < rockfall::stop_reasons; ++reason) {
        const auto stop = static_cast<rockfall::StopReason>(reason);
        const StopCause cause = cause_of(stop);
        EXPECT_EQ(rockfall::came_to_rest(stop), cause < StopCause::left_terrain) << name_of(cause);
    }
    EXPECT_STREQ(name_of(StopCause::ground), "ground");
}

}  // namespace
}  // namespace coupling::stop_causes_test
