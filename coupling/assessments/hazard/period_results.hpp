#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/results/figures/departures.hpp"

namespace coupling::hazard {

/// What the results of a return period say, which may be those of an earlier call.
struct ResultsOfPeriod {
    std::array<Departures, rockfall::covers> departures;  ///< by cover; no rocks where there is no forest
    std::vector<std::string> warnings;
};

/// From the summary.json of a finished return period. Throws config::InputError (file, data).
ResultsOfPeriod results_in(const std::filesystem::path& folder);

/// Warnings that the inputs alone do not give come from the results: they speak of the answer.
void add_unknown(const std::vector<std::string>& sentences, config::Warnings& warnings);

}  // namespace coupling::hazard
