#include "coupling/inputs/formats/geotiff.hpp"

#include <xtiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/geotiff_keys.hpp"
#include "coupling/inputs/formats/tiff_bytes.hpp"

namespace coupling::formats {
namespace {

using config::joined;

constexpr double nan_cell = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(const std::string& file, std::string found, std::string expected,
                         std::string advice = "") {
    config::fail(config::ExitCode::data, {file}, std::move(found), std::move(expected), std::move(advice));
}

/// How a compression may be called, and how many bytes may come out of a stored one. What a file claims
/// beyond that is refused before memory is taken for it.
struct Compression {
    std::uint16_t code;
    const char* name;
    std::uint64_t most_per_byte;
};

constexpr std::array compressions{Compression{COMPRESSION_NONE, "none", 1},
                                  Compression{COMPRESSION_LZW, "LZW", 4096},
                                  Compression{COMPRESSION_ADOBE_DEFLATE, "deflate", 1100},
                                  Compression{COMPRESSION_DEFLATE, "deflate", 1100},
                                  Compression{COMPRESSION_PACKBITS, "packbits", 64},
                                  Compression{COMPRESSION_LZMA, "LZMA", 10'000},
                                  Compression{COMPRESSION_ZSTD, "ZSTD", 20'000},
                                  Compression{COMPRESSION_LERC, "LERC", 20'000}};

/// What the tags say of the cells.
struct Layout {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint16_t bits = 1;
    std::uint16_t sample_format = SAMPLEFORMAT_UINT;
    bool is_tiled = false;
    std::uint32_t block_columns = 0;  ///< of a tile, or all columns
    std::uint32_t block_rows = 0;
    std::uint64_t most_per_byte = 1;
    std::optional<double> no_data;

    [[nodiscard]] std::size_t cell_bytes() const { return bits / 8U; }
};

/// A tag that libtiff does not know: text that GDAL writes.
std::string text_tag(TIFF* tiff, std::uint32_t tag) {
    const TIFFField* field = TIFFFindField(tiff, tag, TIFF_ANY);
    if (field == nullptr || TIFFFieldDataType(field) != TIFF_ASCII || TIFFFieldPassCount(field) == 0 ||
        TIFFFieldReadCount(field) != TIFF_VARIABLE2) {
        return {};
    }
    std::uint32_t count = 0;
    const char* text = nullptr;
    if (TIFFGetField(tiff, tag, &count, &text) != 1 || text == nullptr) {
        return {};
    }
    return std::string{text, strnlen(text, count)};
}

const Compression& compression_of(TIFF* tiff, const std::string& file) {
    std::uint16_t code = COMPRESSION_NONE;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &code);
    const auto known = std::find_if(compressions.begin(), compressions.end(),
                                    [&](const Compression& c) { return c.code == code; });
    if (known == compressions.end() || TIFFIsCODECConfigured(code) == 0) {
        const TIFFCodec* codec = TIFFFindCODEC(code);
        refuse(file,
               joined("compression ", codec == nullptr ? std::to_string(code) : std::string{codec->name}),
               "none, LZW, deflate, packbits, LZMA, ZSTD or LERC",
               "save it with one of these (QGIS: Translate, option COMPRESS=DEFLATE)");
    }
    return *known;
}

/// What GDAL says of the first band in a role; nothing where it does not.
std::optional<std::string> said_of_band(TIFF* tiff, const std::string& role) {
    const std::string metadata = text_tag(tiff, 42112);
    const std::size_t at = metadata.find("role=\"" + role + "\"");
    const std::size_t begin = at == std::string::npos ? at : metadata.find('>', at);
    const std::size_t end = begin == std::string::npos ? begin : metadata.find('<', begin);
    return end == std::string::npos ? std::nullopt
                                    : std::optional{metadata.substr(begin + 1, end - begin - 1)};
}

/// Where GDAL keeps a number by which all cells are to be multiplied, or which is to be added.
void refuse_packed_numbers(TIFF* tiff, const std::string& file) {
    for (const auto& [role, plain] :
         std::array<std::pair<std::string, double>, 2>{{{"scale", 1.0}, {"offset", 0.0}}}) {
        const std::optional<std::string> value = said_of_band(tiff, role);
        if (value && config::parse_number(*value) != plain) {
            refuse(file, joined("cells with a ", role, " of ", config::in_quotes(*value)),
                   "cells that hold the values themselves",
                   "unpack them (gdal_translate -unscale -ot Float32)");
        }
    }
}

/// A mask tells which cells are known; a grid of ours says so by its NODATA.
void refuse_mask(TIFF* tiff, const std::string& file) {
    constexpr int most_directories = 50;  // overviews, of each perhaps a mask
    for (int i = 0; i < most_directories && TIFFReadDirectory(tiff) == 1; ++i) {
        std::uint32_t kind = 0;
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SUBFILETYPE, &kind);
        if ((kind & FILETYPE_MASK) != 0) {
            refuse(file, "a mask beside the cells", "NODATA as a value of cells",
                   "write it so (gdalwarp -dstnodata -9999)");
        }
    }
    TIFFSetDirectory(tiff, 0);
}

std::optional<double> no_data_of(TIFF* tiff, const std::string& file) {
    const std::string text{config::trimmed(text_tag(tiff, 42113))};
    if (text.empty() || text == "nan" || text == "NaN" || text == "-nan") {
        return std::nullopt;  // floats that are no numbers are none with every tag
    }
    const auto value = config::parse_number(text);
    if (!value) {
        refuse(file, joined("NODATA ", config::in_quotes(text)), "a number or nan");
    }
    return value;
}

Layout layout_of(TIFF* tiff, const std::string& file, std::uint64_t file_bytes) {
    Layout layout;
    std::uint16_t bands = 1;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout.columns);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout.rows);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &bands);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &layout.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &layout.sample_format);
    if (bands != 1) {
        refuse(file, std::to_string(bands) + " bands", "a grid of one band",
               "export the band that holds the values (QGIS: Translate; gdal_translate -b 1)");
    }
    const bool is_float = layout.sample_format == SAMPLEFORMAT_IEEEFP;
    const bool is_whole = layout.sample_format == SAMPLEFORMAT_UINT ||
                          layout.sample_format == SAMPLEFORMAT_INT ||
                          layout.sample_format == SAMPLEFORMAT_VOID;
    const bool has_bytes = layout.bits == 8 || layout.bits == 16 || layout.bits == 32 || layout.bits == 64;
    if (!(is_whole && has_bytes) && !(is_float && (layout.bits == 32 || layout.bits == 64))) {
        refuse(file,
               joined("cells of ", std::to_string(layout.bits),
                      is_whole   ? " bits"
                      : is_float ? " bits, floating"
                                 : " bits, complex or unknown"),
               "whole numbers of 8, 16, 32 or 64 bits or floats of 32 or 64",
               "convert it (QGIS: Translate; gdal_translate -ot Float32)");
    }
    const Compression& compression = compression_of(tiff, file);
    layout.most_per_byte = compression.most_per_byte;
    const std::uint64_t cells = std::uint64_t{layout.columns} * layout.rows;
    if (cells == 0 || layout.columns > most_tiff_cells || layout.rows > most_tiff_cells ||
        cells > most_tiff_cells) {
        refuse(file, joined(std::to_string(layout.columns), " x ", std::to_string(layout.rows), " cells"),
               "a grid of 1 to 400 million cells", "cut out the slope that matters");
    }
    constexpr std::uint64_t most_of_sparse_files = 20'000;
    if (cells * layout.cell_bytes() / most_of_sparse_files > file_bytes) {
        refuse(file,
               joined(std::to_string(cells), " cells in a file of ", std::to_string(file_bytes), " bytes"),
               "a file that holds its cells", "copy the file again: it seems to be cut off");
    }
    layout.is_tiled = TIFFIsTiled(tiff) != 0;
    if (layout.is_tiled) {
        TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &layout.block_columns);
        TIFFGetField(tiff, TIFFTAG_TILELENGTH, &layout.block_rows);
    } else {
        layout.block_columns = layout.columns;
        TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &layout.block_rows);
        layout.block_rows = std::min(layout.block_rows, layout.rows);
    }
    constexpr std::uint64_t most_block_bytes = std::uint64_t{1} << 30U;
    const std::uint64_t block_cells = std::uint64_t{layout.block_columns} * layout.block_rows;
    if (block_cells == 0 || block_cells > most_block_bytes / layout.cell_bytes()) {
        refuse(file,
               joined("blocks of ", std::to_string(layout.block_columns), " x ",
                      std::to_string(layout.block_rows), " cells"),
               "strips or tiles of 1 byte to 1 GiB", "write it with tiles (gdal_translate -co TILED=YES)");
    }
    layout.no_data = no_data_of(tiff, file);
    return layout;
}

/// Reads cells block by block, so that memory grows with what the file holds.
class CellReader {
public:
    CellReader(TIFF* tiff, const Layout& layout, const std::string& file)
        : tiff_{tiff}, layout_{layout}, file_{file} {}

    std::vector<double> read() {
        std::vector<double> cells;
        for (std::uint32_t row = 0, rows = 0; row < layout_.rows; row += rows) {
            rows = std::min(layout_.block_rows, layout_.rows - row);
            const std::size_t begin = cells.size();
            for (std::uint32_t column = 0, columns = 0; column < layout_.columns; column += columns) {
                columns = std::min(layout_.block_columns, layout_.columns - column);
                const bool is_stored = read_block(column, row, rows);
                if (column == 0) {
                    cells.resize(begin + std::size_t{rows} * layout_.columns);
                }
                place(column, rows, is_stored, cells.data() + begin);
            }
        }
        return cells;
    }

private:
    /// Reads a strip or tile into the buffer; false where the file leaves it out, as GDAL does with blocks
    /// that hold nothing.
    bool read_block(std::uint32_t column, std::uint32_t row, std::uint32_t rows) {
        const std::uint32_t number =
            layout_.is_tiled ? TIFFComputeTile(tiff_, column, row, 0, 0) : TIFFComputeStrip(tiff_, row, 0);
        int error = 0;
        const std::uint64_t stored = TIFFGetStrileByteCountWithErr(tiff_, number, &error);
        if (error == 0 && stored == 0 && TIFFGetStrileOffsetWithErr(tiff_, number, &error) == 0) {
            return false;
        }
        const std::uint64_t wanted = std::uint64_t{layout_.block_columns} * layout_.cell_bytes() *
                                     (layout_.is_tiled ? layout_.block_rows : rows);
        constexpr std::uint64_t of_headers = 4096;
        if (error != 0 || wanted / layout_.most_per_byte > stored + of_headers) {
            refuse_block(row);
        }
        if (buffer_bytes_ < wanted) {
            // Left as it is: memory that nothing is written to is none.
            buffer_.reset(static_cast<char*>(std::malloc(wanted)));
            buffer_bytes_ = buffer_ ? wanted : 0;
            if (!buffer_) {
                refuse(file_, joined("blocks of ", std::to_string(wanted), " bytes"),
                       "blocks that the memory holds", "write it with tiles (gdal_translate -co TILED=YES)");
            }
        }
        const auto size = static_cast<tmsize_t>(wanted);
        const tmsize_t read = layout_.is_tiled ? TIFFReadEncodedTile(tiff_, number, buffer_.get(), size)
                                               : TIFFReadEncodedStrip(tiff_, number, buffer_.get(), size);
        if (read != size) {
            refuse_block(row);
        }
        return true;
    }

    [[noreturn]] void refuse_block(std::uint32_t row) const {
        refuse(file_, joined("cells that cannot be read from row ", std::to_string(row + 1), " on"),
               joined("all ", std::to_string(layout_.rows), " rows of the grid"),
               "copy or export the file again: it is cut off or damaged");
    }

    void place(std::uint32_t column, std::uint32_t rows, bool is_stored, double* to) const {
        const std::uint32_t columns = std::min(layout_.block_columns, layout_.columns - column);
        for (std::uint32_t r = 0; r < rows; ++r) {
            double* line = to + std::size_t{r} * layout_.columns + column;
            if (is_stored) {
                const char* from =
                    buffer_.get() + std::size_t{r} * layout_.block_columns * layout_.cell_bytes();
                convert(from, columns, line);
            } else {
                std::fill_n(line, columns, layout_.no_data ? nan_cell : 0.0);
            }
        }
    }

    void convert(const char* from, std::uint32_t count, double* to) const {
        if (layout_.sample_format == SAMPLEFORMAT_IEEEFP) {
            layout_.bits == 32 ? convert_as<float>(from, count, to) : convert_as<double>(from, count, to);
        } else if (layout_.sample_format == SAMPLEFORMAT_INT) {
            layout_.bits == 8    ? convert_as<std::int8_t>(from, count, to)
            : layout_.bits == 16 ? convert_as<std::int16_t>(from, count, to)
            : layout_.bits == 32 ? convert_as<std::int32_t>(from, count, to)
                                 : convert_as<std::int64_t>(from, count, to);
        } else {
            layout_.bits == 8    ? convert_as<std::uint8_t>(from, count, to)
            : layout_.bits == 16 ? convert_as<std::uint16_t>(from, count, to)
            : layout_.bits == 32 ? convert_as<std::uint32_t>(from, count, to)
                                 : convert_as<std::uint64_t>(from, count, to);
        }
    }

    template <class Number>
    void convert_as(const char* from, std::uint32_t count, double* to) const {
        // The tag is decimal text: of a grid of floats it means the float next to it.
        const double none =
            !layout_.no_data ? nan_cell
            : std::is_same_v<Number, float>
                ? static_cast<double>(static_cast<float>(std::clamp(*layout_.no_data, -3.5e38, 3.5e38)))
                : *layout_.no_data;
        for (std::uint32_t i = 0; i < count; ++i) {
            Number value{};
            std::memcpy(&value, from + i * sizeof(Number), sizeof(Number));
            const auto cell = static_cast<double>(value);
            if (std::isinf(cell) && cell != none) {
                refuse(file_, "an infinite cell", "numbers, and NODATA where nothing is known",
                       "correct the grid");
            }
            to[i] = cell == none ? nan_cell : cell;
        }
    }

    TIFF* tiff_;
    const Layout& layout_;
    const std::string& file_;
    struct Free {
        void operator()(char* bytes) const { std::free(bytes); }
    };
    std::unique_ptr<char, Free> buffer_;
    std::uint64_t buffer_bytes_ = 0;
};

/// Numbers of a tag of GeoTIFF; none where it is missing.
std::span<const double> doubles_of(TIFF* tiff, std::uint32_t tag) {
    std::uint16_t count = 0;
    const double* values = nullptr;
    if (TIFFGetField(tiff, tag, &count, &values) != 1 || values == nullptr) {
        return {};
    }
    return {values, count};
}

/// Coordinates of the north-western corner and the size of a cell, southward positive.
struct CornerAndCell {
    double x_m, y_m, width_m, height_m;
};

CornerAndCell corner_and_cell(TIFF* tiff, const std::string& file) {
    const auto matrix = doubles_of(tiff, TIFFTAG_GEOTRANSMATRIX);
    if (matrix.size() == 16) {
        if (matrix[1] != 0.0 || matrix[4] != 0.0) {
            refuse(file, "a rotated grid", "rows that run from west to east",
                   "resample it to north up (QGIS: Warp)");
        }
        return {matrix[3], matrix[7], matrix[0], -matrix[5]};
    }
    const auto scale = doubles_of(tiff, TIFFTAG_GEOPIXELSCALE);
    const auto tie = doubles_of(tiff, TIFFTAG_GEOTIEPOINTS);
    if (scale.size() < 2 || tie.size() < 6) {
        refuse(file, "no place on the map", "a GeoTIFF, which says where its cells lie",
               "export it as GeoTIFF from QGIS; a world file beside it is not read");
    }
    if (tie.size() > 6) {
        refuse(file, joined(std::to_string(tie.size() / 6), " tie points"), "one corner and a size of cells",
               "resample it to north up (QGIS: Warp)");
    }
    return {tie[3] - tie[0] * scale[0], tie[4] + tie[1] * scale[1], scale[0], scale[1]};
}

/// The coordinate without what a sum of decimal numbers leaves in the last bits, as the text of a grid would
/// have it: the nearest millionth of a metre where that is nearer than a thousandth of it.
double without_rounding(double value) {
    constexpr double per_m = 1e6;
    constexpr double close = 1e-3;
    const double scaled = value * per_m;
    return std::abs(scaled - std::round(scaled)) < close ? std::round(scaled) / per_m : value;
}

config::GridFrame frame_of(TIFF* tiff, const Layout& layout, const GeoKeys& keys, const std::string& file) {
    CornerAndCell found = corner_and_cell(tiff, file);
    if (keys.cells_are_points) {
        found.x_m -= 0.5 * found.width_m;
        found.y_m += 0.5 * found.height_m;
    }
    constexpr double largest_cell_m = 100e3;
    constexpr double farthest_m = 1e9;
    const auto is_cell = [](double size) { return size > 0.0 && size <= largest_cell_m; };
    const auto is_near = [](double at) { return std::abs(at) <= farthest_m; };
    if (!is_cell(found.width_m) || !is_cell(found.height_m) || !is_near(found.x_m) || !is_near(found.y_m)) {
        refuse(file,
               joined("cells of ", config::to_text(found.width_m), " x ", config::to_text(found.height_m),
                      " with a corner at ", config::to_text(found.x_m), ", ", config::to_text(found.y_m)),
               "rows from north to south, cells above 0 and up to 100 km, corners up to 1e9 m",
               "resample it to north up (QGIS: Warp)");
    }
    config::GridFrame frame;
    frame.columns = static_cast<int>(layout.columns);
    frame.rows = static_cast<int>(layout.rows);
    frame.cell_width_m = found.width_m;
    frame.cell_height_m = found.height_m;
    frame.x_west_m = without_rounding(found.x_m);
    frame.y_south_m = without_rounding(found.y_m - frame.rows * found.height_m);
    return frame;
}

}  // namespace

bool is_tiff(std::string_view bytes) {
    constexpr std::array<std::string_view, 4> beginnings{
        std::string_view{"II*\0", 4}, {"MM\0*", 4}, {"II+\0", 4}, {"MM\0+", 4}};
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view beginning) { return bytes.starts_with(beginning); });
}

PlacedGrid read_geotiff(std::string_view bytes, const std::string& file) {
    static std::once_flag tags_are_known;
    std::call_once(tags_are_known, [] { XTIFFInitialize(); });
    TiffBytes source{bytes};
    const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff = open_tiff(source);
    if (!tiff) {
        refuse(file, "a TIFF whose tags cannot be read", "a complete GeoTIFF",
               "copy or export the file again: it is cut off or damaged");
    }
    const Layout layout = layout_of(tiff.get(), file, bytes.size());
    if (source.wanted_beyond) {
        refuse(file, "a TIFF that ends before its tags do", "a complete GeoTIFF",
               "copy or export the file again: it is cut off or damaged");
    }
    refuse_packed_numbers(tiff.get(), file);
    const GeoKeys keys = read_geo_keys(tiff.get());
    PlacedGrid grid;
    grid.projection = keys.projection;
    std::optional<HeightUnit> heights = keys.heights;
    const std::optional<std::string> unit = said_of_band(tiff.get(), "unittype");
    if (unit && (!heights || heights->is_metres_upwards())) {
        heights = height_unit_in_words(*unit);
    }
    if (heights && !heights->is_metres_upwards()) {
        grid.projection += (grid.projection.empty() ? "" : ",") + vertical_text(*heights);
    }
    grid.raster.frame = frame_of(tiff.get(), layout, keys, file);
    refuse_mask(tiff.get(), file);
    grid.raster.values = CellReader{tiff.get(), layout, file}.read();
    return grid;
}

}  // namespace coupling::formats
