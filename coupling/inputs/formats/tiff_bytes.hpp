#pragma once

#include <tiffio.h>

#include <cstdint>
#include <memory>
#include <string_view>

namespace coupling::formats {

/// The bytes of a TIFF and the place that libtiff reads at.
struct TiffBytes {
    std::string_view bytes;
    std::uint64_t at = 0;
    bool wanted_beyond = false;  ///< the library asked for bytes behind the last one: the file is cut off
};

/// Opens the bytes, which must outlive the result, for reading; nothing comes back where the first directory
/// cannot be read. Messages of the library are dropped: each fault shows itself in what is read.
std::unique_ptr<TIFF, void (*)(TIFF*)> open_tiff(TiffBytes& source);

}  // namespace coupling::formats
