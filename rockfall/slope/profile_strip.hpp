#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/slope/slope.hpp"
#include "rockfall/terrain/contact_zone.hpp"

namespace rockfall {

/// A corner of a profile; its ground reaches to the next corner.
struct ProfilePoint {
    double distance_m;  ///< in plan, along the profile
    double height_m;
    std::uint8_t surface;  ///< place in the list of ground types
};

/// Ground types along a profile are kept on cells of this width: their borders are that exact.
inline constexpr double profile_surface_cell_m = 0.05;

/// The slope of which a profile is every cross-section: a strip along x = distance, y in [-10 m, 10 m].
///
/// A rock that starts at y = 0 and is never turned sideways stays there, bit for bit, so the two-dimensional
/// mode needs no code of its own (Rammer et al. 2010, section 2.2). Requires at least two points whose
/// distances rise strictly, and surfaces below types.size().
Slope strip_slope(std::span<const ProfilePoint> profile, std::vector<SurfaceType> types);

/// The profile that a rock of finite size feels: contact_zone() of the strip, on points at most 1 m apart.
/// Corners are where somebody saw a change of slope, so no noise is looked for in them; in a profile of at
/// least 30 equal steps it is. A radius of 0 returns the profile as it is.
std::vector<ProfilePoint> contact_zone(std::span<const ProfilePoint> profile, const ContactLaw& law);

}  // namespace rockfall
