#pragma once

#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/report/page_head.hpp"

namespace coupling {

/// What `bannwald net try` found.
struct NetTrial {
    std::span<const NetRecord> nets;
    std::span<const NetFigures> figures;  ///< slope by slope
    const std::vector<std::string>& remarks;
};

/// Its page: what each net holds, and maps on which the nets can be moved.
void write_net_trial_page(std::ostream& out, const NetTrial& trial, NetPathsReader& paths,
                          const ReportSettings& head, const std::vector<WrittenFile>& files);

}  // namespace coupling
