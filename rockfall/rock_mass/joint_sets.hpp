#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/random/stream.hpp"
#include "rockfall/rock_mass/bond.hpp"
#include "rockfall/rock_mass/convex_cell.hpp"

namespace rockfall::rock_mass {

/// How distances between neighbouring joints of a set are distributed.
enum class SpacingLaw : std::uint8_t {
    constant,     ///< all equal
    uniform,      ///< mean - deviation sqrt(3) to mean + deviation sqrt(3)
    exponential,  ///< joints at random places (Priest & Hudson 1976, Int. J. Rock Mech. Min. Sci. 13:135)
    lognormal,    ///< of the given mean and deviation
};

/// A set of parallel joints.
struct JointSet {
    std::string name;
    double dip_deg = 0.0;            ///< steepest angle below the horizon [0, 90]
    double dip_direction_deg = 0.0;  ///< azimuth of the dip, clockwise from north [0, 360)
    double spacing_m = 0.0;          ///< mean distance of neighbours along the normal, > 0
    SpacingLaw law = SpacingLaw::constant;
    double spacing_deviation_m = 0.0;
    double persistence = 1.0;  ///< share of the joints' area that is open [0, 1]
    BondStrength strength;     ///< of the rock bridges: what is not open

    /// Upward unit normal of the joints.
    [[nodiscard]] Eigen::Vector3d normal() const;
};

/// Where the joints of a set cut a line along its normal, ascending, from below `low_m` to above `high_m`.
std::vector<double> joint_places(const JointSet& set, double low_m, double high_m,
                                 config::RandomStream& draws);

/// Cuts a convex body by all joints of all sets. Faces are made by the number of their set, faces of the body
/// keep what made them. A cut that would leave a piece smaller than `least_size_m` (size_m of
/// convex_cell.hpp) on either side is not made: slivers stay with the block they belong to.
std::vector<ConvexCell> cut_by_joints(const ConvexCell& body, std::span<const JointSet> sets,
                                      double least_size_m, std::uint64_t seed);

/// How many pieces joint sets cut a large body into: that is how often three joints of different sets meet in
/// it, V |n_i . n_j x n_k| / (s_i s_j s_k) summed over all triples, as each such point is the lowest one of
/// one piece. No more than cubes of the least size have room for.
double expected_pieces(double volume_m3, std::span<const JointSet> sets, double least_size_m);

}  // namespace rockfall::rock_mass
