#pragma once

#include <filesystem>
#include <ostream>

#include "coupling/inputs/own_files/own_rows.hpp"

namespace coupling {

/// A table of this program (commas, decimal points) as Excel opens it by a double click: byte-order mark,
/// semicolons, numbers with the given decimal sign. Names and identifiers stay as they are
/// (geopackage::is_key), and so do texts that hold numbers, such as WKT. This program reads both forms.
void write_excel_csv(std::ostream& out, OwnRows& table, char decimal_sign);

/// Rewrites all tables of a folder in that form; none where there is no such folder. A file that is linked to
/// another name keeps its bytes under that one. Throws config::InputError (file).
void turn_into_excel_csv(const std::filesystem::path& folder, char decimal_sign);

}  // namespace coupling
