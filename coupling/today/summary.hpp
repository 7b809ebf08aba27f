#pragma once

#include <ostream>
#include <vector>

#include "coupling/results/figures.hpp"
#include "coupling/results/out_file.hpp"
#include "coupling/results/run_results.hpp"

namespace coupling {

/// All figures, settings, input hashes and warnings of a run as JSON. Holds no times and no dates: the same
/// scenario gives the same bytes.
void write_summary(std::ostream& out, const RunResults& results, const Figures& figures,
                   const std::vector<WrittenFile>& files);

}  // namespace coupling
