#pragma once

#include <ostream>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling::report {

/// The results as one self-contained HTML page: no outside address, same bytes from the same results. Without
/// scripts all but the view in three dimensions stays.
void write_page(std::ostream& out, const RunResults& results, const Figures& figures,
                const std::vector<WrittenFile>& files);

}  // namespace coupling::report
