#pragma once

#include <tiffio.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

namespace coupling::formats {

/// Bytes of a file that are read where they are wanted: place, where to put them, how many.
using ReadAt = std::function<void(std::uint64_t, char*, std::size_t)>;

/// The bytes of a TIFF and the place that libtiff reads at.
struct TiffBytes {
    explicit TiffBytes(std::string_view all) : bytes{all}, size{all.size()} {}
    /// Bytes that stay on the disk.
    TiffBytes(std::uint64_t size_in, ReadAt read_at_in) : size{size_in}, read_at{std::move(read_at_in)} {}

    std::string_view bytes{};  ///< in memory; none where there is `read_at`
    std::uint64_t size = 0;
    ReadAt read_at{};
    std::uint64_t at = 0;
    bool wanted_beyond = false;    ///< the library asked for bytes behind the last one: the file is cut off
    std::exception_ptr failure{};  ///< what `read_at` threw: nothing may be thrown through the library
};

/// Opens the bytes, which must outlive the result, for reading; nothing comes back where the first directory
/// cannot be read. Messages of the library are dropped: each fault shows itself in what is read.
std::unique_ptr<TIFF, void (*)(TIFF*)> open_tiff(TiffBytes& source);

}  // namespace coupling::formats
