#pragma once

#include <string>

namespace coupling {

/// The settings of section [trees].
struct TreeSettings {
    std::string file;           ///< CSV; empty: none
    std::string species;        ///< of all trees of a list without a column species; empty: it needs one
    std::string logs;           ///< CSV of lying logs; empty: none; without either bare slope only
    bool swap_xy = false;       ///< x_m and y_m of the tree list are exchanged
    bool swap_logs_xy = false;  ///< the same of the logs
};

}  // namespace coupling
