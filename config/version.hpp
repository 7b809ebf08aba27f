#pragma once

#include <string>

namespace config {

/// Version of the program, as in "0.1.0".
std::string version();

/// Commit that the program was built from, as `git describe` names it; empty outside of a repository.
std::string commit();

}  // namespace config
