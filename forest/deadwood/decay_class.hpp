#pragma once

#include <array>
#include <cstddef>

namespace forest {

inline constexpr std::size_t decay_class_count = 5;

/// Wood density of the decay classes 1 (fresh) to 5 (soft through and through) relative to sound wood [-]
/// [choice; near the factors of Waddell 2002 for conifers].
inline constexpr std::array<double, decay_class_count> density_of_decay_class{1.0, 0.84, 0.6, 0.4, 0.2};

/// Decay class of a piece, 1 to 5: the one whose density is nearest, of two equally near the fresher one.
int decay_class_of(double density_share);

}  // namespace forest
