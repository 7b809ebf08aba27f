#pragma once

#include <string>
#include <string_view>

namespace config {

/// Texts of any kind one after the other: one allocation however many there are.
template <class... Parts>
std::string joined(const Parts&... parts) {
    std::string text;
    text.reserve((std::string_view{parts}.size() + ...));
    (text.append(std::string_view{parts}), ...);
    return text;
}

}  // namespace config
