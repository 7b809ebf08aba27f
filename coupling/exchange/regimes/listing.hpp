#pragma once

#include <ostream>

namespace coupling {

/// For people: the regimes that come with the program, and all columns of a regime with what they mean, who
/// uses them and their defaults.
void write_regime_listing(std::ostream& out);

}  // namespace coupling
