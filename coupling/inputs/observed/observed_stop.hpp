#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

namespace coupling {

/// Where a rock was seen to come to rest, in the coordinates of the input files.
struct ObservedStop {
    Eigen::Vector2d end_m = Eigen::Vector2d::Zero();
    std::optional<Eigen::Vector2d> start_m;  ///< where it was released, if known
    std::optional<std::uint32_t> zone;       ///< release zone that it came from; none: any
    std::string group;                       ///< such as the block; "" without
};

}  // namespace coupling
