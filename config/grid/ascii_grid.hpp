#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "config/grid/raster.hpp"

namespace config {

/// Reads an ESRI ASCII grid from its text; NODATA cells become NaN. The first row is the northern one.
///
/// Takes xllcorner/yllcorner or xllcenter/yllcenter, keys in any case and order, cellsize or dx and dy, LF or
/// CRLF, tabs, rows broken over lines, a byte-order mark, a leading plus. NODATA is compared as a number;
/// without a NODATA line it is -9999, as ESRI defines the format. Words by which programs mark cells without
/// a value (`nan`, `null`, `NA`, `*`, `-1.#IND`: see `is_word_for_nodata`) are NODATA too, as cells and in
/// the header.
///
/// Throws one InputError (data) with line and column for all faults of the header (unknown, doubled or
/// missing keys, counts below 1, cells not above 0 or above 100 km, corners beyond 1e9 m), else for up to 20
/// values that are no numbers (`inf`, `1,5`) and for too few or too many of them, with how many were found
/// and expected.
Raster<double> read_ascii_grid(std::string_view text, const std::string& file);

/// Cells that held a word in place of a number, although the header does not say so.
struct GridWords {
    std::size_t cells = 0;
    std::string first;  ///< the first such word, as it stands there
};
struct AsciiGrid {
    Raster<double> raster;
    GridWords words;
};
/// The same, with how many words were taken as NODATA.
AsciiGrid read_ascii_grid_with_words(std::string_view text, const std::string& file);

/// The frame alone, from the first part of the text, which has to hold all of the header: what the cells are
/// is not looked at. Throws as above for faults of the header.
GridFrame read_ascii_frame(std::string_view beginning, const std::string& file);

/// Whether a word stands for "no value": what printf of C, C++, Fortran, Java, MATLAB, R, SQL and
/// spreadsheets write for it, in any case.
bool is_word_for_nodata(std::string_view word);

/// The most bytes that the text of a grid may take, by the counts of its header: 64 for each value [choice],
/// which is written in 25 at most, and a mebibyte for the header. `beginning`: the first part of the text.
/// Nothing where it does not begin as a grid or holds no whole counts.
std::optional<std::uint64_t> most_grid_bytes(std::string_view beginning);

/// Writes a grid; NaN becomes -9999. Numbers are the shortest text that reads back the same; those of the
/// header have no exponent, which simple readers cannot take. Cell size is written as cellsize where cells
/// are square, else as dx and dy. Requires no infinite value.
void write_ascii_grid(std::ostream& out, const Raster<double>& raster);
/// Shortest text of the value as a float: for derived maps, about 7 digits.
void write_ascii_grid(std::ostream& out, const Raster<float>& raster);

}  // namespace config
