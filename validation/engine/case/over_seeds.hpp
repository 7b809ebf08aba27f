#pragma once

#include <functional>
#include <vector>

#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

/// The same comparison with several seeds: its figures are the means over them and have the standard
/// deviation between seeds (n - 1) beside them, what chance alone moves. A figure that is no number with one
/// seed has none with several. Notes, tables and charts are those of `first`; each of `more` reads the case
/// with a seed of its own when its turn comes, so that one at a time is in memory.
Comparison over_seeds(Comparison first, std::vector<std::function<Comparison()>> more);

}  // namespace coupling::validation
