#pragma once

#include <cstdint>
#include <filesystem>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

struct Scenario;

/// Lets the rocks of a site fall with and without its forest and writes the results into `out`. Ranks and
/// shards share them piece by piece; a shard ends with its pieces.
///
/// Returns 0, or 75 if the user interrupted it: finished parts stay and the next call goes on from them.
/// Throws config::InputError; then no new output folder is left.
int assess_today(const RunRequest& request, const Scenario& scenario, const Site& site,
                 config::Warnings& warnings, const std::filesystem::path& out, RankGroup& ranks);
/// The same without other ranks.
int assess_today(const RunRequest& request, const Scenario& scenario, const Site& site,
                 config::Warnings& warnings, const std::filesystem::path& out);

}  // namespace coupling
