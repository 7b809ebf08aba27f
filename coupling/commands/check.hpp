#pragma once

#include <ostream>

#include "config/errors/warnings.hpp"
#include "coupling/commands/command_line.hpp"

namespace coupling {

/// Reads everything that a scenario names and says what the run will be. Throws InputError with all
/// problems. What is doubtful is in `warnings` even then.
void check_scenario(const CommandLine& line, config::Warnings& warnings, std::ostream& out);

}  // namespace coupling
