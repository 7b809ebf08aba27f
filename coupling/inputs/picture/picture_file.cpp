#include "coupling/inputs/picture/picture_file.hpp"

#include <jpeglib.h>
#include <png.h>
#include <xtiffio.h>

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <mutex>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/geotiff_keys.hpp"
#include "coupling/inputs/formats/geotiff_place.hpp"
#include "coupling/inputs/formats/tiff_bytes.hpp"

namespace coupling::picture {
namespace {

using config::joined;

constexpr std::string_view png_magic{"\x89PNG\r\n\x1a\n", 8};
constexpr std::string_view jpeg_magic{"\xff\xd8\xff", 3};
constexpr std::uint8_t white = 255;

[[noreturn]] void refuse_picture(const std::string& file, std::string found, std::string expected,
                                 std::string advice) {
    config::fail(config::ExitCode::data, {file}, std::move(found), std::move(expected), std::move(advice));
}

[[noreturn]] void refuse_damaged(const std::string& file, const char* kind) {
    refuse_picture(file, joined("a ", kind, " that is damaged or cut off"), joined("a whole ", kind),
                   "copy or export the picture again");
}

/// Memory for so many pixels.
void make_room(Pixels& pixels, std::uint64_t width, std::uint64_t height, const std::string& file) {
    if (width == 0 || height == 0 || width > most_pixels || height > most_pixels ||
        width * height > most_pixels) {
        refuse_picture(
            file, joined("a picture of ", std::to_string(width), " x ", std::to_string(height), " pixels"),
            "1 to 100 million pixels",
            "cut out the slope, or make its pixels larger (QGIS: Warp; gdalwarp -tr 0.5 0.5)");
    }
    pixels.width = static_cast<std::uint32_t>(width);
    pixels.height = static_cast<std::uint32_t>(height);
    pixels.rgb.resize(3 * static_cast<std::size_t>(width * height));
}

Pixels read_png(std::string_view bytes, const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Pixels pixels;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
        refuse_damaged(file, "PNG");
    }
    image.format = PNG_FORMAT_RGB;
    try {
        make_room(pixels, image.width, image.height, file);
    } catch (...) {
        png_image_free(&image);
        throw;
    }
    const png_color paper{white, white, white};
    if (png_image_finish_read(&image, &paper, pixels.rgb.data(), 0, nullptr) == 0) {
        refuse_damaged(file, "PNG");
    }
    return pixels;
}

/// libjpeg ends with a jump where it meets what it cannot read; a warning of it is damage, too.
struct JpegErrors {
    jpeg_error_mgr manager;
    std::jmp_buf back;
};

[[noreturn]] void leave_jpeg(j_common_ptr info) {
    std::longjmp(reinterpret_cast<JpegErrors*>(info->err)->back, 1);
}

void say_nothing_of_jpeg(j_common_ptr) {}

/// Steps of libjpeg, none of which makes an object that has to be destroyed: a jump may leave them.
bool begin_jpeg(jpeg_decompress_struct& jpeg, JpegErrors& errors, const unsigned char* bytes,
                unsigned long size) {
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = leave_jpeg;
    errors.manager.output_message = say_nothing_of_jpeg;
    if (setjmp(errors.back) != 0) {
        return false;
    }
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, bytes, size);
    jpeg_read_header(&jpeg, TRUE);
    jpeg.out_color_space = JCS_RGB;
    jpeg.dct_method = JDCT_ISLOW;  // whole numbers: the same on every machine
    return true;
}

bool read_jpeg_rows(jpeg_decompress_struct& jpeg, JpegErrors& errors, unsigned char* to) {
    if (setjmp(errors.back) != 0) {
        return false;
    }
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
        unsigned char* row = to + std::size_t{3} * jpeg.output_width * jpeg.output_scanline;
        jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    return errors.manager.num_warnings == 0;
}

Pixels read_jpeg(std::string_view bytes, const std::string& file) {
    jpeg_decompress_struct jpeg{};
    JpegErrors errors{};
    struct Close {
        jpeg_decompress_struct& jpeg;
        ~Close() { jpeg_destroy_decompress(&jpeg); }
    };
    const bool begun =
        begin_jpeg(jpeg, errors, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    const Close closes{jpeg};
    if (!begun) {
        refuse_damaged(file, "JPEG");
    }
    Pixels pixels;
    make_room(pixels, jpeg.image_width, jpeg.image_height, file);
    if (!read_jpeg_rows(jpeg, errors, pixels.rgb.data())) {
        refuse_damaged(file, "JPEG");
    }
    return pixels;
}

Pixels pixels_of_tiff(TIFF* tiff, const std::string& file) {
    char why[1024] = "";
    if (TIFFRGBAImageOK(tiff, why) == 0) {
        refuse_picture(file, joined("a TIFF that is no picture: ", why),
                       "a TIFF of grey, palette or RGB of 8 or 16 bits",
                       "name the aerial picture or map itself, not heights; save it as RGB (QGIS: Save as, "
                       "rendered image)");
    }
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
    Pixels pixels;
    make_room(pixels, width, height, file);
    std::vector<std::uint32_t> packed(std::size_t{width} * height);
    constexpr int stop_on_error = 1;
    if (TIFFReadRGBAImageOriented(tiff, width, height, packed.data(), ORIENTATION_TOPLEFT, stop_on_error) ==
        0) {
        refuse_damaged(file, "TIFF");
    }
    for (std::size_t i = 0; i < packed.size(); ++i) {
        const std::uint32_t see_through = white - TIFFGetA(packed[i]);  // colours are multiplied by opacity
        pixels.rgb[3 * i] = static_cast<std::uint8_t>(TIFFGetR(packed[i]) + see_through);
        pixels.rgb[3 * i + 1] = static_cast<std::uint8_t>(TIFFGetG(packed[i]) + see_through);
        pixels.rgb[3 * i + 2] = static_cast<std::uint8_t>(TIFFGetB(packed[i]) + see_through);
    }
    return pixels;
}

PlacedPicture read_tiff_picture(std::string_view bytes, const std::string& file,
                                const formats::BytesBeside& beside) {
    static std::once_flag tags_are_known;
    std::call_once(tags_are_known, [] { XTIFFInitialize(); });
    formats::TiffBytes source{bytes};
    const auto tiff = formats::open_tiff(source);
    if (!tiff) {
        refuse_damaged(file, "TIFF");
    }
    PlacedPicture read;
    read.pixels = pixels_of_tiff(tiff.get(), file);
    const formats::GeoKeys keys = formats::read_geo_keys(tiff.get());
    read.projection = keys.projection;
    read.frame = formats::frame_of_tiff(tiff.get(), read.pixels.width, read.pixels.height,
                                        keys.cells_are_points, formats::world_file_beside(beside), file);
    return read;
}

/// The first of the world files that is there.
std::string_view world_file_of(const formats::BytesBeside& beside,
                               std::initializer_list<const char*> endings) {
    for (const char* ending : endings) {
        if (const std::string_view text = beside(ending); !text.empty()) {
            return text;
        }
    }
    return {};
}

}  // namespace

PlacedPicture read_picture(std::string_view bytes, const std::string& file,
                           const formats::BytesBeside& beside) {
    PlacedPicture read;
    if (formats::is_tiff(bytes)) {
        read = read_tiff_picture(bytes, file, beside);
    } else if (bytes.starts_with(png_magic) || bytes.starts_with(jpeg_magic)) {
        const bool is_png = bytes.starts_with(png_magic);
        const std::string_view world_file = is_png
                                                ? world_file_of(beside, {".pgw", ".pngw", ".wld"})
                                                : world_file_of(beside, {".jgw", ".jpgw", ".jpegw", ".wld"});
        if (world_file.empty()) {
            refuse_picture(
                file, "a picture without a place on the map",
                joined("a world file beside it (", is_png ? ".pgw" : ".jgw", " or .wld), or a GeoTIFF"),
                "export it with its place (QGIS: Export map as image, append georeference "
                "information)");
        }
        read.pixels = is_png ? read_png(bytes, file) : read_jpeg(bytes, file);
        read.frame = formats::frame_of_world_file(world_file, read.pixels.width, read.pixels.height, file);
    } else {
        refuse_picture(file, bytes.empty() ? "an empty file" : "a file that is no picture of these kinds",
                       "a GeoTIFF, or a PNG or JPEG with a world file", "export the picture again");
    }
    if (read.projection.empty()) {
        read.projection = std::string{config::trimmed(beside(".prj"))};
    }
    return read;
}

}  // namespace coupling::picture
