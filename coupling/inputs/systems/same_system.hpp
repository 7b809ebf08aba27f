#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "coupling/inputs/systems/coordinate_systems.hpp"

namespace coupling::plausible {

/// How the coordinate systems of two files compare.
enum class Sameness : std::uint8_t {
    same,
    nearly,   ///< on datums that differ by less than a metre, such as ETRS89 and WGS 84
    other,    ///< another projection, unit or figure of the earth
    unknown,  ///< one of them cannot be read
    silent    ///< one of them names none
};

/// Compares two texts of any version of well-known text, by codes of EPSG where both have one, else by what
/// decides where a coordinate lies: meridian, origin, scale, unit, figure of the earth.
Sameness compare_systems(std::string_view one, std::string_view two);

/// The code of EPSG of a system: that of the text, or of the known system with its parameters.
std::optional<int> code_of_system(std::string_view text);

/// "'MGI / Austria Lambert' (EPSG 31287)".
std::string name_of_system(std::string_view text);

}  // namespace coupling::plausible
