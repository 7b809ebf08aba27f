#pragma once

#include <ostream>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling {

/// All figures, settings, input hashes and warnings of a run as JSON. Holds no times and no dates: the same
/// scenario gives the same bytes.
void write_summary(std::ostream& out, const RunResults& results, const Figures& figures,
                   const std::vector<WrittenFile>& files);

}  // namespace coupling
