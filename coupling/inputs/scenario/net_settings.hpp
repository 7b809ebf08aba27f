#pragma once

#include <string>

namespace coupling {

/// The settings of section [nets].
struct NetSettings {
    std::string file;            ///< CSV of nets; empty: none
    double wanted_share = 0.95;  ///< of energy and rocks that nets should keep from a line [-]
    bool keep_paths = false;     ///< paths of all rocks without nets go into net_paths.bin
};

/// The settings of section [works].
struct WorkSettings {
    std::string file;  ///< dams, ditches, walls and galleries; empty: none
};

}  // namespace coupling
