#include "rockfall/tally/bin_counts.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rockfall::bin_counts_test {
namespace {

std::vector<std::uint64_t> counted(const std::vector<std::uint8_t>& values, std::size_t bins) {
    std::vector<std::uint64_t> counts(bins, 0);
    for (const std::uint8_t value : values) {
        ++counts[value % bins];
    }
    return counts;
}

BinCounts of(const std::vector<std::uint8_t>& values, std::size_t bins) {
    BinCounts counts{bins};
    for (const std::uint8_t value : values) {
        counts.add(value % bins);
    }
    return counts;
}

RC_GTEST_PROP(BinCounts, CountAsAPlainListDoes, (const std::vector<std::uint8_t>& values)) {
    for (const std::size_t bins : {1U, 7U, 40U, 256U}) {
        RC_ASSERT(of(values, bins).all() == counted(values, bins));
    }
}

RC_GTEST_PROP(BinCounts, AddUpInAnyOrder,
              (const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& two)) {
    BinCounts sum = of(one, 100);
    sum.add(of(two, 100));
    BinCounts other = of(two, 100);
    other.add(of(one, 100));
    std::vector<std::uint8_t> both = one;
    both.insert(both.end(), two.begin(), two.end());
    RC_ASSERT(sum == other);
    RC_ASSERT(sum.all() == counted(both, 100));
    RC_ASSERT(sum.filled() == of(both, 100).filled());
}

TEST(BinCounts, TakeMemoryForWhatTheyHold) {
    BinCounts counts{3000};
    EXPECT_EQ(counts.bytes(), 0U);
    counts.add(17);
    counts.add(17, 4);
    EXPECT_LE(counts.bytes(), 64U);
    EXPECT_EQ(counts.filled(), (std::vector<BinCounts::Filled>{{17, 5}}));
    for (std::size_t bin = 0; bin < 3000; ++bin) {
        counts.add(bin);
    }
    EXPECT_LE(counts.bytes(), 3000 * sizeof(std::uint64_t));
    EXPECT_EQ(counts.all()[17], 6U);
}

TEST(BinCounts, HoldCountsBeyondThirtyTwoBits) {
    BinCounts counts{100};
    constexpr std::uint64_t many = 5'000'000'000;
    counts.add(3, many);
    counts.add(3, many);
    counts.add(4, 4'294'967'295);
    counts.add(4);
    EXPECT_EQ(counts.filled(), (std::vector<BinCounts::Filled>{{3, 2 * many}, {4, 4'294'967'296}}));
}

}  // namespace
}  // namespace rockfall::bin_counts_test
