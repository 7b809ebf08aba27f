#pragma once

#include <cstdint>
#include <string>

namespace coupling {

/// A file that a run read, with a hash of its bytes.
struct InputFile {
    std::string role;  ///< dem, surface, trees, ...
    std::string name;  ///< as results name it: see InputNames
    std::string hash;  ///< 16 hexadecimal digits
    std::uint64_t bytes = 0;
};

/// The role of the logo of pages, which is part of no fall.
inline constexpr const char* role_of_logo = "logo";

}  // namespace coupling
