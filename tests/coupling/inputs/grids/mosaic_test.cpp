#include "coupling/inputs/grids/mosaic.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "config/errors/input_error.hpp"

namespace coupling::grids::mosaic_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

config::GridFrame frame(int columns, int rows, double x_m, double y_m, double cell_m = 5.0) {
    return {.columns = columns,
            .rows = rows,
            .x_west_m = x_m,
            .y_south_m = y_m,
            .cell_width_m = cell_m,
            .cell_height_m = cell_m};
}

/// Heights that differ from cell to cell; some of them unknown.
config::Raster<double> some_grid(const config::GridFrame& of) {
    config::Raster<double> grid{of};
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        grid.values[i] = i % 13 == 5 ? none : 400.0 + std::sin(static_cast<double>(i)) * 30.0;
    }
    return grid;
}

bool is_same(const config::Raster<double>& a, const config::Raster<double>& b) {
    return a.frame == b.frame &&
           std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                      [](double x, double y) { return (std::isnan(x) && std::isnan(y)) || x == y; });
}

/// Lays tiles that were cut out of a grid.
config::Raster<double> laid(const config::Raster<double>& whole, const std::vector<CellWindow>& windows) {
    std::vector<TilePlace> places;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        places.push_back({"tile " + std::to_string(i), frame_of(whole.frame, windows[i]), i, {}});
    }
    const MosaicPlan plan = plan_mosaic(places);
    Mosaic mosaic{plan, "tiles"};
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        mosaic.lay(i, cut_out(whole, windows[plan.tiles[i].number]));
    }
    EXPECT_EQ(mosaic.overlap().different, 0U);
    return std::move(mosaic).taken();
}

std::string refusal(const std::vector<TilePlace>& tiles) {
    try {
        plan_mosaic(tiles);
    } catch (const config::InputError& error) {
        return error.what();
    }
    return "";
}

// Whatever the cuts, the overlaps and the order of the tiles.
TEST(Mosaic, OfPiecesIsTheWholeGrid) {
    EXPECT_TRUE(rc::check([] {
        const int columns = *rc::gen::inRange(4, 20);
        const int rows = *rc::gen::inRange(4, 20);
        const config::Raster<double> whole = some_grid(frame(columns, rows, 176'000.5, 376'000.25));
        const int cut = *rc::gen::inRange(1, columns);
        const int cut_row = *rc::gen::inRange(1, rows);
        const int over = *rc::gen::inRange(0, 3);
        const int east = std::min(columns, cut + over);
        const int south = std::min(rows, cut_row + over);
        std::vector<CellWindow> windows{{{0, 0}, east, south},
                                        {{cut, 0}, columns - cut, south},
                                        {{0, cut_row}, east, rows - cut_row},
                                        {{cut, cut_row}, columns - cut, rows - cut_row}};
        const std::size_t turned = *rc::gen::inRange<std::size_t>(0, 4);
        std::rotate(windows.begin(), windows.begin() + static_cast<std::ptrdiff_t>(turned), windows.end());
        std::vector<CellWindow> different;  // a tile over everything makes others of the same place
        for (const CellWindow& window : windows) {
            if (std::find(different.begin(), different.end(), window) == different.end()) {
                different.push_back(window);
            }
        }
        RC_ASSERT(is_same(laid(whole, different), whole));
    }));
}

TEST(Mosaic, TakesTheNorthernThenTheWesternTileWhereTheyOverlap) {
    const config::GridFrame north = frame(2, 2, 0.0, 10.0);
    const config::GridFrame south = frame(2, 2, 0.0, 5.0);
    const config::GridFrame east = frame(2, 2, 5.0, 10.0);
    const MosaicPlan plan =
        plan_mosaic({{"a_south", south, 0, {}}, {"b_east", east, 1, {}}, {"c_north", north, 2, {}}});
    ASSERT_EQ(plan.tiles.size(), 3U);
    EXPECT_EQ(plan.tiles[0].file, "c_north");
    EXPECT_EQ(plan.tiles[1].file, "b_east");
    EXPECT_EQ(plan.tiles[2].file, "a_south");
    EXPECT_EQ(plan.frame, frame(3, 3, 0.0, 5.0));
    Mosaic mosaic{plan, "tiles"};
    mosaic.lay(0, config::Raster<double>{north, 1.0});
    config::Raster<double> known_in_part{east, 3.0};
    known_in_part.at({0, 0}) = none;
    mosaic.lay(1, known_in_part);
    mosaic.lay(2, config::Raster<double>{south, 2.0});
    EXPECT_EQ(mosaic.overlap().cells, 3U);  // one of the east, two of the south; one more is unknown
    EXPECT_EQ(mosaic.overlap().different, 3U);
    EXPECT_DOUBLE_EQ(mosaic.overlap().largest, 2.0);
    EXPECT_EQ(mosaic.overlap().file, "b_east");
    const config::Raster<double> grid = std::move(mosaic).taken();
    EXPECT_EQ(grid.at({1, 1}), 1.0);
    EXPECT_EQ(grid.at({2, 0}), 3.0);
    EXPECT_EQ(grid.at({0, 2}), 2.0);
    EXPECT_TRUE(std::isnan(grid.at({2, 2})));
}

TEST(Mosaic, FillsWhatOneTileDoesNotKnowFromAnother) {
    const config::GridFrame of = frame(2, 2, 0.0, 0.0);
    const config::GridFrame beside = frame(2, 2, 5.0, 0.0);
    const MosaicPlan plan = plan_mosaic({{"a", of, 0, {}}, {"b", beside, 1, {}}});
    Mosaic mosaic{plan, "tiles"};
    config::Raster<double> first{of, 7.0};
    first.at({1, 0}) = none;
    mosaic.lay(0, first);
    mosaic.lay(1, config::Raster<double>{beside, 9.0});
    EXPECT_EQ(std::move(mosaic).taken().at({1, 0}), 9.0);
}

TEST(MosaicPlan, RefusesTilesThatDoNotFit) {
    const TilePlace first{"a.tif", frame(10, 10, 0.0, 0.0), 0, {}};
    EXPECT_EQ(refusal({first, {"b.tif", frame(25, 25, 50.0, 0.0, 2.0), 1, {}}}),
              "b.tif: found cells of 2 m, expected cells of 5 m, as a.tif has them; list the tiles of one "
              "size of cells "
              "alone, in a text file with a name in each line");
    EXPECT_NE(
        refusal({first, {"b.tif", frame(10, 10, 52.5, 0.0), 1, {}}}).find("shifted by 0.5 of their size"),
        std::string::npos);
    EXPECT_NE(
        refusal({first, {"b.tif", frame(10, 10, 0.0, 0.0), 1, {}}}).find("found the very place of a.tif"),
        std::string::npos);
    EXPECT_NE(refusal({first, {"b.tif", frame(10, 10, 9e9, 0.0), 1, {}}}).find("places near each other"),
              std::string::npos);
    // Another tile between the two in the order of the files.
    EXPECT_NE(refusal({first,
                       {"b.tif", frame(20, 10, 0.0, 0.0), 1, {}},
                       {"c.tif", frame(10, 10, 0.0, 0.0000001), 2, {}}})
                  .find("found the very place of"),
              std::string::npos);
    EXPECT_EQ(refusal({first, {"b.tif", frame(10, 10, 50.0, 0.0), 1, {}}}), "");
    // Corners of decimal numbers lie beside the lattice by their last bits.
    EXPECT_EQ(refusal({first, {"b.tif", frame(10, 10, 50.0000001, 0.0), 1, {}}}), "");
}

TEST(MosaicGaps, AreBetweenTilesOrBesideThem) {
    const config::GridFrame one = frame(10, 10, 0.0, 0.0);
    // A tile is missing in the middle of three.
    MosaicGaps gaps = gaps_of(plan_mosaic({{"a", one, 0, {}}, {"c", frame(10, 10, 100.0, 0.0), 1, {}}}));
    EXPECT_EQ(gaps.between, 100U);
    EXPECT_EQ(gaps.first_between, 10U);
    EXPECT_EQ(gaps.beside, 0U);
    // Three of four tiles make an angle.
    gaps = gaps_of(plan_mosaic(
        {{"a", one, 0, {}}, {"b", frame(10, 10, 50.0, 0.0), 1, {}}, {"c", frame(10, 10, 0.0, 50.0), 2, {}}}));
    EXPECT_EQ(gaps.between, 0U);
    EXPECT_EQ(gaps.beside, 100U);
    gaps = gaps_of(plan_mosaic({{"a", one, 0, {}}, {"b", frame(10, 10, 50.0, 0.0), 1, {}}}));
    EXPECT_EQ(gaps.between + gaps.beside, 0U);
}

TEST(CellsIn, AreThoseWhoseCentresLieInTheWindow) {
    const config::GridFrame of = frame(10, 10, 1000.0, 2000.0);
    EXPECT_EQ(cells_in(of, {1000.0, 2000.0, 1050.0, 2050.0}, "f"), (CellWindow{{0, 0}, 10, 10}));
    EXPECT_EQ(cells_in(of, {-1e9, -1e9, 1e9, 1e9}, "f"), (CellWindow{{0, 0}, 10, 10}));
    EXPECT_EQ(cells_in(of, {1007.5, 2012.4, 1027.5, 2050.0}, "f"), (CellWindow{{1, 0}, 5, 8}));
    EXPECT_THROW(cells_in(of, {1007.5, 2012.4, 1012.5, 2050.0}, "f"), config::InputError);
    EXPECT_THROW(cells_in(of, {3000.0, 2000.0, 3100.0, 2050.0}, "f"), config::InputError);
}

TEST(CellsIn, OfAMosaicAreThoseOfTheWholeGrid) {
    const config::Raster<double> whole = some_grid(frame(12, 9, 500.0, 700.0));
    const CellWindow wanted{{3, 2}, 6, 5};
    std::vector<TilePlace> places{{"a", frame_of(whole.frame, {{0, 0}, 5, 9}), 0, {}},
                                  {"b", frame_of(whole.frame, {{5, 0}, 2, 9}), 1, {}},
                                  {"c", frame_of(whole.frame, {{7, 0}, 3, 2}), 2, {}},
                                  {"d", frame_of(whole.frame, {{7, 2}, 5, 7}), 3, {}}};
    const MosaicPlan plan = plan_of(plan_mosaic(places), wanted);
    EXPECT_EQ(plan.tiles.size(), 3U);  // c lies north of it
    EXPECT_EQ(plan.frame, frame_of(whole.frame, wanted));
}

}  // namespace
}  // namespace coupling::grids::mosaic_test
