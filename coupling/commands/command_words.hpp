#pragma once

#include <map>
#include <string>
#include <vector>

namespace coupling {

/// The options that a command takes beside --help, --quiet and --verbose.
const std::map<std::string, std::vector<std::string>>& options_of_commands();

/// What the word after the command is.
const std::map<std::string, std::string>& arguments_of_commands();

}  // namespace coupling
