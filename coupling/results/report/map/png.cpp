#include "coupling/results/report/map/png.hpp"

#include <array>
#include <boost/crc.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cassert>

#include "config/text/base64.hpp"
#include "config/text/joined.hpp"

namespace coupling::report {
namespace {

using config::joined;

enum class ColourType : char { grey = 0, indexed = 3 };
enum class RowFilter : char { none = 0, up = 2 };

std::string big_endian(std::uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>((value >> 16) & 0xFFU),
            static_cast<char>((value >> 8) & 0xFFU), static_cast<char>(value & 0xFFU)};
}

/// Length, type, data, check sum of type and data.
std::string chunk(std::string_view type, std::string_view data) {
    const std::string body = std::string{type}.append(data);
    boost::crc_32_type sum;
    sum.process_bytes(body.data(), body.size());
    return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(sum.checksum());
}

std::string deflated(const std::string& bytes) {
    namespace io = boost::iostreams;
    std::vector<char> packed;
    io::filtering_ostream stream;
    stream.push(io::zlib_compressor{io::zlib::default_compression});
    stream.push(io::back_inserter(packed));
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.reset();  // closes: all bytes are out
    return {packed.begin(), packed.end()};
}

/// Rows as PNG wants them: a filter byte before each. Subtracting the row above packs smooth pictures better.
std::string filtered_rows(int width, int height, std::span<const std::uint8_t> pixels, RowFilter filter) {
    assert(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto columns = static_cast<std::size_t>(width);
    std::string rows;
    rows.reserve(pixels.size() + static_cast<std::size_t>(height));
    for (std::size_t first = 0; first < pixels.size(); first += columns) {
        rows += static_cast<char>(filter);
        for (std::size_t i = first; i < first + columns; ++i) {
            const int above = filter == RowFilter::up && first > 0 ? pixels[i - columns] : 0;
            rows += static_cast<char>(static_cast<std::uint8_t>(pixels[i] - above));
        }
    }
    return rows;
}

std::string file(int width, int height, ColourType type, const std::string& colours,
                 const std::string& rows) {
    std::string header =
        big_endian(static_cast<std::uint32_t>(width)) + big_endian(static_cast<std::uint32_t>(height));
    header += {8, static_cast<char>(type), 0, 0,
               0};  // bits, colour type, deflate, adaptive filters, not interlaced
    return joined("\x89PNG\r\n\x1a\n", chunk("IHDR", header), colours, chunk("IDAT", deflated(rows)),
                  chunk("IEND", ""));
}

}  // namespace

std::string png(const IndexedPicture& picture) {
    assert(!picture.palette.empty() && picture.palette.size() <= 256);
    std::string palette;
    for (const Colour& colour : picture.palette) {
        palette +=
            {static_cast<char>(colour.red), static_cast<char>(colour.green), static_cast<char>(colour.blue)};
    }
    const std::string see_through(1, '\0');  // opacity of the first colour; the others are opaque
    return file(picture.width, picture.height, ColourType::indexed,
                chunk("PLTE", palette) + chunk("tRNS", see_through),
                filtered_rows(picture.width, picture.height, picture.pixels, RowFilter::none));
}

std::string png(const GreyPicture& picture) {
    return file(picture.width, picture.height, ColourType::grey, "",
                filtered_rows(picture.width, picture.height, picture.pixels, RowFilter::up));
}

std::string data_address(std::string_view png_bytes) {
    return joined("data:image/png;base64,", config::base64(png_bytes));
}

}  // namespace coupling::report
