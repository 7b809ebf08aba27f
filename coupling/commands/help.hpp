#pragma once

#include <ostream>
#include <string>

namespace coupling {

/// The short help, or that of a command.
void write_help(std::ostream& out, const std::string& command);

/// The short help and every setting of a scenario with default, unit, range and meaning; of a section only
/// its settings. Throws config::InputError (settings) for a section that does not exist, with the nearest
/// one.
void write_help_all(std::ostream& out, std::string section);

/// Version of the program and of what it was built with.
void write_version(std::ostream& out);

}  // namespace coupling
