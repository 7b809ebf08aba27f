#pragma once

#include <cstddef>
#include <string>

namespace coupling::decades {

/// "#rrggbb": the plain colour of a species' fill on light ground; `species` is its place in the table.
std::string colour_of_species(std::size_t species);

}  // namespace coupling::decades
