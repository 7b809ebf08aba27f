#pragma once

#include <ostream>

#include "coupling/commands/command_line.hpp"

namespace coupling {

/// Holds the model against the cases named, or all of them: prints the tables and writes the results.
/// Returns the exit code: 5 if strict or default misses a criterion. Throws InputError with all problems of
/// all cases before any rock falls. Ctrl-C leaves nothing behind and gives 75.
int validate_cases(const CommandLine& line, std::ostream& out);

}  // namespace coupling
