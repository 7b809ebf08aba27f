#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// Names of the regimes that come with the program, in alphabetical order: the files of
/// coupling/exchange/regimes/data.
std::vector<std::string> shipped_regime_names();

/// The text of a shipped regime, such as "pfm1", as it stood when the program was built; empty for a name
/// that is not shipped.
std::string_view shipped_regime(std::string_view name);

}  // namespace coupling
