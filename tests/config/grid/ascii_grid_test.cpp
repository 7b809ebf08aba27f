#include "config/grid/ascii_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "config/errors/input_error.hpp"

namespace config::ascii_grid_test {
namespace {

const std::string header =
    "ncols 3\n"
    "nrows 2\n"
    "xllcorner 100\n"
    "yllcorner 200.5\n"
    "cellsize 10\n"
    "NODATA_value -9999\n";
const std::string two_rows = "1 2 3\n4 5 6\n";
const GridFrame frame{.columns = 3,
                      .rows = 2,
                      .x_west_m = 100.0,
                      .y_south_m = 200.5,
                      .cell_width_m = 10.0,
                      .cell_height_m = 10.0};

Raster<double> grid_of(const std::string& text) {
    return read_ascii_grid(text, "dem.asc");
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    return text.replace(text.find(what), what.size(), with);
}

TEST(ReadAsciiGrid, PutsTheFirstRowInTheNorth) {
    const Raster<double> grid = grid_of(header + two_rows);
    EXPECT_EQ(grid.frame, frame);
    EXPECT_EQ(grid.values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(grid.at(grid.frame.cell_at(105.0, 219.0)), 1.0);
    EXPECT_EQ(grid.at(grid.frame.cell_at(125.0, 201.0)), 6.0);
}

TEST(ReadAsciiGrid, ReadsTheSameFromAnyLayout) {
    const std::vector<std::string> texts{
        "\xEF\xBB\xBFncols 3\r\nnrows 2\r\nxllcorner 100\r\nyllcorner 200.5\r\ncellsize 10\r\n1 2 3\r\n4 5 "
        "6\r\n",
        "NCOLS\t3\nNROWS\t2\nXLLCORNER\t100\nYLLCORNER\t200.5\nCELLSIZE\t10\nnodata_value\t-"
        "1\n1\t2\t3\n4\t5\t6",
        "cellsize 10\nyllcorner 200.5\nxllcorner 100\nnrows 2\nncols 3\n1 2\n3 4\n5\n\n6\n",
        "ncols 3\nnrows 2\nxllcenter 105\nyllcenter 205.5\ncellsize 10\n 1 2 3 4 5 6 ",
        "ncols 3\nnrows 2\nxllcentre 105\nyllcorner 200.5\ndx 10\ndy 10\n+1 2.0 3e0 40e-1 0.5e1 6.\n",
    };
    for (const std::string& text : texts) {
        const Raster<double> grid = grid_of(text);
        EXPECT_EQ(grid.frame, frame) << text;
        EXPECT_EQ(grid.values, (std::vector<double>{1, 2, 3, 4, 5, 6})) << text;
    }
}

TEST(ReadAsciiGrid, TakesCellsThatAreNotSquare) {
    const Raster<double> grid = grid_of("ncols 2 nrows 1 xllcenter 0 yllcenter 0 dx 2 dy 5\n1 2\n");
    EXPECT_EQ(grid.frame.cell_width_m, 2.0);
    EXPECT_EQ(grid.frame.cell_height_m, 5.0);
    EXPECT_EQ(grid.frame.x_west_m, -1.0);
    EXPECT_EQ(grid.frame.y_south_m, -2.5);
}

TEST(ReadAsciiGrid, ComparesNodataAsANumber) {
    const Raster<double> grid = grid_of(header + "-9999.0 2 -9999\n-9.999e3 5 -9998\n");
    for (const std::size_t index : {0U, 2U, 3U}) {
        EXPECT_TRUE(std::isnan(grid.values[index])) << index;
    }
    EXPECT_EQ(grid.values[5], -9998.0);
}

TEST(ReadAsciiGrid, TakesTheConventionalNodataWhereTheHeaderHasNone) {
    const Raster<double> grid = grid_of(replaced(header, "NODATA_value -9999\n", "") + "-9999 2 3\n4 5 6\n");
    EXPECT_TRUE(std::isnan(grid.values[0]));
}

TEST(ReadAsciiGrid, KeepsTheConventionalNumberWhereAnotherOneIsNodata) {
    const Raster<double> grid = grid_of(replaced(header, "-9999", "0") + "-9999 0 3\n4 5 6\n");
    EXPECT_EQ(grid.values[0], -9999.0);
    EXPECT_TRUE(std::isnan(grid.values[1]));
}

TEST(ReadAsciiGrid, TakesNanOnlyWhereTheHeaderNamesIt) {
    const Raster<double> grid = grid_of(replaced(header, "-9999", "nan") + "nan 2 NaN\n4 5 -9999\n");
    EXPECT_TRUE(std::isnan(grid.values[0]));
    EXPECT_TRUE(std::isnan(grid.values[2]));
    EXPECT_EQ(grid.values[5], -9999.0);
}

TEST(ReadAsciiGrid, TakesWordsForUnknownCells) {
    for (const char* word : {"nan", "NaN", "-nan", "-nan(ind)", "null", "NULL", "*", "NA", "N/A", "#N/A",
                             "1.#QNAN", "-1.#IND", "nodata", "-"}) {
        const AsciiGrid grid =
            read_ascii_grid_with_words(header + "1 " + word + " 3\n4 " + word + " -9999\n", "dem.asc");
        EXPECT_TRUE(std::isnan(grid.raster.values[1])) << word;
        EXPECT_TRUE(std::isnan(grid.raster.values[4])) << word;
        EXPECT_EQ(grid.raster.values[3], 4.0) << word;
        EXPECT_EQ(grid.words.cells, 2U) << word;
        EXPECT_EQ(grid.words.first, word);
        if (std::string{word} != "nodata") {  // as the first cell too, where the header ends
            EXPECT_TRUE(std::isnan(grid_of(header + word + " 2 3\n4 5 6\n").values[0])) << word;
        }
        // Where the header says so, nothing is to be noted.
        EXPECT_EQ(
            read_ascii_grid_with_words(replaced(header, "-9999", word) + "1 " + word + " 3\n4 5 6\n", "d")
                .words.cells,
            0U)
            << word;
    }
}

/// A number as grids hold it: any double that is finite and not the writer's NODATA.
rc::Gen<double> cell_value() {
    return rc::gen::oneOf(
        rc::gen::suchThat(rc::gen::arbitrary<double>(),
                          [](double v) { return std::isfinite(v) && v != -9999.0; }),
        rc::gen::map(rc::gen::inRange(-99'990'000, 40'000'000), [](int v) { return 1e-3 * v; }),
        rc::gen::just(std::numeric_limits<double>::quiet_NaN()));
}

RC_GTEST_PROP(WriteAsciiGrid, ReadsBackBitForBit, ()) {
    GridFrame random_frame;
    random_frame.columns = *rc::gen::inRange(1, 9);
    random_frame.rows = *rc::gen::inRange(1, 9);
    random_frame.x_west_m = *rc::gen::inRange(-900'000, 900'000) * 0.1;
    random_frame.y_south_m = *rc::gen::inRange(-900'000, 900'000) / 7.0;
    random_frame.cell_width_m = *rc::gen::inRange(1, 1000) / 3.0;
    random_frame.cell_height_m = *rc::gen::arbitrary<bool>() ? random_frame.cell_width_m : 5.0;
    Raster<double> raster{random_frame};
    for (double& value : raster.values) {
        value = *cell_value();
    }

    std::ostringstream out;
    write_ascii_grid(out, raster);
    const Raster<double> again = grid_of(out.str());

    RC_ASSERT(again.frame == raster.frame);
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        RC_ASSERT(again.values[i] == raster.values[i] ||
                  (std::isnan(again.values[i]) && std::isnan(raster.values[i])));
    }
}

TEST(WriteAsciiGrid, WritesFloatsAsShortAsTheyCanBe) {
    Raster<float> raster{frame, 0.1F};
    raster.values[1] = std::numeric_limits<float>::quiet_NaN();
    std::ostringstream out;
    write_ascii_grid(out, raster);
    EXPECT_EQ(out.str(), header + "0.1 -9999 0.1\n0.1 0.1 0.1\n");
}

TEST(MostGridBytes, ComeFromTheCountsOfTheHeader) {
    constexpr std::uint64_t for_header = 1U << 20U;
    EXPECT_EQ(most_grid_bytes("ncols 3\nnrows 2\nxllcorner 0\n"), 6U * 64U + for_header);
    EXPECT_EQ(most_grid_bytes("\xEF\xBB\xBFNROWS 2\r\ncellsize 5\r\nNcols 3\r\n1 2 3"),
              6U * 64U + for_header);
    EXPECT_GT(most_grid_bytes("ncols 2147483647 nrows 2147483647 ").value_or(0), std::uint64_t{1} << 62U);
    for (const char* text : {"", "ncols", "ncols 3", "x_m,y_m\n1,2\n", "ncols 3 nrows -2", "ncols 3 rows 2",
                             "ncols 1e300 nrows 2"}) {
        EXPECT_EQ(most_grid_bytes(text), std::nullopt) << text;
    }
}

TEST(ReadAsciiGrid, RefusesMoreCellsThanTerrainsMayHaveByTheHeaderAlone) {
    const auto refusal_of = [](int columns, int rows) {
        const std::string text = replaced(replaced(header, "ncols 3", "ncols " + std::to_string(columns)),
                                          "nrows 2", "nrows " + std::to_string(rows)) +
                                 two_rows;
        try {
            grid_of(text);
        } catch (const InputError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    const std::string limit = "expected a grid of 1 to 400 million cells";
    for (const auto& [columns, rows] :
         {std::pair{20'001, 20'000}, {65'536, 32'769}, {2'147'483'647, 2'147'483'647}}) {
        const std::string refusal = refusal_of(columns, rows);
        EXPECT_NE(refusal.find(std::to_string(columns) + " x " + std::to_string(rows) + " cells"),
                  std::string::npos)
            << refusal;
        EXPECT_NE(refusal.find(limit), std::string::npos) << refusal;
    }
    // As many as are allowed: only their values are missing.
    EXPECT_EQ(refusal_of(20'000, 20'000).find(limit), std::string::npos);
    EXPECT_NE(refusal_of(20'000, 20'000).find("400000000"), std::string::npos);
}

TEST(ReadAsciiGrid, EndsAfterTwentyWordsThatAreNoHeader) {
    std::string text;
    for (int word = 0; word < 300; ++word) {
        text += "word value\n";
    }
    try {
        read_ascii_grid(text, "dem.asc");
        ADD_FAILURE() << "taken";
    } catch (const InputError& error) {
        EXPECT_LE(error.problems().size(), 30U);
    }
}

// Simple readers of grids cannot take 5e+05, and people do not either.
RC_GTEST_PROP(WriteAsciiGrid, HasNoExponentInItsHeader, ()) {
    const int power = *rc::gen::inRange(0, 9);
    const double x_m = *rc::gen::inRange(-9, 10) * std::pow(10.0, power) + *rc::gen::inRange(0, 2) * 0.5;
    const double y_m = *rc::gen::inRange(-9, 10) * std::pow(10.0, power) + *rc::gen::inRange(0, 3) / 3.0;
    const Raster<double> raster{{2, 1, x_m, y_m, 100'000.0, std::pow(10.0, power - 5)}, 1.0};
    std::ostringstream out;
    write_ascii_grid(out, raster);
    const std::string text = out.str();
    const std::string head = text.substr(0, text.find("NODATA"));
    RC_ASSERT(head.find("e+") == std::string::npos && head.find("e-") == std::string::npos);
    RC_ASSERT(read_ascii_grid(text, "dem.asc").frame == raster.frame);
}

}  // namespace
}  // namespace config::ascii_grid_test
