#pragma once

#include <string>
#include <vector>

#include "coupling/program/line/command.hpp"

namespace coupling {

Command init_command();
Command check_command();
Command run_command();
Command merge_command();
Command calibrate_command();
Command vary_command();
Command compare_command();
Command collapse_command();
Command pack_command();
Command verify_command();
Command net_command();
Command at_command();
Command models_command();
Command stopping_table_command();
Command info_command();
Command completion_command();

/// All of them, in the order of the help.
std::vector<Command> commands_of_the_program();

}  // namespace coupling
