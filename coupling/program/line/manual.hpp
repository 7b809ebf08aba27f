#pragma once

#include <ostream>
#include <vector>

#include "coupling/program/line/command.hpp"

namespace coupling {

/// The manual page in the language of `man`: what the help of the program and of each command says.
void write_man_page(const std::vector<Command>& commands, std::ostream& out);

}  // namespace coupling
