#pragma once

#include <span>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// Of targets and nets that no rock reached on either slope, with the likely reason. `net_rows`, `work_rows`:
/// rock by rock, as the tables of nets and works have them.
void warn_of_unreached(const Site& site, const rockfall::EnsembleTally& tally,
                       std::span<const NetRow> net_rows, std::span<const NetRow> work_rows,
                       config::Warnings& warnings);

}  // namespace coupling
