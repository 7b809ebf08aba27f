#pragma once

#include <bit>
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "config/grid/ascii_grid.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/grids/mosaic.hpp"
#include "coupling/results/maps/geotiff.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// The forms in which tests write tiles.
inline const std::vector<std::string>& endings_of_tiles() {
    static const std::vector<std::string> endings{".asc", ".asc.gz", ".tif", ".flt", ".bil", ".xyz"};
    return endings;
}

inline std::string ascii_text(const config::Raster<double>& grid) {
    std::ostringstream text;
    config::write_ascii_grid(text, grid);
    return text.str();
}

inline std::string packed(const std::string& text) {
    namespace io = boost::iostreams;
    std::istringstream from{text};
    io::filtering_streambuf<io::input> through;
    through.push(io::gzip_compressor{});
    through.push(from);
    std::ostringstream bytes;
    io::copy(through, bytes);
    return bytes.str();
}

/// 32-bit floats from the north-west, the lowest byte first; -9999 where nothing is known.
inline std::string floats(const config::Raster<double>& grid) {
    std::string bytes;
    for (const double value : grid.values) {
        const auto bits =
            std::bit_cast<std::uint32_t>(std::isnan(value) ? -9999.0F : static_cast<float>(value));
        for (unsigned shift = 0; shift < 32; shift += 8) {
            bytes += static_cast<char>(bits >> shift & 0xFFU);
        }
    }
    return bytes;
}

/// Header of `.flt` (corners) or `.bil` (centres).
inline std::string raw_header(const config::GridFrame& frame, bool is_flt) {
    using config::to_text;
    if (is_flt) {
        return "ncols " + std::to_string(frame.columns) + "\nnrows " + std::to_string(frame.rows) +
               "\nxllcorner " + to_text(frame.x_west_m) + "\nyllcorner " + to_text(frame.y_south_m) +
               "\ncellsize " + to_text(frame.cell_width_m) + "\nNODATA_value -9999\nbyteorder LSBFIRST\n";
    }
    return "BYTEORDER I\nLAYOUT BIL\nNROWS " + std::to_string(frame.rows) + "\nNCOLS " +
           std::to_string(frame.columns) + "\nNBANDS 1\nNBITS 32\nPIXELTYPE FLOAT\nULXMAP " +
           to_text(frame.x_centre_m(0)) + "\nULYMAP " + to_text(frame.y_centre_m(0)) + "\nXDIM " +
           to_text(frame.cell_width_m) + "\nYDIM " + to_text(frame.cell_height_m) + "\nNODATA -9999\n";
}

inline std::string points_text(const config::Raster<double>& grid) {
    std::string text;
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        if (!std::isnan(grid.values[i])) {
            const config::Cell cell = grid.frame.cell_of(i);
            text += config::to_text(grid.frame.x_centre_m(cell.column)) + " " +
                    config::to_text(grid.frame.y_centre_m(cell.row)) + " " + config::to_text(grid.values[i]) +
                    "\n";
        }
    }
    return text;
}

/// Writes a grid of square cells into the file `stem` + `ending` of a project, with the coordinate system of
/// its dem.asc beside it. Values should be those of 32-bit floats.
inline void write_tile(const SampleProject& project, const std::string& stem, const std::string& ending,
                       const config::Raster<double>& grid) {
    const std::string name = stem + ending;
    project.write(stem + ".prj", project.read("dem.prj"));
    if (ending == ".asc") {
        project.write(name, ascii_text(grid));
    } else if (ending == ".asc.gz") {
        project.write(name, packed(ascii_text(grid)));
    } else if (ending == ".tif") {
        write_geotiff(project.file(name), grid, project.read("dem.prj"));
    } else if (ending == ".flt" || ending == ".bil") {
        project.write(stem + ".hdr", raw_header(grid.frame, ending == ".flt"));
        project.write(name, floats(grid));
    } else if (ending == ".xyz") {
        project.write(name, points_text(grid));
    } else {
        throw std::logic_error{"no tile is written as " + ending};
    }
}

/// A virtual raster of tiles that lie in `whole`, as gdalbuildvrt writes it: names and cells of each.
inline std::string vrt_text(const config::GridFrame& whole,
                            const std::vector<std::pair<std::string, grids::CellWindow>>& tiles) {
    using config::to_text;
    std::string text = "<VRTDataset rasterXSize=\"" + std::to_string(whole.columns) + "\" rasterYSize=\"" +
                       std::to_string(whole.rows) + "\">\n  <GeoTransform> " + to_text(whole.x_west_m) +
                       ", " + to_text(whole.cell_width_m) + ", 0, " + to_text(whole.y_north_m()) + ", 0, -" +
                       to_text(whole.cell_height_m) +
                       "</GeoTransform>\n  <VRTRasterBand dataType=\"Float32\" band=\"1\">\n";
    for (const auto& [name, cells] : tiles) {
        const std::string size = "xSize=\"" + std::to_string(cells.columns) + "\" ySize=\"" +
                                 std::to_string(cells.rows) + "\" />\n";
        text += "    <SimpleSource>\n      <SourceFilename relativeToVRT=\"1\">" + name +
                "</SourceFilename>\n      <SrcRect xOff=\"0\" yOff=\"0\" " + size + "      <DstRect xOff=\"" +
                std::to_string(cells.first.column) + "\" yOff=\"" + std::to_string(cells.first.row) + "\" " +
                size + "    </SimpleSource>\n";
    }
    return text + "  </VRTRasterBand>\n</VRTDataset>\n";
}

/// Four windows that overlap by `over` cells, cut west of a column and north of a row.
inline std::vector<grids::CellWindow> four_windows(const config::GridFrame& whole, config::Cell cut,
                                                   int over) {
    const int east = std::min(whole.columns, cut.column + over);
    const int south = std::min(whole.rows, cut.row + over);
    return {{{0, 0}, east, south},
            {{cut.column, 0}, whole.columns - cut.column, south},
            {{0, cut.row}, east, whole.rows - cut.row},
            {{cut.column, cut.row}, whole.columns - cut.column, whole.rows - cut.row}};
}

}  // namespace coupling
