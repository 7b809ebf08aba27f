#pragma once

#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/exchange/regimes/regime.hpp"
#include "coupling/exchange/regimes/timber_value.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/forest/nais_input.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// The regimes that a run compares, and what timber is worth.
struct Management {
    std::vector<Regime> regimes;  ///< at least one, with different names
    PriceTable prices;
    std::vector<NaisRow> target_profile;   ///< the user's, else the shipped one for the size of the rocks
    std::vector<InputFile> inputs;         ///< of all of it
    std::vector<std::string> read_for;     ///< by regime: the name of a shipped one, else hashes of its files
    std::vector<InputFile> shared_inputs;  ///< those of no regime
};

/// Reads the regimes that `regimes.list` names, shipped ones or files, the prices and the target profile.
/// `mean_block_m`: mean diameter of the rocks, 0 without rocks. Throws config::InputError with all that is
/// wrong.
Management read_management(const Scenario& scenario, const ForestSite& forest, config::Warnings& warnings,
                           double mean_block_m = 0.0);
/// Mean diameter of the rocks; 0 without sources.
double mean_block_m(const Scenario& scenario, const Site& site);

}  // namespace coupling::decades
