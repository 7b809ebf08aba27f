#pragma once

#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/forest_site.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/regimes/regime.hpp"
#include "coupling/regimes/timber_value.hpp"

namespace coupling::decades {

/// The regimes that a run compares, and what timber is worth.
struct Management {
    std::vector<Regime> regimes;  ///< at least one, with different names
    PriceTable prices;
    std::vector<InputFile> inputs;
};

/// Reads the regimes that `regimes.list` names, shipped ones or files, and the prices. Throws
/// config::InputError with all that is wrong.
Management read_management(const Scenario& scenario, const ForestSite& forest, config::Warnings& warnings);

}  // namespace coupling::decades
