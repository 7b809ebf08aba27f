#pragma once

#include <string>

namespace coupling {

/// The settings of section [targets].
struct TargetSettings {
    std::string file;  ///< CSV with WKT lines and polygons: target_id, name, wkt
};

}  // namespace coupling
