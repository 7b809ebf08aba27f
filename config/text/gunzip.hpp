#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace config {

/// Whether bytes begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// The most bytes that a packed text may unpack to where its beginning says nothing else: 512 MiB [choice].
/// Packed text is held in memory, while a file that is not packed is mapped and has no such bound.
inline constexpr std::uint64_t most_unpacked_bytes = std::uint64_t{512} << 20U;

/// The most bytes that a packed file may unpack to, from the first part of its content (64 KiB, or all of a
/// shorter one).
using UnpackedBound = std::function<std::uint64_t(std::string_view beginning)>;

/// The unpacked bytes of a gzip file, all its members one after the other. Takes no more memory than the
/// bound and 64 KiB. Throws InputError: (file) for a file that is cut off, broken or not gzip, (data) for one
/// that holds more than the bound.
std::string gunzip(
    std::string_view bytes, const std::string& file,
    const UnpackedBound& most_bytes = [](std::string_view) { return most_unpacked_bytes; });

}  // namespace config
