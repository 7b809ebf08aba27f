#pragma once

#include <string>

namespace coupling {

/// Version of the program, as in "0.1.0".
std::string version();

}  // namespace coupling
