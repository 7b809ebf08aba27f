#include "coupling/assessments/decades/report/figure_cells.hpp"

#include <gtest/gtest.h>

namespace coupling::decades::figure_cells_test {
namespace {

TEST(BandCell, HasAnIntervalOnlyWhereTheMeanHasOne) {
    Band band = band_of({10.0, 12.0});
    EXPECT_TRUE(band_cell(band, 1).starts_with("11.0 <small>(")) << band_cell(band, 1);
    band = band_of({10.0});
    EXPECT_EQ(band_cell(band, 1), "10.0");
    EXPECT_EQ(band_cell(std::optional<OverReplicates>{}, 1), "–");
}

TEST(ThreeOf, NamesEachYearOnce) {
    EXPECT_EQ(three_of({0, 5, 10, 15}), (std::vector<std::int32_t>{0, 10, 15}));
    EXPECT_EQ(three_of({0, 1}), (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(three_of({7}), (std::vector<std::int32_t>{7}));
}

}  // namespace
}  // namespace coupling::decades::figure_cells_test
