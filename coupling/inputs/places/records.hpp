#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>

#include "rockfall/obstacles/log.hpp"
#include "rockfall/obstacles/stem.hpp"

namespace coupling {

/// A tree of the user's list.
struct TreeRecord {
    std::string id;
    std::string species;  ///< code in capitals, as the tables know it
    rockfall::Stem stem;
    bool has_derived_dbh = false;  ///< no diameter was measured
};

/// A lying log of the user's list.
struct LogRecord {
    std::string id;
    std::string species;
    rockfall::Log log;
};

/// A face of a mesh that lay below another one and is no part of the terrain.
struct LeftOutFace {
    std::string file;                            ///< as the scenario names it
    std::size_t number = 0;                      ///< in the file, from 1
    std::array<Eigen::Vector3d, 3> corners_m{};  ///< absolute
};

}  // namespace coupling
