#pragma once

#include <ostream>
#include <string>

namespace coupling {

/// Tells what a grid or a table holds; prints a shipped table by its name. The name `tables` lists the tables
/// of results, and with one of them its columns. Throws InputError.
void write_info(const std::string& name, const std::string& table, std::ostream& out);

}  // namespace coupling
