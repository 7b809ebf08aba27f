#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "config/table/schema.hpp"

namespace coupling {

/// The tables that users hand over, as their readers declare them; two of one role are two ways to write it.
std::vector<const config::TableSchema*> input_tables();

/// The columns of all tables as Markdown, or of the tables of one role or setting ("trees", "trees.file").
/// Throws InputError (settings) with the nearest name for another one.
void write_input_tables(const std::string& table, std::ostream& out);

}  // namespace coupling
