#pragma once

#include <string>
#include <string_view>

namespace config {

/// Whether bytes begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// The unpacked bytes of a gzip file, all its members one after the other.
/// Throws InputError (file) for a file that is cut off, broken or not gzip.
std::string gunzip(std::string_view bytes, const std::string& file);

}  // namespace config
