#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/program/line/command.hpp"

namespace coupling {

/// What the program is for, its commands and exit codes.
void write_short_help(const std::vector<Command>& commands, std::ostream& out);

/// All of `bannwald NAME --help`.
void write_help(const Command& command, std::ostream& out);

/// The help of all commands and every setting of a scenario with default, unit, range and meaning; of a
/// section only its settings. Throws config::InputError (settings) for a section that does not exist, with
/// the nearest one.
void write_help_all(const std::vector<Command>& commands, std::string section, std::ostream& out);

/// Version of the program and of what it was built with.
void write_version(std::ostream& out);

}  // namespace coupling
