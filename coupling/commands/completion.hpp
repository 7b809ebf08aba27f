#pragma once

#include <ostream>
#include <string>

namespace coupling {

/// Prints the script that lets a shell complete commands, options, examples, settings and files. Throws
/// InputError (settings) for a shell that is not "bash".
void write_completion(const std::string& shell, std::ostream& out);

}  // namespace coupling
