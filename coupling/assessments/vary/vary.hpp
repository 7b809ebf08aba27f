#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/run/short_run.hpp"

namespace coupling::vary {

/// What `bannwald vary` is asked for.
struct VaryRequest {
    std::filesystem::path scenario;
    std::filesystem::path factors;       ///< CSV: setting, values, how
    std::vector<std::string> overrides;  ///< of all runs
    std::filesystem::path out;
    int threads = 0;  ///< 0: as many as the machine has
    bool overwrite = false;
    bool quiet = false;
};

/// What summary.json says of a study of so many runs.
ShortSummary summary_of(const VaryRequest& request, const Scenario& scenario, std::size_t runs);

/// A scenario over years is a study of its regimes (regime_study.hpp).
///
/// Lets the rocks of a scenario of today fall with each combination of settings: the same rocks, as far as
/// the settings leave them the same. Writes vary.csv and report.html (tornado chart), prints an overview.
///
/// Returns the exit code: done, or interrupted, which leaves nothing behind. Throws config::InputError for
/// what is wrong in the table or in any combination, before any rock falls.
int vary_scenario(const VaryRequest& request, std::ostream& screen);

}  // namespace coupling::vary
