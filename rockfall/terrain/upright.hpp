#pragma once

#include <cstdint>
#include <vector>

#include "rockfall/terrain/tin.hpp"

namespace rockfall {

/// Twice the area of a face as a vector along its normal [m2].
Eigen::Vector3d area2_of(const Tin& tin, const TinFace& face);

/// Whether a face stands upright within the tolerance, or overhangs within it.
bool is_upright(const Tin& tin, const TinFace& face);

/// Leans every wall, faces that stand upright and hang together at vertices, so that it can be seen from
/// above: its vertices move towards the ground behind it, by nothing at its foot and `upright_lean_m` at its
/// top, in proportion to their height between.
void lean_upright_faces(Tin& tin, TinChanges& changes);

}  // namespace rockfall
