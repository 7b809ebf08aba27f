#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/program/line/command.hpp"

namespace coupling {

/// A script for a shell that completes commands, their options and what follows these. Throws InputError
/// (settings) for a shell other than bash.
void write_completion(const std::vector<Command>& commands, const std::string& shell, std::ostream& out);

}  // namespace coupling
