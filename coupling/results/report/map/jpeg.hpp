#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "coupling/inputs/picture/picture_file.hpp"

namespace coupling::report {

/// The bytes of a JPEG file (ITU-T T.81, baseline) in a quality of 1 to 100. The same picture gives the same
/// bytes.
std::string jpeg(const picture::Pixels& pixels, int quality);

/// A picture in the best of a few qualities in which it takes at most so many bytes; in the lowest of them
/// where none is enough.
std::string jpeg_of_at_most(const picture::Pixels& pixels, std::size_t most_bytes);

/// "data:image/jpeg;base64,...".
std::string jpeg_address(std::string_view jpeg_bytes);

}  // namespace coupling::report
