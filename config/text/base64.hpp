#pragma once

#include <string>
#include <string_view>

namespace config {

/// Base64 of any bytes (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace config
