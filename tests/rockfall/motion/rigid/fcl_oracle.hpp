#pragma once

#include <optional>

#include "rockfall/solids/ground_contact.hpp"
#include "rockfall/solids/hull.hpp"

namespace rockfall::testing {

// Distances by FCL with libccd (Pan, Chitta & Manocha 2012, ICRA). Nothing where the tests were built without
// these libraries.

/// Distance of a hull from a triangle; 0 or less where they meet [m].
std::optional<double> fcl_distance_m(const solids::Hull& hull, const solids::GroundTriangle& triangle);

/// How far one of two overlapping hulls has to be moved to part them; 0 where they do not meet [m].
std::optional<double> fcl_depth_m(const solids::Hull& one, const solids::Hull& other);

}  // namespace rockfall::testing
