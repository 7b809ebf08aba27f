#pragma once

namespace config {

/// Standard gravity as the rockfall papers use it (Rammer et al. 2010).
inline constexpr double gravity_mps2 = 9.81;

}  // namespace config
