#pragma once

namespace forest {

/// Growth at a light ratio relative to full light [0, 1], between the two curves of gap models (Bugmann
/// 1994):
///     tolerant   g1 = 1 - exp(-4.64 (L - 0.05))
///     intolerant g9 = 2.24 (1 - exp(-1.136 (L - 0.08)))
/// straight in the response class from 1 (tolerant) to 9.
double light_response(double response_class, double light_ratio);

}  // namespace forest
