#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The header of a PLY file: which elements with which properties follow, and how they are encoded.
namespace coupling::meshes::ply {

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
    std::string name;
    Type type = Type::float32;
    std::optional<Type> count_type;  ///< of a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding : std::uint8_t { ascii, little_endian, big_endian };

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
    std::size_t bytes = 0;  ///< up to the first value
    std::size_t lines = 0;
};

/// Reads the header. Throws config::InputError (data) naming line and word for one that cannot be read.
Header read_header(std::string_view bytes, const std::string& file);

}  // namespace coupling::meshes::ply
