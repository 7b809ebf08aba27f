#pragma once

#include <ostream>
#include <vector>

#include "coupling/assessments/nets/siting/siting.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling::siting {

/// The page: where works are needed and which, a map, what comes to each line against the position along it,
/// the candidates, how they were found, and the files beside it. Head and language are those of the run.
void write_siting_page(std::ostream& out, const SitingResults& results, const rockfall::Terrain& terrain,
                       const ReportSettings& head, const std::vector<WrittenFile>& files);

}  // namespace coupling::siting
