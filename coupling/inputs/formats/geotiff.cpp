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
#include "coupling/inputs/formats/geotiff_place.hpp"
#include "coupling/inputs/formats/geotiff_tags.hpp"
#include "coupling/inputs/formats/tiff_bytes.hpp"

namespace coupling::formats {
namespace {

using config::joined;

constexpr double nan_cell = std::numeric_limits<double>::quiet_NaN();

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

const Compression& compression_of(TIFF* tiff, const std::string& file) {
    std::uint16_t code = COMPRESSION_NONE;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &code);
    const auto known = std::find_if(compressions.begin(), compressions.end(),
                                    [&](const Compression& c) { return c.code == code; });
    if (known == compressions.end() || TIFFIsCODECConfigured(code) == 0) {
        const TIFFCodec* codec = TIFFFindCODEC(code);
        refuse_tiff(
            file, joined("compression ", codec == nullptr ? std::to_string(code) : std::string{codec->name}),
            "none, LZW, deflate, packbits, LZMA, ZSTD or LERC",
            "save it with one of these (QGIS: Translate, option COMPRESS=DEFLATE)");
    }
    return *known;
}

std::optional<double> no_data_of(TIFF* tiff, const std::string& file) {
    const std::string text{config::trimmed(text_of_tag(tiff, 42113))};
    if (text.empty() || text == "nan" || text == "NaN" || text == "-nan") {
        return std::nullopt;  // floats that are no numbers are none with every tag
    }
    const auto value = config::parse_number(text);
    if (!value) {
        refuse_tiff(file, joined("NODATA ", config::in_quotes(text)), "a number or nan");
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
        refuse_tiff(file, std::to_string(bands) + " bands", "a grid of one band",
                    "export the band that holds the values (QGIS: Translate; gdal_translate -b 1)");
    }
    const bool is_float = layout.sample_format == SAMPLEFORMAT_IEEEFP;
    const bool is_whole = layout.sample_format == SAMPLEFORMAT_UINT ||
                          layout.sample_format == SAMPLEFORMAT_INT ||
                          layout.sample_format == SAMPLEFORMAT_VOID;
    const bool has_bytes = layout.bits == 8 || layout.bits == 16 || layout.bits == 32 || layout.bits == 64;
    if (!(is_whole && has_bytes) && !(is_float && (layout.bits == 32 || layout.bits == 64))) {
        refuse_tiff(file,
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
        refuse_tiff(file,
                    joined(std::to_string(layout.columns), " x ", std::to_string(layout.rows), " cells"),
                    "a grid of 1 to 400 million cells", "cut out the slope that matters");
    }
    constexpr std::uint64_t most_of_sparse_files = 20'000;
    if (cells * layout.cell_bytes() / most_of_sparse_files > file_bytes) {
        refuse_tiff(
            file, joined(std::to_string(cells), " cells in a file of ", std::to_string(file_bytes), " bytes"),
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
        refuse_tiff(file,
                    joined("blocks of ", std::to_string(layout.block_columns), " x ",
                           std::to_string(layout.block_rows), " cells"),
                    "strips or tiles of 1 byte to 1 GiB",
                    "write it with tiles (gdal_translate -co TILED=YES)");
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
                refuse_tiff(file_, joined("blocks of ", std::to_string(wanted), " bytes"),
                            "blocks that the memory holds",
                            "write it with tiles (gdal_translate -co TILED=YES)");
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
        refuse_tiff(file_, joined("cells that cannot be read from row ", std::to_string(row + 1), " on"),
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
                refuse_tiff(file_, "an infinite cell", "numbers, and NODATA where nothing is known",
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

}  // namespace

bool is_tiff(std::string_view bytes) {
    constexpr std::array<std::string_view, 4> beginnings{
        std::string_view{"II*\0", 4}, {"MM\0*", 4}, {"II+\0", 4}, {"MM\0+", 4}};
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view beginning) { return bytes.starts_with(beginning); });
}

namespace {

/// A TIFF whose tags were read.
struct OpenTiff {
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff;
    Layout layout;
    GridHead head;
    std::string remark;  ///< on its world file
};

OpenTiff opened(TiffBytes& source, const std::string& file, std::string_view world_file) {
    static std::once_flag tags_are_known;
    std::call_once(tags_are_known, [] { XTIFFInitialize(); });
    OpenTiff open{open_tiff(source), {}, {}, {}};
    if (source.failure) {
        std::rethrow_exception(source.failure);
    }
    if (!open.tiff) {
        refuse_tiff(file, "a TIFF whose tags cannot be read", "a complete GeoTIFF",
                    "copy or export the file again: it is cut off or damaged");
    }
    open.layout = layout_of(open.tiff.get(), file, source.size);
    if (source.failure) {
        std::rethrow_exception(source.failure);
    }
    if (source.wanted_beyond) {
        refuse_tiff(file, "a TIFF that ends before its tags do", "a complete GeoTIFF",
                    "copy or export the file again: it is cut off or damaged");
    }
    const GeoKeys keys = read_geo_keys(open.tiff.get());
    open.head.projection = keys.projection;
    if (keys.heights && !keys.heights->is_metres_upwards()) {
        open.head.projection += (open.head.projection.empty() ? "" : ",") + vertical_text(*keys.heights);
    }
    open.head.frame = frame_of_tiff(open.tiff.get(), open.layout.columns, open.layout.rows,
                                    keys.cells_are_points, world_file, file);
    open.remark = judge_world_file(open.head.frame, world_file, file);
    if (source.failure) {
        std::rethrow_exception(source.failure);
    }
    return open;
}

}  // namespace

PlacedGrid read_geotiff(std::string_view bytes, const std::string& file, std::string_view world_file) {
    TiffBytes source{bytes};
    const OpenTiff open = opened(source, file, world_file);
    PlacedGrid grid;
    grid.projection = open.head.projection;
    grid.raster.frame = open.head.frame;
    if (!open.remark.empty()) {
        grid.remarks.push_back(open.remark);
    }
    look_at_other_parts(open.tiff.get(), file, grid.remarks);
    grid.raster.values = CellReader{open.tiff.get(), open.layout, file}.read();
    return grid;
}

GridHead read_geotiff_head(TiffBytes& source, const std::string& file, std::string_view world_file) {
    return opened(source, file, world_file).head;
}

}  // namespace coupling::formats
