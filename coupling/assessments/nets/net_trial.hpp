#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// What is asked of `bannwald net try`.
struct NetTryRequest {
    std::filesystem::path run;   ///< folder of a finished run
    std::filesystem::path nets;  ///< table of nets
    std::filesystem::path out;   ///< empty: run/net_try
    bool overwrite = false;
    bool quiet = false;
};

/// Looks at other nets with the stored paths of a run and writes their tables. Throws InputError.
void try_nets(const NetTryRequest& request, std::ostream& out);
/// net_inexact.csv, and with those of a run with nets all that it writes.
TableLayout net_inexact_layout();
std::vector<TableLayout> net_try_layouts();

}  // namespace coupling
