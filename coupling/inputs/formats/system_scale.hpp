#pragma once

#include <optional>
#include <string>

namespace coupling::formats {

/// Length on a map of a metre on the ground, at one place [-].
struct SystemScale {
    double longest = 1.0;   ///< in the direction in which the map is stretched most
    double shortest = 1.0;  ///< and least
};

/// The scale factors of a projected system in metres, given as well-known text, at coordinates of it: by
/// where PROJ finds four places around them on the ellipsoid. Nothing for other texts and systems, and where
/// PROJ cannot compute them.
///
/// PROJ's own proj_factors is not asked: of systems whose longitudes count in grads from Paris (Lambert II)
/// it gives factors of millions.
///
/// Only well-known text is read, no other definition of PROJ: text of a file may come here.
std::optional<SystemScale> system_scale(const std::string& text, double x_m, double y_m);

}  // namespace coupling::formats
