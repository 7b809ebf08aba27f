#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "config/random/stream.hpp"
#include "config/units/angle.hpp"
#include "rockfall/laws/contact.hpp"

namespace rockfall::picus {

/// Roughness of the ground as facets, each tilted by an angle from N(0, deviation), cut at two deviations,
/// about any axis. A research option [choice].
///
/// A rock meets a facet with the probability of the area that it turns towards the rock: those that face it
/// more often (cos of the angle between path and facet normal, by that between facet and ground). Drawn by
/// rejection, at most `most_tries` times; then the even ground.
struct FacetLaw {
    config::Angle deviation;   ///< 0: none
    bool across_path = false;  ///< about the axis across the path alone, for falls in two dimensions
    static constexpr std::uint32_t most_tries = 64;

    [[nodiscard]] bool any() const { return deviation.in_radians() > 0.0; }
};

/// Unit normal of the facet that a rock meets at contact number `contact`. Requires facets, a unit normal and
/// a velocity into the ground.
Eigen::Vector3d facet_normal(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                             const FacetLaw& law, const config::RandomStream& draws, std::uint32_t contact);

/// A contact with a facet seen from the ground: a rock that would leave into the ground rolls along it
/// instead, and rolling goes along the ground. Energy never rises.
Contact on_ground(Contact contact, const Eigen::Vector3d& normal);

}  // namespace rockfall::picus
