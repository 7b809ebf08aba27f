#pragma once

#include <cstddef>
#include <string>

namespace coupling::report {

/// The name of a class of energy (colours.hpp) in the language of the page: "30 to 100 kJ".
const std::string& energy_class_name(std::size_t energy_class);

}  // namespace coupling::report
