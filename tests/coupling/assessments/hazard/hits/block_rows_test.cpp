#include "coupling/assessments/hazard/hits/block_rows.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <vector>

namespace coupling::hazard::hits::block_rows_test {
namespace {

rockfall::ReleaseSource source_of(std::uint64_t first, std::uint32_t rocks,
                                  const std::shared_ptr<const rockfall::StartLaw>& own) {
    rockfall::ReleaseSource source;
    source.first_rock = first;
    source.rocks = rocks;
    source.own_start = own;
    return source;
}

TEST(BlockRows, JoinTheSourcesOfARow) {
    rockfall::StartLaw small;
    small.diameter = rockfall::DiameterLaw::fixed(0.3);
    rockfall::StartLaw large;
    large.diameter = rockfall::DiameterLaw::fixed(1.2);
    const auto a = std::make_shared<const rockfall::StartLaw>(small);
    const auto b = std::make_shared<const rockfall::StartLaw>(large);
    const std::vector<rockfall::ReleaseSource> sources{source_of(0, 10, a), source_of(10, 0, b),
                                                       source_of(10, 5, b), source_of(15, 7, a)};
    const BlockRows blocks{sources, {}};
    ASSERT_EQ(blocks.rows().size(), 2U);
    EXPECT_EQ(blocks.rows()[0].rocks, 17U);
    EXPECT_EQ(blocks.rows()[1].rocks, 5U);
    EXPECT_DOUBLE_EQ(blocks.rows()[0].diameter_m, 0.3);
    EXPECT_DOUBLE_EQ(blocks.rows()[1].diameter_m, 1.2);
    EXPECT_EQ(blocks.row_of(0), 0U);
    EXPECT_EQ(blocks.row_of(9), 0U);
    EXPECT_EQ(blocks.row_of(10), 1U);
    EXPECT_EQ(blocks.row_of(14), 1U);
    EXPECT_EQ(blocks.row_of(21), 0U);
    EXPECT_THROW(static_cast<void>(blocks.row_of(22)), std::out_of_range);
    EXPECT_EQ(blocks.fewest_rocks(), 5.0);
}

}  // namespace
}  // namespace coupling::hazard::hits::block_rows_test
