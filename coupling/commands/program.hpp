#pragma once

#include <string>
#include <vector>

namespace coupling {

/// The program: understands its arguments, carries them out, says what went wrong. Returns the exit code.
int run_program(const std::vector<std::string>& arguments);

}  // namespace coupling
