#include "coupling/results/report/map/jpeg.hpp"

#include <jpeglib.h>

#include <cstdio>
#include <cstdlib>

#include "config/text/base64.hpp"
#include "config/text/joined.hpp"

namespace coupling::report {
namespace {

/// A picture and memory are all that is needed, so the library can fail by our fault alone.
[[noreturn]] void refuse_to_pack(j_common_ptr) {
    std::abort();
}

}  // namespace

std::string jpeg(const picture::Pixels& pixels, int quality) {
    jpeg_error_mgr errors{};
    jpeg_compress_struct packed{};
    packed.err = jpeg_std_error(&errors);
    errors.error_exit = refuse_to_pack;
    jpeg_create_compress(&packed);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&packed, &bytes, &size);
    packed.image_width = pixels.width;
    packed.image_height = pixels.height;
    packed.input_components = 3;
    packed.in_color_space = JCS_RGB;
    jpeg_set_defaults(&packed);
    packed.dct_method = JDCT_ISLOW;  // whole numbers: the same on every machine
    jpeg_set_quality(&packed, quality, TRUE);
    jpeg_start_compress(&packed, TRUE);
    while (packed.next_scanline < packed.image_height) {
        // The library takes the rows as they are and only reads them.
        auto* row = const_cast<unsigned char*>(pixels.rgb.data() +
                                               std::size_t{3} * pixels.width * packed.next_scanline);
        jpeg_write_scanlines(&packed, &row, 1);
    }
    jpeg_finish_compress(&packed);
    jpeg_destroy_compress(&packed);
    std::string file{reinterpret_cast<const char*>(bytes), size};
    std::free(bytes);
    return file;
}

std::string jpeg_of_at_most(const picture::Pixels& pixels, std::size_t most_bytes) {
    std::string file;
    for (const int quality : {85, 75, 65, 50, 35, 20, 10}) {
        file = jpeg(pixels, quality);
        if (file.size() <= most_bytes) {
            break;
        }
    }
    return file;
}

std::string jpeg_address(std::string_view jpeg_bytes) {
    return config::joined("data:image/jpeg;base64,", config::base64(jpeg_bytes));
}

}  // namespace coupling::report
