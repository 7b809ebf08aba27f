#pragma once

#include "rockfall/terrain/tin.hpp"

namespace rockfall {

/// Vertices at one place become one, and faces that keep fewer than three go.
void join_vertices(Tin& tin, TinChanges& changes);

/// Takes out vertices that no face has.
void drop_unused_vertices(Tin& tin);

/// Faces that all look down are a terrain seen from below: the sense of their corners is turned around.
void turn_over_if_all_look_down(Tin& tin, TinChanges& changes);

}  // namespace rockfall
