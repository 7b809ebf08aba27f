#pragma once

namespace config {

/// Standard gravity as the rockfall papers use it (Rammer et al. 2010).
inline constexpr double gravity_mps2 = 9.81;

/// Where diameters of trees are measured (DBH), above the ground.
inline constexpr double breast_height_m = 1.3;

/// Energies are joules inside and kilojoules in what people read.
inline constexpr double j_per_kj = 1000.0;

/// Shares are fractions inside and per cent in what people read.
inline constexpr double percent = 100.0;

}  // namespace config
