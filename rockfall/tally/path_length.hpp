#pragma once

#include "rockfall/laws/flight.hpp"

namespace rockfall {

/// Length of the path of a flight from its start until a time >= 0 [m]: the arc of its parabola, in closed
/// form.
///
/// With h the speed in plan, w0 and w1 the rising speeds and s0 and s1 the speeds at both ends,
/// u = g t / (s0 + s1):
///
///     L = t / 2 * ((s0 + s1) / 2 + (w0 + w1)^2 / (2 (s0 + s1)) + 2 h^2 / (s0 + s1) * atanh(u) / u)
///
/// the integral of sqrt(h^2 + w^2) over w, divided by g, written without differences of nearly equal numbers:
/// straight, vertical and very short flights lose no digits. Relative error below 1e-12.
double path_length_m(const Flight& flight, double until_s);

}  // namespace rockfall
