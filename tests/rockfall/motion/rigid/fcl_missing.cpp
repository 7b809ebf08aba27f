// In the place of fcl_oracle.cpp where FCL or libccd are not installed.

#include "tests/rockfall/motion/rigid/fcl_oracle.hpp"

namespace rockfall::testing {

std::optional<double> fcl_distance_m(const solids::Hull&, const solids::GroundTriangle&) {
    return std::nullopt;
}

std::optional<double> fcl_depth_m(const solids::Hull&, const solids::Hull&) {
    return std::nullopt;
}

}  // namespace rockfall::testing
