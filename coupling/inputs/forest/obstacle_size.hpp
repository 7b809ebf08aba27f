#pragma once

namespace coupling {

/// Thinner trees of a forest that is grown or derived are no obstacles: rocks bend them [choice; Rockyfor3D
/// takes the same limit].
inline constexpr double least_obstacle_cm = 5.0;

}  // namespace coupling
