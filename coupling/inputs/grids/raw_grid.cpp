#include "coupling/inputs/grids/raw_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::grids {
namespace {

using config::joined;

constexpr double no_height = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t most_raw_cells = 400'000'000;  // as many as maps may have

enum class Number { float_32, unsigned_8, unsigned_16, signed_16, unsigned_32, signed_32 };

/// What a header says.
struct RawLayout {
    config::GridFrame frame;
    Number number = Number::float_32;
    bool is_big_endian = false;
    std::uint64_t skipped_bytes = 0;  ///< before the first cell
    std::uint64_t row_bytes = 0;
    std::optional<double> no_data;

    [[nodiscard]] std::uint64_t cell_bytes() const {
        return number == Number::unsigned_8                                   ? 1
               : number == Number::unsigned_16 || number == Number::signed_16 ? 2
                                                                              : 4;
    }
};

[[noreturn]] void refuse(const std::string& file, std::string found, std::string expected,
                         std::string advice) {
    config::fail(config::ExitCode::data, {file}, std::move(found), std::move(expected), std::move(advice));
}

constexpr const char* convert = "convert the grid to GeoTIFF (gdal_translate IN dem.tif)";

/// The words of a header by their keys, in lower case.
class RawHeader {
public:
    RawHeader(std::string_view text, const std::string& file) : file_{file} {
        text = config::without_byte_order_mark(text);
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            const std::string_view line = config::trimmed(text.substr(0, end));
            text.remove_prefix(std::min(end + 1, text.size()));
            const std::size_t blank = line.find_first_of(" \t");
            if (blank != std::string_view::npos) {
                words_.emplace(config::in_lower_case(line.substr(0, blank)),
                               config::trimmed(line.substr(blank)));
            }
        }
    }

    [[nodiscard]] bool has(const char* key) const { return words_.contains(key); }
    [[nodiscard]] std::string word(const char* key, const char* otherwise) const {
        const auto found = words_.find(key);
        return found == words_.end() ? otherwise : config::in_lower_case(found->second);
    }
    [[nodiscard]] double number(const char* key) const {
        const auto found = words_.find(key);
        const auto value = found == words_.end() ? std::nullopt : config::parse_number(found->second);
        if (!value) {
            refuse(file_,
                   found == words_.end()
                       ? joined("a header (.hdr) without ", key)
                       : joined("a header (.hdr) with ", key, " ", config::in_quotes(found->second)),
                   "ncols, nrows, xllcorner, yllcorner, cellsize and byteorder, or NROWS, NCOLS, NBITS, "
                   "ULXMAP, ULYMAP, XDIM and YDIM, each with a number",
                   convert);
        }
        return *value;
    }
    [[nodiscard]] double number_or(const char* key, double otherwise) const {
        return has(key) ? number(key) : otherwise;
    }
    [[nodiscard]] int count(const char* key) const {
        const double value = number(key);
        if (!(value >= 1.0 && value <= static_cast<double>(most_raw_cells)) || value != std::floor(value)) {
            refuse(file_, joined("a header (.hdr) with ", key, " ", config::to_text(value)),
                   "a whole number from 1 to 400 million", convert);
        }
        return static_cast<int>(value);
    }
    [[nodiscard]] std::uint64_t bytes_or(const char* key, std::uint64_t otherwise) const {
        const double value = number_or(key, static_cast<double>(otherwise));
        if (!(value >= 0.0 && value <= 1e10) || value != std::floor(value)) {
            refuse(file_, joined("a header (.hdr) with ", key, " ", config::to_text(value)),
                   "a number of bytes", convert);
        }
        return static_cast<std::uint64_t>(value);
    }

private:
    std::map<std::string, std::string, std::less<>> words_;
    const std::string& file_;
};

config::GridFrame frame_of(const RawHeader& header, const std::string& file) {
    config::GridFrame frame;
    frame.columns = header.count("ncols");
    frame.rows = header.count("nrows");
    if (static_cast<std::uint64_t>(frame.columns) * static_cast<std::uint64_t>(frame.rows) > most_raw_cells) {
        refuse(file, joined(std::to_string(frame.columns), " x ", std::to_string(frame.rows), " cells"),
               "a grid of 1 to 400 million cells", "cut out the slope that matters");
    }
    if (header.has("ulxmap") || header.has("xdim")) {
        frame.cell_width_m = header.number("xdim");
        frame.cell_height_m = header.number("ydim");
        frame.x_west_m = header.number("ulxmap") - 0.5 * frame.cell_width_m;
        frame.y_south_m = header.number("ulymap") - (frame.rows - 0.5) * frame.cell_height_m;
    } else {
        frame.cell_width_m = frame.cell_height_m = header.number("cellsize");
        frame.x_west_m = header.has("xllcenter") ? header.number("xllcenter") - 0.5 * frame.cell_width_m
                                                 : header.number("xllcorner");
        frame.y_south_m = header.has("yllcenter") ? header.number("yllcenter") - 0.5 * frame.cell_height_m
                                                  : header.number("yllcorner");
    }
    const auto is_cell = [](double size_m) { return size_m > 0.0 && size_m <= 100e3; };
    const auto is_near = [](double place_m) { return std::abs(place_m) <= 1e9; };
    if (!is_cell(frame.cell_width_m) || !is_cell(frame.cell_height_m) || !is_near(frame.x_west_m) ||
        !is_near(frame.y_south_m)) {
        refuse(file,
               joined("a header (.hdr) with cells of ", config::to_text(frame.cell_width_m), " x ",
                      config::to_text(frame.cell_height_m)),
               "cells above 0 and up to 100 km, corners up to 1e9 m", convert);
    }
    return frame;
}

Number number_of(const RawHeader& header, const std::string& file) {
    const bool is_esri =
        !header.has("nbits") && config::in_lower_case(file).find(".flt") != std::string::npos;
    const std::string type = header.word("pixeltype", is_esri ? "float" : "unsignedint");
    const auto bits = header.bytes_or("nbits", is_esri ? 32 : 8);
    if (type.starts_with("float") && bits == 32) {
        return Number::float_32;
    }
    const bool is_signed = type.starts_with("signed");
    if (is_signed || type.starts_with("unsigned")) {
        switch (bits) {
            case 8:
                if (!is_signed) {
                    return Number::unsigned_8;
                }
                break;
            case 16:
                return is_signed ? Number::signed_16 : Number::unsigned_16;
            case 32:
                return is_signed ? Number::signed_32 : Number::unsigned_32;
            default:
                break;
        }
    }
    refuse(file,
           joined("a header (.hdr) with numbers ", config::in_quotes(type), " of ", std::to_string(bits),
                  " bits"),
           "floats of 32 bits or whole numbers of 8, 16 or 32", convert);
}

RawLayout layout_of(std::string_view text, const std::string& file) {
    if (text.empty()) {
        config::fail(config::ExitCode::file, {file}, "no header (.hdr) beside it",
                     "the header, which says where the cells lie", "copy both files");
    }
    if (text.starts_with("ENVI")) {
        refuse(file, "a header (.hdr) of ENVI", "a header of ESRI: ncols, nrows, xllcorner, ...", convert);
    }
    const RawHeader header{text, file};
    RawLayout layout;
    layout.frame = frame_of(header, file);
    layout.number = number_of(header, file);
    if (header.number_or("nbands", 1.0) != 1.0) {
        refuse(file, joined(config::to_text(header.number("nbands")), " bands"), "a grid of one band",
               "export the band that holds the values (gdal_translate -b 1)");
    }
    const std::string order = header.word("byteorder", "lsbfirst");
    if (order != "lsbfirst" && order != "msbfirst" && order != "i" && order != "m") {
        refuse(file, joined("a header (.hdr) with byteorder ", config::in_quotes(order)),
               "LSBFIRST or MSBFIRST, I or M", convert);
    }
    layout.is_big_endian = order.starts_with('m');
    layout.skipped_bytes = header.bytes_or("skipbytes", 0);
    const std::uint64_t least = layout.cell_bytes() * static_cast<std::uint64_t>(layout.frame.columns);
    layout.row_bytes = header.bytes_or("totalrowbytes", header.bytes_or("bandrowbytes", least));
    if (layout.row_bytes < least) {
        refuse(file, joined("a header (.hdr) with rows of ", std::to_string(layout.row_bytes), " bytes"),
               joined("at least ", std::to_string(least), ", those of its cells"), convert);
    }
    for (const char* key : {"nodata_value", "nodata"}) {
        if (header.has(key) && !layout.no_data) {
            layout.no_data = config::in_lower_case(header.word(key, "")).find("nan") != std::string::npos
                                 ? no_height
                                 : header.number(key);
        }
    }
    if (!layout.no_data && layout.number == Number::float_32) {
        layout.no_data = -9999.0;  // as ESRI defines the format
    }
    return layout;
}

/// The bytes of a number as they stand in memory here.
template <class Bits>
Bits bits_at(const char* bytes, bool is_big_endian) {
    Bits bits{};
    std::memcpy(&bits, bytes, sizeof bits);
    if (is_big_endian != (std::endian::native == std::endian::big)) {
        Bits turned{};
        for (std::size_t i = 0; i < sizeof bits; ++i) {
            turned = static_cast<Bits>(static_cast<std::uint64_t>(turned) << 8U | (bits >> 8U * i & 0xFFU));
        }
        return turned;
    }
    return bits;
}

double value_at(const char* bytes, const RawLayout& layout) {
    switch (layout.number) {
        case Number::float_32:
            return static_cast<double>(
                std::bit_cast<float>(bits_at<std::uint32_t>(bytes, layout.is_big_endian)));
        case Number::unsigned_8:
            return static_cast<double>(bits_at<std::uint8_t>(bytes, false));
        case Number::unsigned_16:
            return static_cast<double>(bits_at<std::uint16_t>(bytes, layout.is_big_endian));
        case Number::signed_16:
            return static_cast<double>(
                static_cast<std::int16_t>(bits_at<std::uint16_t>(bytes, layout.is_big_endian)));
        case Number::unsigned_32:
            return static_cast<double>(bits_at<std::uint32_t>(bytes, layout.is_big_endian));
        case Number::signed_32:
            break;
    }
    return static_cast<double>(
        static_cast<std::int32_t>(bits_at<std::uint32_t>(bytes, layout.is_big_endian)));
}

}  // namespace

bool is_raw_grid(const std::string& file) {
    std::string name = config::in_lower_case(file);
    if (name.ends_with(".gz")) {
        name.erase(name.size() - 3);
    }
    return name.ends_with(".flt") || name.ends_with(".bil");
}

config::GridFrame read_raw_frame(std::string_view header, const std::string& file) {
    return layout_of(header, file).frame;
}

config::Raster<double> read_raw_grid(std::string_view bytes, std::string_view header,
                                     const std::string& file) {
    const RawLayout layout = layout_of(header, file);
    const auto rows = static_cast<std::uint64_t>(layout.frame.rows);
    const std::uint64_t wanted = layout.skipped_bytes + rows * layout.row_bytes;
    if (bytes.size() != wanted) {
        refuse(file, joined(std::to_string(bytes.size()), " bytes"),
               joined(std::to_string(wanted), " bytes for ", std::to_string(layout.frame.columns), " x ",
                      std::to_string(layout.frame.rows), " cells, as its header (.hdr) says"),
               "copy both files again: one of them is cut off or belongs to another grid");
    }
    double none = layout.no_data.value_or(no_height);
    if (layout.number == Number::float_32) {  // the header is decimal text: it means the float next to it
        none = static_cast<double>(static_cast<float>(std::clamp(none, -3.5e38, 3.5e38)));
    }
    config::Raster<double> grid{layout.frame};
    auto cell = grid.values.begin();
    for (std::uint64_t row = 0; row < rows; ++row) {
        const char* at = bytes.data() + layout.skipped_bytes + row * layout.row_bytes;
        for (int column = 0; column < layout.frame.columns; ++column, at += layout.cell_bytes()) {
            const double value = value_at(at, layout);
            if (std::isinf(value) && value != none) {
                refuse(file, "an infinite cell", "numbers, and NODATA where nothing is known",
                       "correct the grid");
            }
            *cell++ = value == none ? no_height : value;
        }
    }
    return grid;
}

}  // namespace coupling::grids
