#include "coupling/run/in_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace coupling::in_order_test {
namespace {

/// The pieces as they were handed on, by as many workers as wanted; every seventh piece takes its time.
std::vector<std::size_t> handed_on(std::size_t pieces, std::size_t threads) {
    std::vector<std::size_t> workers(threads);  // each keeps the piece that it has under way
    std::vector<std::size_t> order;
    const std::size_t done = in_order(
        pieces, workers,
        [](std::size_t& mine, std::size_t piece) {
            mine = piece;
            if (piece % 7 == 0) {
                std::this_thread::yield();
            }
        },
        [&](std::size_t& mine, std::size_t piece) {
            EXPECT_EQ(mine, piece);
            order.push_back(piece);
        });
    EXPECT_EQ(done, pieces);
    return order;
}

TEST(InOrder, HandsAllPiecesOnInTheirOrder) {
    for (const std::size_t pieces : {0U, 1U, 2U, 5000U}) {
        std::vector<std::size_t> expected(pieces);
        std::iota(expected.begin(), expected.end(), 0U);
        for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
            EXPECT_EQ(handed_on(pieces, threads), expected) << pieces << " by " << threads;
        }
    }
}

TEST(InOrder, PassesTheFirstExceptionOnAndWaitsForNobody) {
    const auto nothing = [](int, std::size_t) {};
    const auto at_forty = [](int, std::size_t piece) {
        if (piece == 40) {
            throw std::runtime_error{"forty"};
        }
    };
    std::vector<int> workers(4);
    EXPECT_THROW((void)in_order(1000, workers, at_forty, nothing), std::runtime_error);
    EXPECT_THROW((void)in_order(1000, workers, nothing, at_forty), std::runtime_error);
}

TEST(InOrder, EndsSoonAfterAnInterruption) {
    const InterruptGuard guard;
    std::vector<int> workers(3);
    std::atomic<std::size_t> begun = 0;
    std::size_t handed_on = 0;
    const std::size_t done = in_order(
        1'000'000, workers,
        [&](int, std::size_t piece) {
            ++begun;
            if (piece == 100) {
                std::raise(SIGINT);
            }
        },
        [&](int, std::size_t) { ++handed_on; });
    // Pieces that others took before they saw the flag are finished: at most one each.
    EXPECT_GE(done, 101U);
    EXPECT_LE(done, 100 + workers.size());
    EXPECT_EQ(handed_on, done);
    EXPECT_EQ(begun, done);
}

TEST(InterruptGuard, KeepsTheRequestForTheOuterGuards) {
    const InterruptGuard outer;
    {
        const InterruptGuard inner;
        std::raise(SIGTERM);
    }
    EXPECT_TRUE(InterruptGuard::requested());
    const InterruptGuard later;
    EXPECT_TRUE(InterruptGuard::requested());
}

TEST(InterruptGuard, BeginsAnew) {
    {
        const InterruptGuard guard;
        std::raise(SIGTERM);
    }
    const InterruptGuard guard;
    EXPECT_FALSE(InterruptGuard::requested());
}

}  // namespace
}  // namespace coupling::in_order_test
