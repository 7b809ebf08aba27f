#include "coupling/inputs/scenario/map_size.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::map_size_test {
namespace {

TEST(MapSize, TakesCellsOfADecimetreOnASmallSlope) {
    const SampleProject project;
    const Opened opened = open(project, {"output.cell_size_m=0.1"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->map_frame.size(), 1'200'000U);
}

TEST(MapSize, RefusesAnExtentThatNoSlopeHas) {
    EXPECT_NO_THROW(check_extent(99e3, 20e3, "points.xyz"));
    EXPECT_THROW(check_extent(120e3, 20e3, "points.xyz"), config::InputError);
}

TEST(MapSize, KnowsHowMuchMemoryThereIs) {
    EXPECT_GT(physical_memory_bytes(), 0U);
}

}  // namespace
}  // namespace coupling::map_size_test
