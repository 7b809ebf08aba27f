#pragma once

#include <cstddef>
#include <cstdint>

namespace forest {

/// Position of a species in the table in use.
enum class SpeciesId : std::uint16_t {};

/// The position as an index into arrays by species.
constexpr std::size_t index_of(SpeciesId species) {
    return static_cast<std::size_t>(species);
}

}  // namespace forest
