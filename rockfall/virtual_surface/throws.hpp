#pragma once

#include <cstdint>

#include "config/units/angle.hpp"
#include "rockfall/virtual_surface/block_cover.hpp"

namespace rockfall {

/// How rocks are thrown at a virtual surface and when a hit stops them (Rammer et al. 2010, section 3.2.2).
struct ThrowLaw {
    config::Angle flattest = config::Angle::from_degrees(10.0);  ///< flight to the surface, uniform between
    config::Angle steepest = config::Angle::from_degrees(20.0);  ///< these two, within (0, 90) deg
    config::Angle central = config::Angle::from_degrees(25.0);   ///< a hit stops within this of the flight
    /// Goes on after a hit that does not stop, mirrored at the block, until it is clear of all blocks or
    /// stopped [choice: variant]. The paper's rule ends the throw there. Few are stopped later: most are
    /// thrown upward.
    bool goes_on_after_a_touch = false;
    double normal_kept = 0.5;  ///< share of the speed normal to the block that is kept then [-], [0, 1]
};

/// One throw: the centre of the rock begins above all blocks, over this point, and flies along +x.
struct ThrowStart {
    double x_m = 0.0;
    double y_m = 0.0;
    config::Angle below_horizon = config::Angle::from_degrees(15.0);
};

enum class ThrowEnd : std::uint8_t {
    passed,   ///< touched no block, or left the blocks behind
    touched,  ///< touched a block, but not centrally, which ended the throw
    stopped,  ///< hit a block centrally
};

/// Throws a rock: straight down to the height of its radius, mirrored there, straight up until it is clear of
/// all blocks. The first block it touches decides: within `law.central` of its flight it stops.
ThrowEnd throw_rock(const BlockCover& cover, double diameter_m, const ThrowStart& start, const ThrowLaw& law);

/// What became of many throws at one surface.
struct ThrowTally {
    std::uint64_t throws = 0;
    std::uint64_t touched = 0;  ///< ended at a block, centrally or not
    std::uint64_t stopped = 0;
    friend bool operator==(const ThrowTally&, const ThrowTally&) = default;
};

/// Throws rocks from random places; throw i draws the same place and angle for every cover and diameter.
ThrowTally throw_rocks(const BlockCover& cover, double diameter_m, const ThrowLaw& law, const SurfaceKey& key,
                       std::uint32_t throws);

/// What became of rocks that rolled over one surface.
struct RollTally {
    std::uint64_t rolls = 0;
    std::uint64_t stopped = 0;
    double length_m = 0.0;  ///< rolled until the first central hit, or to the end
    friend bool operator==(const RollTally&, const RollTally&) = default;
};

/// Way that a rolled rock is watched.
inline constexpr double watched_roll_m = 24.0;

/// Rolls rocks over the surface: centres at the height of their radius, level, along +x, from random places,
/// each until its first central hit or over `watched_roll_m`. Blocks that are touched but not centrally are
/// rolled over: a rolling rock always touches something. A block that it begins in touch with is behind it.
RollTally roll_rocks(const BlockCover& cover, double diameter_m, const ThrowLaw& law, const SurfaceKey& key,
                     std::uint32_t rolls);

}  // namespace rockfall
