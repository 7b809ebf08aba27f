#pragma once

#include <string>
#include <vector>

#include "coupling/program/line/command.hpp"

namespace coupling {

/// Carries out a call of the program and returns its exit code. Prints what went wrong on the standard
/// error. `arguments`: without the program's name.
int run_program(const std::vector<Command>& commands, const std::vector<std::string>& arguments);

}  // namespace coupling
