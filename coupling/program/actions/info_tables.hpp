#pragma once

#include <ostream>
#include <string>

namespace coupling {

/// Lists the tables that runs write, or the columns of one with unit, meaning and source. `table` with or
/// without its ending; empty: the list. Throws InputError (settings) for a table that no run writes.
void write_result_tables(const std::string& table, std::ostream& out);

}  // namespace coupling
