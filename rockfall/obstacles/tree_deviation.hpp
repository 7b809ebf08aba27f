#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"

namespace rockfall {

/// How squarely a rock meets a stem.
enum class HitType : std::uint8_t { frontal, lateral, scratch };
inline constexpr std::size_t hit_types = 3;

/// How often a hit of each type turns the path into each class of angles (Dorren et al. 2005).
struct DeviationMatrix {
    /// Limits of the three classes: class k lies between limit k and k + 1.
    std::array<config::Angle, 4> limits{};
    /// Shares by hit type and class; each row sums to 1 [-].
    std::array<std::array<double, 3>, hit_types> shares{};
};

/// The angle by which a hit turns the path, without regard to energies: `class_draw` and `angle_draw` on
/// [0, 1) choose the class and the angle within it.
config::Angle drawn_deviation(HitType type, const DeviationMatrix& matrix, double class_draw,
                              double angle_draw);

/// A turn, cut off at the largest that the stem can bring about: asin(sqrt(E_available / E)).
///
/// A plastic contact that turns the path by d takes E sin^2 d (derived, no published formula). Even a scratch
/// turns the path a little: 2 % of the stem's strength are always available for that.
config::SinCos limited_turn(config::SinCos turn, double available_j, double strength_j, double energy_j);

}  // namespace rockfall
