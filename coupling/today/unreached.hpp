#pragma once

#include <span>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {

/// Warns of targets that no rock of either slope reached, and of nets: nothing is said of them that any rock
/// showed. Where that is all targets the answer itself is in question.
void warn_of_unreached(const Site& site, const rockfall::EnsembleTally& total, std::span<const NetRow> nets,
                       config::Warnings& warnings);

}  // namespace coupling
