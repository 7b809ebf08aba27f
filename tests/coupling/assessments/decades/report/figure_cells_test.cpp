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

TEST(ProtectionCell, ShowsNoIntervalThatSaysNothing) {
    for (const double other : {100.0, 50.0, 0.0, -20.0, -100.0, -300.0}) {
        const Band band = band_of({100.0, other}, {.high = 100.0});
        const bool far = band.has_interval() && band.low < -100.0 && band.high >= 0.0;
        EXPECT_EQ(protection_cell(band) == "–", far) << other << ": " << band.low << " to " << band.high;
    }
    EXPECT_EQ(protection_cell(std::optional<OverReplicates>{}), "–");
}

TEST(ThreeOf, NamesEachYearOnce) {
    EXPECT_EQ(three_of({0, 5, 10, 15}), (std::vector<std::int32_t>{0, 10, 15}));
    EXPECT_EQ(three_of({0, 1}), (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(three_of({7}), (std::vector<std::int32_t>{7}));
}

}  // namespace
}  // namespace coupling::decades::figure_cells_test
