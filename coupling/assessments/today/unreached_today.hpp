#pragma once

#include <span>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// Of targets and nets that no rock reached on either slope, with the likely reason.
void warn_of_unreached(const Site& site, const rockfall::EnsembleTally& tally,
                       std::span<const NetRow> net_rows, config::Warnings& warnings);

}  // namespace coupling
