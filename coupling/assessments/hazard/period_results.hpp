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
    std::vector<std::string>
        other_page_settings;  ///< "report.language": its page was written with another one
};

/// From the summary.json of a finished return period. Throws config::InputError (file, data).
ResultsOfPeriod results_in(const std::filesystem::path& folder, const Scenario& scenario);

/// Says of settings that change no fall: the page of a finished return period does not follow them.
void warn_of_page(const ResultsOfPeriod& results, config::Warnings& warnings);

/// Warnings that the inputs alone do not give come from the results: they speak of the answer.
void add_unknown(const std::vector<std::string>& sentences, config::Warnings& warnings);

}  // namespace coupling::hazard
