#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "rockfall/laws/rolling.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// How a rock moves along a groove.
struct GrooveLaw {
    double friction;                           ///< coefficient [-]
    double mass_factor = rolling_mass_factor;  ///< 5/7: rolls, 1: slides
    bool slides = false;
};

/// The way out of a groove: the run along the steepest edge of the mesh that falls away from a place.
///
/// Where two faces meet in a groove a rock rests on both, although each alone would let it go, and can only
/// move along the edge between them. The run begins at rest, follows the edge to its lower end with the
/// acceleration of rolling, 5/7 g (sin c - mu cos c) with c the dip of the edge (1 for 5/7 where it slides),
/// and leads into a triangle beyond that end. Choice; no published law.
///
/// Nothing if no edge within `reach_m` (the rock's radius) falls away more steeply than the friction angle,
/// itself and from the rock's place on: then the rock lies in a pit, or in a crack with a level floor. Edges
/// between faces of one plane (to 1e-9 m) are no grooves, as the mesh alone would choose the way; those that
/// meet at a vertex within reach are looked at all the same, and so is the border, over which a rock may
/// leave that has less than its radius to go. `end` of the piece is `edge`.
std::optional<RollingPiece> run_along_groove(const Terrain& terrain, std::uint32_t triangle,
                                             const Eigen::Vector3d& position_m, double reach_m,
                                             const GrooveLaw& law);

/// The run along the edge between two faces that press a rock into it; nothing if they do not.
///
/// `velocity_mps` lies in the face of `triangle`, which the rock has just entered from its neighbour `from`.
/// It is pressed where gravity leads to the edge on both faces and the rock would be back at it within
/// `shortest_rolling_piece_s`: it would go to and fro in ever smaller steps. The run is the limit of these:
/// the speed along the edge is kept, that across it is lost, friction is that of the two faces by turns. It
/// leads to the end of the edge (`end` is `edge`) or to a standstill; a rock without speed along the edge
/// sets off downwards if gravity along the edge exceeds friction, and else stays (a standstill in no time).
/// Choice; no published law.
std::optional<RollingPiece> run_if_pressed(const Terrain& terrain, std::uint32_t from, std::uint32_t triangle,
                                           const Eigen::Vector3d& position_m,
                                           const Eigen::Vector3d& velocity_mps, const GrooveLaw& law);

/// The part of a velocity along the edge in which two faces meet; that along the face if both lie in one
/// plane. Requires unit normals.
Eigen::Vector3d along_edge(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                           const Eigen::Vector3d& next_normal);

/// Whether a rock strikes the faces of a groove in turn and gets nowhere.
///
/// A rock that an impact turns may leave one face straight into the other, in no time. Twice in a row that is
/// an impact on both; the third time the groove leads on a rock that slides. One that rolls is thrown up by
/// the jump angle, or held by RestingPlace. Choice; no published law.
class StrikesInTurn {
public:
    /// Whether a flight of this time is one too many.
    bool once_more(double flight_s) {
        constexpr double no_time_s = 1e-9;
        constexpr int most_in_a_row = 2;
        if (flight_s >= no_time_s) {
            in_a_row_ = 0;
            return false;
        }
        if (in_a_row_ == most_in_a_row) {
            return true;
        }
        ++in_a_row_;
        return false;
    }

private:
    int in_a_row_ = 0;
};

}  // namespace rockfall
