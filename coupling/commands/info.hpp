#pragma once

#include <ostream>
#include <string>

namespace coupling {

/// Tells what a grid or a table holds; prints a shipped table by its name. Throws InputError.
void write_info(const std::string& name, std::ostream& out);

}  // namespace coupling
