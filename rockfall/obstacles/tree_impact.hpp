#pragma once

#include <array>
#include <cstdint>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "config/units/angle.hpp"
#include "rockfall/obstacles/stem_index.hpp"

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

/// What happens at a stem beside its strength.
struct TreeImpactLaw {
    double frontal_limit = 0.40;   ///< hits more central than this are frontal [-]
    double scratch_limit = 0.746;  ///< hits further out scratch: the sigmoid is zero there [-]
    bool taper = true;             ///< stem radius by height of the hit; off: DBH everywhere
    bool height_effect = true;     ///< a hit above breast height meets the thinner stem there
    bool remove_broken = false;    ///< a broken tree or log is no longer in the way of the rocks that follow
    double stop_share = 0.02;      ///< a rock left with less of its energy stays at the tree [-]
    DeviationMatrix deviation;
};

/// Share of a stem's energy that a hit can use, by relative hit position e (0 central, 1 edge) [-].
///
/// Sigmoid of Dorren & Berger (2006) in the form of the Rockyfor3D manual; 0.98 at the centre, zero from
/// 0.746.
inline double usable_share(double relative_position) {
    constexpr double log2_of_10 = 3.321928094887362;
    const double power = config::exp2_of(log2_of_10 * (relative_position - 0.58) * 8.007);
    const double share = -0.046 + (0.98 + 0.046) / (1.0 + power);
    return share > 0.0 ? share : 0.0;
}

HitType hit_type(double relative_position, const TreeImpactLaw& law);

/// What a hit does to rock and tree.
struct TreeImpact {
    HitType type;
    double loss_j;        ///< energy taken by the tree
    double speed_factor;  ///< speed and spin after the hit divided by those before [-]
    config::SinCos turn;  ///< deviation in plan, counter-clockwise
    bool broken;
    bool stopped;
};

/// The hit of a rock of kinetic energy `energy_j` (translation and rotation) on a stem.
///
/// The tree takes what its position and height on the stem allow; a frontal hit beyond the stem's strength
/// breaks it (Rammer et al. 2010). The path turns away from the axis by an angle from the matrix, at most by
/// asin(sqrt(E_available / E)): a plastic contact that turns the path by d takes E sin^2 d (derived, no
/// published formula). `draws`: class, angle within it, side of an exactly central hit.
TreeImpact meet_stem(double energy_j, const StemHit& hit, const PlacedStem& stem, const TreeImpactLaw& law,
                     const config::FourUniforms& draws);

}  // namespace rockfall
